// `af2 mesh` for surfaces that are given by triangles.
#include "cli/meshing/model_runs.h"
#include "geometry/faceted/mesh_faceted.h"

namespace af2::cli {

geometry::ModelMesh runFaceted(const MeshRequest& request, const AF2Algorithm& algorithm,
                               const RunControl& control) {
  Stopwatch reading;
  const geometry::Facets facets = geometry::readFacets(request.model);
  ProgressBar bar(control.showProgress);
  geometry::FacetedMeshingOptions options;
  setOptions(request, control, bar, options);
  options.featureAngle = request.featureAngle;
  const double readSeconds = reading.seconds();
  geometry::ModelMesh mesh =
      geometry::meshFaceted(facets, algorithm, options,
                            [&](const geometry::DomainModel& model) { checkIds(request, model); });
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
