#include "engine/optimize/turn_round.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/mesh/element_shape.h"
#include "engine/optimize/patch_editor.h"
#include "engine/optimize/quad_division.h"
#include "engine/optimize/quad_search.h"
#include "engine/optimize/vertex_news.h"

namespace af2 {
namespace {

/// Of the changes at a vertex, the most regular ones are tried: if any helps, it is nearly always
/// the first of them.
constexpr std::size_t kMostChanges = 8;
/// After so many elements in a row that nothing helps, as in a strip with hardly any width, the
/// others are taken for hopeless, too.
constexpr std::size_t kMostInVain = 64;

std::vector<std::size_t> foldedQuads(const Mesh& mesh) {
  std::vector<std::size_t> folded;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.elements[e].isQuad() && leans(mesh, mesh.elements[e])) folded.push_back(e);
  return folded;
}

/// The patches that one change at a vertex of an element leads to, the most regular first.
std::vector<QuadPatch> changesAt(const QuadPatch& patch, std::size_t element) {
  std::vector<QuadPatch> changed;
  for (const QuadPatch::Vertex v : patch.cornersAt(element))
    forEachAct(patch, v, [&](const QuadPatch::Act& act) {
      if (!patch.allows(act)) return;
      changed.push_back(patch);
      changed.back().apply(act);
    });
  std::ranges::stable_sort(changed, {}, &QuadPatch::energy);
  if (changed.size() > kMostChanges) changed.erase(changed.begin() + kMostChanges, changed.end());
  return changed;
}

bool mend(PatchEditor& editor, std::size_t element) {
  const Element corners = editor.topology().mesh().elements[element];
  for (const VertexId seed : corners.vertices()) {
    if (!editor.take(seed)) continue;
    const auto inPatch = editor.find(element);
    if (!inPatch) continue;
    const std::optional<PatchJacobians> before = editor.jacobians();
    if (!before || before->turned == 0) continue;
    const QuadPatch patch = editor.patch();
    // Another turned element beside it can wait for its own turn.
    const PatchJacobians wanted{.turned = before->turned - 1};
    if (editor.putBack(patch, wanted, FinishAct::Kind::Search)) return true;
    for (const QuadPatch& changed : changesAt(patch, *inPatch))
      if (editor.putBack(changed, wanted, FinishAct::Kind::Search)) return true;
  }
  // Where the boundary is straight at a corner, no vertex can move to make the element better.
  return divideTurned(editor, element);
}

}  // namespace

bool hasTurnedElements(const Mesh& mesh) { return !foldedQuads(mesh).empty(); }

std::size_t turnElementsRound(Mesh& mesh, const MeshBoundary& boundary,
                              const AF2LocalTransformMaker& maker, const WorkWatch& watch) {
  constexpr int kMaxPasses = 4;
  MeshTopology topology(mesh, boundary);
  PatchEditor editor(topology, maker, topology.anglesAtFixed());
  VertexNews news(mesh.vertices.size());
  std::size_t before = mesh.elements.size() + 1;
  std::vector<std::size_t> folded = foldedQuads(mesh);
  // What is mended beside an element can be what it was waiting for.
  for (int pass = 0; pass < kMaxPasses && !folded.empty() && folded.size() < before; ++pass) {
    before = folded.size();
    std::size_t inVain = 0;
    for (const std::size_t e : folded) {
      if (watch.mustStop() || inVain == kMostInVain) break;
      if (topology.isDead(e) || !leans(mesh, mesh.elements[e])) continue;
      const Element element = mesh.elements[e];
      const auto isNews = [&](VertexId v) { return news.isNews(v); };
      if (pass > 0 && std::ranges::none_of(element.vertices(), isNews)) continue;
      if (mend(editor, e)) {
        news.noteChange(editor.vertices(), mesh.vertices.size());
        inVain = 0;
      } else {
        for (const VertexId v : element.vertices()) news.look(v);
        ++inVain;
      }
    }
    folded = foldedQuads(mesh);
    std::erase_if(folded, [&](std::size_t e) { return topology.isDead(e); });
  }
  topology.compact();
  return folded.size();
}

}  // namespace af2
