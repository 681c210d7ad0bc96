// `af2 mesh` for surfaces that are given by triangles.
#include "cli/model_runs.h"
#include "cli/usage_error.h"
#include "geometry/faceted/mesh_faceted.h"

namespace af2::cli {

geometry::ModelMesh runFaceted(const MeshRequest& request, const AF2Algorithm& algorithm,
                               const RunControl& control) {
  if (!request.faces.empty())
    throw UsageError("an STL or OBJ file is meshed as a whole: leave out --faces");
  Stopwatch reading;
  const geometry::Facets facets = geometry::readFacets(request.model);
  const double readSeconds = reading.seconds();

  ProgressBar bar(control.showProgress);
  geometry::FacetedMeshingOptions options;
  setOptions(request, control, bar, options);
  options.featureAngle = request.featureAngle;
  geometry::ModelMesh mesh = geometry::meshFaceted(facets, algorithm, options);
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
