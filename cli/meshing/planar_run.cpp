// `af2 mesh` for planar domains.
#include "cli/meshing/model_runs.h"
#include "geometry/base/constants.h"
#include "geometry/planar/inside_domain.h"
#include "geometry/planar/mesh_planar.h"
#include "geometry/planar/planar_file.h"

namespace af2::cli {

geometry::ModelMesh runPlanar(const MeshRequest& request, const AF2Algorithm& algorithm,
                              const RunControl& control) {
  ProgressBar bar(control.showProgress);
  bar.show("reading", 0, request.model.filename().string());
  Stopwatch reading;
  const geometry::InsideFaces& inside = request.inside;
  const geometry::PlanarDomain domain =
      geometry::withInside(geometry::readPlanar(request.model), inside.points, inside.curves);
  const double readSeconds = reading.seconds();
  const geometry::MeshingOptions options = optionsOf(request, control, bar);
  const geometry::DomainModel model = geometry::planarModel(domain, options);
  checkIds(request, model);
  tellNames(control, model);
  geometry::requireInside(model, inside.points, inside.curves,
                          geometry::kUnseen * options.sizes.size);
  geometry::ModelMesh mesh = geometry::meshDomain(model, algorithm, options);
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
