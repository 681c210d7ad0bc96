#include "geometry/domain/crossed_faces.h"

#include <algorithm>
#include <map>
#include <string>

#include "engine/base/place_text.h"
#include "geometry/mesh/blame_model.h"

namespace af2::geometry {

bool crossInModel(const std::vector<FacesCross>& model, int face,
                  const std::vector<Crossing>& crossings) {
  const auto isOf = [&](const auto& pair) { return std::ranges::count(pair.faces, face) > 0; };
  return std::ranges::any_of(crossings, [&](const Crossing& crossing) {
    return isOf(crossing) && std::ranges::any_of(model, [&](const FacesCross& known) {
             return isOf(known) && distance(known.place, crossing.place) <
                                       std::max(crossing.widths[0], crossing.widths[1]);
           });
  });
}

void tellOfCrossings(const std::vector<FacesCross>& model, std::vector<FaceReport>& faces) {
  std::map<int, std::vector<const FacesCross*>> byFace;
  for (const FacesCross& crossing : model)
    for (const int face : crossing.faces) byFace[face].push_back(&crossing);
  for (FaceReport& face : faces) {
    if (face.status != FaceStatus::Failed || face.cause != FailureCause::Unknown) continue;
    const auto found = byFace.find(face.id);
    if (found == byFace.end()) continue;
    const FacesCross& first = *found->second.front();
    const int other = first.faces[first.faces[0] == face.id];
    blameModel("in the model itself it crosses " +
                   (other == face.id ? "itself" : "face " + std::to_string(other)) + " at " +
                   af2::textOf(first.place),
               face);
  }
}

}  // namespace af2::geometry
