#include "geometry/occ/model/named_faces.h"

#include <algorithm>

#include "engine/base/error.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {
namespace {

void checkNamed(const NamedFaces& named, int faceCount) {
  if (named.name.empty()) throw InputError("the name of a face must not be empty");
  if (named.faces.empty()) throw InputError("the name '" + named.name + "' has no faces");
  for (const int face : named.faces)
    if (face < 1 || face > faceCount)
      throw InputError("the name '" + named.name + "' is for face " + std::to_string(face) +
                       ", but the model has faces 1 to " + std::to_string(faceCount));
}

}  // namespace

Model withNames(const Model& model, std::span<const NamedFaces> names) {
  auto after = std::make_shared<ModelShape>(model.shape());
  for (const NamedFaces& named : names) {
    checkNamed(named, model.faceCount());
    if (named.faces.size() == 1) {
      after->faceNames[static_cast<std::size_t>(named.faces.front()) - 1] = named.name;
      continue;
    }
    FaceGroup group{named.name, GroupKind::Part, named.faces};
    std::ranges::sort(group.faces);
    group.faces.erase(std::ranges::unique(group.faces).begin(), group.faces.end());
    after->groups.push_back(std::move(group));
  }
  return Model(std::move(after));
}

}  // namespace af2::geometry
