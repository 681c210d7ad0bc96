// `af2 mesh` for surfaces that are given by triangles.
#include "cli/meshing/model_runs.h"
#include "geometry/faceted/mesh_faceted.h"

namespace af2::cli {

geometry::ModelMesh runFaceted(const MeshRequest& request, const AF2Algorithm& algorithm,
                               const RunControl& control) {
  ProgressBar bar(control.showProgress);
  bar.show("reading", 0, request.model.filename().string());
  Stopwatch reading;
  const geometry::Facets facets = geometry::readFacets(request.model);
  const double readSeconds = reading.seconds();
  geometry::ModelMesh mesh = geometry::meshFaceted(
      facets, algorithm, optionsOf(request, control, bar), [&](const geometry::DomainModel& model) {
        checkIds(request, model);
        tellNames(control, model);
      });
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
