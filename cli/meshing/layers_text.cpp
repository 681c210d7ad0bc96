#include "cli/meshing/layers_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "cli/meshing/mesh_summary.h"
#include "engine/base/place_text.h"

namespace af2::cli {
namespace {

struct Place {
  int face;
  const geometry::LayersAlongEdge* along;
};

std::string placeText(const Place& place) {
  const geometry::LayersAlongEdge& along = *place.along;
  const std::string range = along.fewest == along.most
                                ? std::to_string(along.fewest)
                                : fmt::format("{} to {}", along.fewest, along.most);
  return fmt::format("edge {} of face {} ({} of {}, on {} of {} segments, the fewest at {})",
                     along.edge, place.face, range, along.asked, along.fewer, along.segments,
                     textOf(along.place, 3));
}

}  // namespace

std::string layersText(const geometry::ModelMesh& mesh) {
  constexpr std::size_t kShown = 5;
  std::size_t edges = 0, elements = 0;
  std::vector<Place> fewer;
  for (const geometry::FaceReport& face : mesh.faces) {
    elements += face.layerElements;
    edges += face.layers.size();
    for (const geometry::LayersAlongEdge& along : face.layers)
      if (along.fewer > 0) fewer.push_back({face.id, &along});
  }
  if (edges == 0) return "";
  std::string text = fmt::format("layers: {} elements along {} edge{} of faces", grouped(elements),
                                 edges, edges == 1 ? "" : "s");
  if (fewer.empty()) return text + ", everywhere as many layers as asked\n";
  std::ranges::stable_sort(fewer, {}, [](const Place& place) { return place.along->fewest; });
  text += fmt::format("; fewer than asked along {} of them: ", fewer.size());
  for (std::size_t i = 0; i < std::min(fewer.size(), kShown); ++i)
    text += (i > 0 ? ", " : "") + placeText(fewer[i]);
  if (fewer.size() > kShown) text += fmt::format(" and {} more", fewer.size() - kShown);
  return text + "\n";
}

}  // namespace af2::cli
