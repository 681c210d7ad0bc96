#include "geometry/mpi/partition/patch_graph.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "geometry/formats/element_vertices.h"

namespace af2::mpi {

namespace {

using geometry::FaceElements;
using geometry::MeshSlice;
using geometry::ModelMesh;

/// Of a mesh in memory: behind the last vertex that several faces have, or none.
std::uint32_t endOfShared(const ModelMesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> faceOf(mesh.vertices.size(), kNone);
  std::uint32_t end = 0;
  forEachFaceOf(mesh, [&](const MeshSlice& slice, const FaceElements& face, std::size_t f) {
    for (std::size_t e = face.first; e < face.last; ++e)
      forEachMshVertex(mesh, slice, e, [&](VertexId v) {
        std::uint32_t& first = faceOf[v.value];
        if (first == kNone) first = static_cast<std::uint32_t>(f);
        if (first != f) end = std::max(end, v.value + 1);
      });
  });
  const auto unused = std::ranges::find(faceOf.rbegin(), faceOf.rend(), kNone);
  return std::max(end, static_cast<std::uint32_t>(faceOf.rend() - unused));
}

class PatchGraphMaker {
 public:
  PatchGraphMaker(const ModelMesh& mesh, std::size_t most) : mesh_(mesh), most_(most) {
    graph_.insideFrom =
        mesh.spooled ? static_cast<std::uint32_t>(mesh.vertices.size()) : endOfShared(mesh);
  }

  PatchGraph make() {
    forEachFaceOf(mesh_, [&](const MeshSlice& slice, const FaceElements& face, std::size_t) {
      add(slice, face);
    });
    link(between_);
    mergeLinks();
    return std::move(graph_);
  }

 private:
  /// A side of an element at the border of its patch: its ends, the lower one first, and the patch.
  using Side = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

  /// What is known of a vertex inside the face that is looked at.
  struct Inside {
    std::uint32_t face = 0, patch = 0;
    bool isBetween = false;  ///< several patches have it
  };

  void add(const MeshSlice& slice, const FaceElements& face) {
    const std::size_t first = face.first - slice.firstElement, count = face.last - face.first;
    std::vector<Point3> middles(count);
    for (std::size_t i = 0; i < count; ++i) middles[i] = middleOf(slice, first + i);
    const PatchTree tree(middles, most_);
    const auto before = static_cast<std::uint32_t>(graph_.elements.size());
    graph_.elements.resize(before + tree.count());
    std::vector<std::uint32_t> patches(count);
    for (std::size_t i = 0; i < count; ++i) {
      patches[i] = before + tree.of(middles[i]);
      ++graph_.elements[patches[i]];
    }
    noteVertices(slice, first, patches);
    noteSides(slice, first, patches);
    graph_.faces.push_back({tree, before});
  }

  void noteVertices(const MeshSlice& slice, std::size_t first,
                    const std::vector<std::uint32_t>& patches) {
    ++face_;
    const std::size_t noted = graph_.atVertices.size();
    for (std::size_t i = 0; i < patches.size(); ++i)
      forEachMshVertex(mesh_, slice, first + i, [&](VertexId v) {
        if (v.value < graph_.insideFrom)
          graph_.atVertices.emplace_back(v.value, patches[i]);
        else
          note(insideAt(slice, v.value), patches[i]);
      });
    const auto own = graph_.atVertices.begin() + static_cast<std::ptrdiff_t>(noted);
    std::sort(own, graph_.atVertices.end());
    graph_.atVertices.erase(std::unique(own, graph_.atVertices.end()), graph_.atVertices.end());
  }

  Inside& insideAt(const MeshSlice& slice, std::uint32_t v) {
    const std::size_t i = v - std::max<std::size_t>(slice.firstVertex, graph_.insideFrom);
    if (i >= inside_.size()) inside_.resize(std::max(i + 1, 2 * inside_.size()));
    return inside_[i];
  }

  void note(Inside& vertex, std::uint32_t patch) const {
    if (vertex.face != face_)
      vertex = {face_, patch, false};
    else if (vertex.patch != patch)
      vertex.isBetween = true;
  }

  /// Only sides between vertices that several patches may have can lie between patches.
  void noteSides(const MeshSlice& slice, std::size_t first,
                 const std::vector<std::uint32_t>& patches) {
    std::vector<Side> sides;
    const auto isInside = [&](VertexId v) { return v.value >= graph_.insideFrom; };
    const auto mayBeBetween = [&](VertexId v) {
      return !isInside(v) || insideAt(slice, v.value).isBetween;
    };
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const auto corners = slice.elements[first + i].vertices();
      for (std::size_t c = 0; c < corners.size(); ++c) {
        const auto [from, to] = std::minmax(corners[c], corners[(c + 1) % corners.size()]);
        if (!mayBeBetween(from) || !mayBeBetween(to)) continue;
        (isInside(to) ? sides : between_).emplace_back(from.value, to.value, patches[i]);
      }
    }
    link(sides);
  }

  /// Patches that have the same side lie beside each other.
  void link(std::vector<Side>& sides) {
    std::ranges::sort(sides);
    const auto endsOf = [](const Side& s) { return std::pair(std::get<0>(s), std::get<1>(s)); };
    for (auto one = sides.begin(); one != sides.end(); ++one)
      for (auto other = std::next(one); other != sides.end() && endsOf(*one) == endsOf(*other);
           ++other)
        if (std::get<2>(*one) != std::get<2>(*other)) {
          graph_.links.push_back({std::get<2>(*one), std::get<2>(*other), 1});
          graph_.links.push_back({std::get<2>(*other), std::get<2>(*one), 1});
        }
    constexpr std::size_t kMany = 1'000'000;
    if (graph_.links.size() > std::max(kMany, 2 * merged_)) mergeLinks();
  }

  void mergeLinks() {
    std::vector<PatchGraph::Link>& links = graph_.links;
    const auto ends = [](const PatchGraph::Link& l) { return std::pair(l.from, l.to); };
    std::ranges::sort(links, {}, ends);
    std::size_t kept = 0;
    for (const PatchGraph::Link& link : links) {
      if (kept > 0 && ends(links[kept - 1]) == ends(link))
        links[kept - 1].sides += link.sides;
      else
        links[kept++] = link;
    }
    links.resize(kept);
    merged_ = kept;
  }

  const ModelMesh& mesh_;
  const std::size_t most_;
  PatchGraph graph_;
  std::vector<Side> between_;  ///< of all faces: sides between vertices that several may have
  std::vector<Inside> inside_;
  std::uint32_t face_ = 0;
  std::size_t merged_ = 0;
};

}  // namespace

PatchGraph patchGraph(const ModelMesh& mesh, std::size_t most) {
  return PatchGraphMaker(mesh, most).make();
}

}  // namespace af2::mpi
