// Observing how a complete mesh is finished: swaps, collapses, moves and replacements.
#pragma once

#include <vector>

#include "engine/base/export.h"
#include "engine/mesh/mesh.h"

namespace af2 {

/// One change of a mesh that was kept.
struct FinishAct {
  enum class Kind {
    SwapForValence,  ///< of a side, for a more regular number of triangles at its vertices
    SwapForQuality,  ///< of a side, for better triangles
    Collapse,        ///< of a vertex that the mesh does not need
    Move,            ///< of a vertex by smoothing
    Replacement,     ///< of a few elements by others, with quadrilaterals
    Pairing,         ///< of two triangles, or a step of one towards the other
    Search,          ///< of a sequence of changes that leaves fewer irregular vertices
  };

  Kind kind = Kind::Move;
  std::vector<Element> before, after;  ///< the elements concerned
  VertexId vertex;                     ///< the one that moved or vanished, else none
  Point3 from, to;                     ///< Move only: the positions of the vertex
  /// The largest badness of the elements before and after. The badness is the distortion, at least
  /// 1, or, where the rule set says `finish score`, the score of its metric.
  double worstBefore = 0, worstAfter = 0;
};

inline constexpr int kFinishActKinds = static_cast<int>(FinishAct::Kind::Search) + 1;

/// "swap for valence", "move", ...
AF2_EXPORT const char* toString(FinishAct::Kind kind);

/// Receives every change that is kept while one mesh after another is finished. Called from the
/// thread that finishes the mesh.
class AF2_EXPORT FinishObserver {
 public:
  virtual ~FinishObserver() = default;
  /// The mesh as its front left it, or a strip along a cut of a large region. Until the end,
  /// vertices keep the ids that they have here.
  virtual void finishBegun(const Mesh&) {}
  /// A vertex that the next change uses.
  virtual void vertexAdded(VertexId, const Point3&) {}
  virtual void actKept(const FinishAct&) {}
  /// The finished mesh. Its vertices and elements are numbered anew if some of them vanished.
  ///
  /// isSound  false: the mesh is discarded, and with it all changes since `finishBegun`
  virtual void finishEnded(const Mesh&, bool /*isSound*/) {}
};

}  // namespace af2
