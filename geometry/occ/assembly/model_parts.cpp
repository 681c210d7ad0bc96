#include "geometry/occ/assembly/model_parts.h"

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {

namespace {

std::vector<ModelPart> solidsOf(const ModelShape& model) {
  std::vector<ModelPart> parts;
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(model.shape, TopAbs_SOLID, solids);
  for (int i = 1; i <= solids.Extent(); ++i) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(solids(i), TopAbs_FACE, faces);
    std::set<int> ids;
    for (int k = 1; k <= faces.Extent(); ++k) ids.insert(model.faces.FindIndex(faces(k)));
    ids.erase(0);
    if (!ids.empty())
      parts.push_back({"solid " + std::to_string(i), true, solids(i), {ids.begin(), ids.end()}});
  }
  return parts;
}

std::vector<ModelPart> sheetsOf(const ModelShape& model, const std::vector<ModelPart>& solids) {
  const auto count = static_cast<std::size_t>(model.faces.Extent());
  std::vector<bool> isOfSolid(count + 1, false);
  for (const ModelPart& solid : solids)
    for (const int face : solid.faces) isOfSolid[static_cast<std::size_t>(face)] = true;
  DisjointSets sets(count + 1);
  for (const std::vector<int>& faces : model.facesOfEdges) {
    int last = 0;
    for (const int face : faces) {
      if (isOfSolid[static_cast<std::size_t>(face)]) continue;
      if (last > 0) sets.join(static_cast<std::uint32_t>(last), static_cast<std::uint32_t>(face));
      last = face;
    }
  }
  std::map<std::uint32_t, std::vector<int>> sheets;
  for (std::size_t face = 1; face <= count; ++face)
    if (!isOfSolid[face])
      sheets[sets.of(static_cast<std::uint32_t>(face))].push_back(static_cast<int>(face));
  std::vector<ModelPart> parts;
  for (const auto& [first, faces] : sheets) {
    const BRep_Builder builder;
    TopoDS_Compound shape;
    builder.MakeCompound(shape);
    for (const int face : faces) builder.Add(shape, model.faces(face));
    parts.push_back({"sheet " + std::to_string(parts.size() + 1), false, shape, faces});
  }
  return parts;
}

/// The number of times that each name is used decides whether its parts are numbered.
void numberEqualNames(std::vector<ModelPart>& parts) {
  std::map<std::string, int> uses, numbers;
  for (const ModelPart& part : parts) ++uses[part.name];
  for (ModelPart& part : parts)
    if (uses[part.name] > 1) {
      const std::string name = part.name;
      part.name += "." + std::to_string(++numbers[name]);
    }
}

void giveNames(const ModelShape& model, std::vector<ModelPart>& parts) {
  std::vector<std::vector<const FaceGroup*>> groupsOf(
      static_cast<std::size_t>(model.faces.Extent()) + 1);
  for (const FaceGroup& group : model.groups)
    if (group.kind == GroupKind::Part)
      for (const int face : group.faces) groupsOf[static_cast<std::size_t>(face)].push_back(&group);
  for (ModelPart& part : parts) {
    const FaceGroup* smallest = nullptr;
    // Of groups of the same size, the last is the innermost: assemblies come before their parts.
    for (const FaceGroup* group : groupsOf[static_cast<std::size_t>(part.faces.front())])
      if (std::ranges::includes(group->faces, part.faces) &&
          (smallest == nullptr || group->faces.size() <= smallest->faces.size()))
        smallest = group;
    if (smallest != nullptr) part.name = smallest->name;
  }
  numberEqualNames(parts);
}

}  // namespace

std::vector<ModelPart> partsOf(const ModelShape& model) {
  std::vector<ModelPart> parts = solidsOf(model);
  for (ModelPart& sheet : sheetsOf(model, parts)) parts.push_back(std::move(sheet));
  giveNames(model, parts);
  return parts;
}

}  // namespace af2::geometry
