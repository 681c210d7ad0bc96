// `af2 mesh` for planar domains.
#include "cli/meshing/model_runs.h"
#include "geometry/base/file_extension.h"
#include "geometry/planar/in2d_file.h"
#include "geometry/planar/mesh_planar.h"

namespace af2::cli {

geometry::ModelMesh runPlanar(const MeshRequest& request, const AF2Algorithm& algorithm,
                              const RunControl& control) {
  Stopwatch reading;
  const bool hasCurves = geometry::extensionOf(request.model) == ".in2d";
  const geometry::PlanarDomain domain = hasCurves
                                            ? geometry::domainOf(geometry::readIn2d(request.model))
                                            : geometry::readPoly(request.model);
  const double readSeconds = reading.seconds();

  ProgressBar bar(control.showProgress);
  geometry::PlanarMeshingOptions options;
  setOptions(request, control, bar, options);
  options.keepBoundary = request.keepBoundary;
  const geometry::DomainModel model = geometry::planarModel(domain, options);
  checkIds(request, model);
  geometry::ModelMesh mesh = geometry::meshDomain(model, algorithm, options);
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
