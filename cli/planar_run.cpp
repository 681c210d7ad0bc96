// `af2 mesh` for planar domains.
#include "cli/model_runs.h"
#include "cli/usage_error.h"
#include "geometry/file_extension.h"
#include "geometry/planar/in2d_file.h"
#include "geometry/planar/mesh_planar.h"

namespace af2::cli {

geometry::ModelMesh runPlanar(const MeshRequest& request, const AF2Algorithm& algorithm,
                              const RunControl& control) {
  if (!request.faces.empty())
    throw UsageError("a planar domain is meshed as a whole: leave out --faces");
  Stopwatch reading;
  const bool hasCurves = geometry::extensionOf(request.model) == ".in2d";
  geometry::PlanarCurves curves;
  geometry::PlanarDomain domain;
  if (hasCurves)
    curves = geometry::readIn2d(request.model);
  else
    domain = geometry::readPoly(request.model);
  const double readSeconds = reading.seconds();

  ProgressBar bar(control.showProgress);
  geometry::PlanarMeshingOptions options;
  setOptions(request, control, bar, options);
  options.keepBoundary = request.keepBoundary;
  if (hasCurves) {
    domain = geometry::divideCurves(curves, options);
    options.keepBoundary = true;
  }
  geometry::ModelMesh mesh = geometry::meshPlanar(domain, algorithm, options);
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
