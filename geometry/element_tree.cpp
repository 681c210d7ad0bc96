#include "geometry/element_tree.h"

namespace af2::geometry {

ElementTree::ElementTree(const ModelMesh& mesh, std::size_t first, std::size_t last)
    : first_(first), last_(last) {
  std::vector<Box3> boxes((last - first + kRun - 1) / kRun);
  for (std::size_t i = first; i < last; ++i)
    for (const VertexId v : mesh.elements[i].vertices())
      boxes[(i - first) / kRun].add(mesh.vertices[v.value]);
  levels_.push_back(std::move(boxes));
  while (levels_.back().size() > 1) {
    const std::vector<Box3>& below = levels_.back();
    std::vector<Box3> above((below.size() + kBranches - 1) / kBranches);
    for (std::size_t i = 0; i < below.size(); ++i) above[i / kBranches].add(below[i]);
    levels_.push_back(std::move(above));
  }
}

}  // namespace af2::geometry
