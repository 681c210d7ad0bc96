// `af2 mesh` for surfaces that are given by triangles.
#include "cli/model_runs.h"
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
  const geometry::DomainModel model = geometry::facetedModel(facets, options);
  const double readSeconds = reading.seconds();
  checkIds(request, model);
  geometry::ModelMesh mesh = geometry::meshDomain(model, algorithm, options);
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
