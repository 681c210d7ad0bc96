// `af2 mesh` for surfaces that are given by triangles.
#include <fmt/core.h>

#include "cli/model_runs.h"
#include "cli/progress_bar.h"
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
  options.size = request.sizes.size;
  options.minSize = request.sizes.smallest;
  options.maxSize = request.sizes.largest;
  options.elementsPerTurn = request.sizes.elementsPerTurn;
  options.growth = request.sizes.growth;
  options.sources = request.sizes.file.sources;
  options.featureAngle = request.featureAngle;
  options.optimize = request.optimize;
  options.stop = control.stop;
  options.progress = [&](const Progress& progress) {
    bar.show("meshing", 0, fmt::format("{} elements", progress.elements));
  };
  geometry::ModelMesh mesh = geometry::meshFaceted(facets, algorithm, options);
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
