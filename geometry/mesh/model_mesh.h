// The mesh of a whole model: the meshes of its faces, joined at the shared vertices of their edges.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "engine/mesh/mesh.h"
#include "engine/rule/refusal.h"
#include "engine/step/front_piece.h"
#include "engine/step/observer.h"
#include "geometry/mesh/contact.h"
#include "geometry/mesh/layers_along_edge.h"
#include "geometry/mesh/without_rule.h"
#include "geometry/spool/mesh_slice.h"

namespace af2::geometry {

class SpooledMesh;

enum class FaceStatus { Complete, Failed, Cancelled, Skipped };

/// What is at fault where a face failed, as far as it was found out.
enum class FailureCause {
  Unknown,
  Model,  ///< the model itself, so that no sizes help
  Size,   ///< nothing of the model is visible at this size
};

/// An edge of a front that got stuck.
struct StuckPlace {
  Point3 from, to;
  double u = 0, v = 0;  ///< of `from` in the parameters of the face's surface, if it has any
  int level = 1;        ///< the quality level reached there
  /// The last reason why each rule was refused: index in ModelMesh::ruleNames, and the reason.
  std::vector<std::pair<std::uint16_t, Refusal>> refusals;
  /// The front around the edge in its chart; without vertices if it is not known.
  FrontPiece around = {};
};

/// How the meshing of one face of the model went.
struct FaceReport {
  int id = 0;               ///< 1, 2, ... in the order of the model
  std::string name;         ///< from the file, may be empty
  std::string surfaceType;  ///< "plane", "cylinder", ...
  std::string chart = {};   ///< used to mesh it: "plane", "mean-normal", ...
  FaceStatus status = FaceStatus::Complete;
  std::size_t elements = 0;
  double seconds = 0;
  double area = 0;     ///< of the CAD face, model units squared
  std::string reason;  ///< where and why, when it failed
  FailureCause cause = FailureCause::Unknown;
  std::vector<std::string> attempts = {};    ///< unsuccessful attempts
  std::vector<StuckPlace> stuck = {};        ///< where its front got stuck, if it did
  WithoutRuleCounts withoutRule = {};        ///< or in the places of such elements
  FrontActCounts acts = {};                  ///< of the front, beside steps
  std::vector<LayersAlongEdge> layers = {};  ///< by edge, ascending, if layers were asked for
  std::size_t layerElements = 0;             ///< of the layers
  struct Segment {
    Point3 from, to;
    double sizes = 0;  ///< its length in wanted sizes
  };
  struct OddLoop {
    std::size_t loop = 0;      ///< of the boundary, counted from 1
    std::size_t segments = 0;  ///< an odd number
    /// With rules that make quadrilaterals: the segment that suffers least from being divided.
    /// 0 sizes: there is none, because the face lies on both sides of all segments.
    Segment longest = {};
  };
  std::vector<OddLoop> oddLoops = {};  ///< boundary loops with an odd number of segments
  /// Triangles of a mesh that should have quadrilaterals only (QuadCleanUp::onlyQuads).
  std::size_t triangles = 0;
  Point3 firstTriangle = {};  ///< the middle of one of them, if there are any
  /// The largest distance that was found between its elements and its surface; none: not measured.
  std::optional<double> deviation = {};
  /// The id of a congruent face, whose mesh it has, moved; 0: there is none, or none any more.
  int congruentTo = 0;
};

enum class GroupKind {
  Part,   ///< a part that the file names
  Solid,  ///< a solid of the model
  Layer,
  Color,      ///< named "#rrggbb"
  Interface,  ///< faces that two parts share, named "one|other"
};

/// "part", "solid", "layer", "color" or "interface".
AF2_EXPORT const char* toString(GroupKind kind);

/// Faces of the model that belong together. A face may belong to several groups.
struct FaceGroup {
  std::string name;
  GroupKind kind = GroupKind::Part;
  std::vector<int> faces;  ///< ids, ascending
  /// Of a solid: ids, ascending, of those faces whose elements look into it, because they look out
  /// of another solid that shares them.
  std::vector<int> inward = {};
  bool operator==(const FaceGroup&) const = default;
};

/// Edges of the model that the file marks as one boundary, for boundary conditions. An edge is in
/// at most one boundary.
struct EdgeGroup {
  int number = 0;          ///< the number in the file, not 0
  std::string name;        ///< may be empty
  std::vector<int> edges;  ///< ids, ascending
  bool operator==(const EdgeGroup&) const = default;
};

/// The name of a boundary, or its number if it has no name.
AF2_EXPORT std::string shownName(const EdgeGroup& boundary);

/// A piece of a divided model edge. `uses` is the number of times that the requested faces use it:
/// 2 inside a closed shell and along a seam, 1 at its border.
struct EdgeSegment {
  VertexId from, to;
  int edge = 0;  ///< id of the model edge, 1, 2, ...
  int uses = 0;
  Point3 middle{};  ///< halfway along the edge; only for elements of second order
  bool operator==(const EdgeSegment&) const = default;
};

/// A kind of change that healing made in the model, and how often.
struct HealedChange {
  std::string what;
  std::size_t count = 0;
  std::optional<Point3> place;  ///< of one of the changes, if known
  bool operator==(const HealedChange&) const = default;
};

/// The options and the result of healing.
struct Healing {
  double tolerance = 0;  ///< in model units
  std::vector<HealedChange> changes;
  std::vector<std::string> undone;  ///< steps that would have made the model worse, and why
};

/// How parts that touch were made to share faces.
struct Imprinting {
  double tolerance = 0;  ///< in model units
  std::size_t parts = 0;
  std::size_t interfaces = 0;        ///< pairs of parts that share faces now
  std::vector<std::string> changes;  ///< what has become of overlaps, one sentence each
  std::string undone;                ///< why the model is as it was; empty: it is imprinted
};

/// Faces that were meshed together.
struct MergedGroup {
  std::vector<int> faces;        ///< ids, ascending
  std::vector<int> smoothEdges;  ///< edges between them that the mesh crosses, ascending
  std::vector<int> narrowEdges;  ///< the same, because a face beside is too narrow
  double deviation = 0;          ///< the largest distance found of its elements from the faces
  bool operator==(const MergedGroup&) const = default;
};

/// What a mesh across edges of its model has left out.
struct Merging {
  double angle = 0;   ///< degrees
  double narrow = 0;  ///< share of the size
  std::vector<MergedGroup> groups;
  std::vector<int> vertices;             ///< ids of those that the mesh does not have, ascending
  std::vector<std::vector<int>> chains;  ///< ids of edges that were divided as one
  struct Kept {
    int face = 0;
    std::string reason;
    bool operator==(const Kept&) const = default;
  };
  std::vector<Kept> kept;  ///< faces that were meshed one by one although they could be merged
  bool operator==(const Merging&) const = default;
};

/// Where a rule is written. A mirror image has the text of the rule that it mirrors.
struct RuleText {
  std::string file;  ///< as a reader may want to see it, such as "tri/even.af2"
  int line = 0;      ///< counted from 1
  std::string text;
  bool operator==(const RuleText&) const = default;
};

/// The largest distance that was found between a mesh and its model, and where.
struct Deviation {
  double largest = 0;
  Point3 place = {};
  int face = 0;  ///< id; 0: it is at an edge
  int edge = 0;  ///< id; 0: it is at a face
};

/// Two faces whose meshes are images of each other.
struct PeriodicPair {
  int first = 0, second = 0;  ///< ids of the faces
  /// Maps the first face to the second: rows of a matrix [R t; 0 1].
  std::array<double, 16> transform{};
  /// Vertices of the second face and, for each, the vertex of the first of which it is the image.
  std::vector<std::pair<VertexId, VertexId>> vertices = {};
};

/// Seconds spent in each stage of a run.
struct StageSeconds {
  double read = 0;
  double contacts = 0;  ///< finding parts of the model that touch
  double edges = 0, surface = 0, optimize = 0, write = 0;
};

struct ModelMesh {
  std::string name;  ///< of the model, for people; may be empty
  std::vector<Point3> vertices;
  /// By vertex: the edge length requested there, before sizes were graded away from short edges of
  /// the model; may be empty.
  std::vector<double> wantedSizes;
  std::vector<Element> elements;
  /// Second order: by element, the vertices at the middles of its sides, [0] between corners 0 and
  /// 1; they come after all other vertices. Empty: first order.
  std::vector<std::array<VertexId, 4>> midsides;
  /// Second order: elements that kept straight sides, because curved sides would invert them.
  std::vector<ElementId> straightened;
  std::vector<std::int32_t> face;      ///< by element: id of the model face
  std::vector<ElementOrigin> origins;  ///< by element; `rule` is an index in ruleNames
  std::vector<float> scores;           ///< by element: as elementScores gives them; may be empty
  /// Titles of the rules, followed by the names of what makes elements where no rule does.
  std::vector<std::string> ruleNames;
  std::vector<RuleText> ruleTexts;  ///< of the first rules of ruleNames; may be empty
  std::vector<EdgeSegment> segments;
  std::vector<FaceReport> faces;
  std::vector<FaceGroup> groups;
  std::vector<EdgeGroup> boundaries;     ///< by their numbers, ascending
  std::string unit;                      ///< of all lengths, "mm"; empty if the file does not say
  std::string fileUnit;                  ///< unit used in the file, as named there; may be empty
  std::vector<std::string> notes;        ///< repairs made while reading
  std::optional<Healing> healing;        ///< if the model was healed
  std::optional<Imprinting> imprinting;  ///< if it was asked for
  std::optional<Merging> merging;        ///< if it was asked for
  std::optional<Deviation> deviation;    ///< if a bound on it was given
  std::vector<PeriodicPair> periodic;    ///< if periodic faces were asked for
  PartContacts contacts;                 ///< of the model, where its parts share nothing
  /// Findings of the last checks that do not concern a single face, and faces of the file that were
  /// lost.
  std::vector<std::string> findings;
  StageSeconds seconds;
  /// If it was asked for (MeshingOptions::spool): the elements, and the vertices inside faces, are
  /// on disk. `vertices` and `wantedSizes` then end with the last vertex on an edge; `elements`,
  /// `face`, `origins` and `scores` are empty. `forEachSlice` and the counts know about it.
  std::shared_ptr<const SpooledMesh> spooled;
};

/// Wherever they are.
AF2_EXPORT std::size_t vertexCount(const ModelMesh& mesh);
AF2_EXPORT std::size_t elementCount(const ModelMesh& mesh);
AF2_EXPORT std::size_t quadCount(const ModelMesh& mesh);
AF2_EXPORT bool hasScores(const ModelMesh& mesh);
/// Calls `visit` with all vertices and elements in their order: at once if they are in memory, else
/// first with the vertices on edges, then face by face. A slice lives as long as the call.
AF2_EXPORT void forEachSlice(const ModelMesh& mesh, const SliceVisit& visit);
/// Calls `visit` with the slice that has an element, and perhaps others.
AF2_EXPORT void visitSliceOf(const ModelMesh& mesh, std::size_t element, const SliceVisit& visit);

inline std::size_t failedFaces(const ModelMesh& mesh) {
  return static_cast<std::size_t>(
      std::ranges::count(mesh.faces, FaceStatus::Failed, &FaceReport::status));
}

/// Of all faces together.
inline WithoutRuleCounts elementsWithoutRule(const ModelMesh& mesh) {
  WithoutRuleCounts counts;
  for (const FaceReport& face : mesh.faces) counts += face.withoutRule;
  return counts;
}

/// The number of vertices at corners of elements: all except those at the middles of sides, which
/// come last.
inline std::size_t cornerCount(const ModelMesh& mesh) {
  return mesh.midsides.empty() ? vertexCount(mesh) : mesh.midsides.front().front().value;
}
/// These vertices, of a mesh in memory.
inline std::span<const Point3> cornerVertices(const ModelMesh& mesh) {
  return std::span(mesh.vertices).first(cornerCount(mesh));
}
/// Calls visit(point) for each of these vertices, in their order.
template <class Visit>
void forEachCorner(const ModelMesh& mesh, const Visit& visit) {
  const std::size_t count = cornerCount(mesh);
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    for (const Point3& p : slice.vertices.first(std::min(slice.vertices.size(), count))) visit(p);
  });
}
/// Consecutive elements of one face.
struct FaceElements {
  std::int32_t face = 0;
  std::size_t first = 0, last = 0;  ///< the last is excluded
};
/// All elements, in their order.
AF2_EXPORT std::vector<FaceElements> elementsByFace(const ModelMesh& mesh);

/// Consecutive elements of one face that are all triangles or all quadrilaterals.
struct ElementRun {
  std::int32_t face = 0;
  bool areQuads = false;
  std::size_t count = 0;
  bool operator==(const ElementRun&) const = default;
};
/// All elements, in their order. Of a mesh that is not in memory, only faces with both kinds are
/// loaded for this.
AF2_EXPORT void forEachRun(const ModelMesh& mesh,
                           const std::function<void(const ElementRun&)>& visit);

/// Calls visit(slice, i) for each of some elements, which is number i of the slice.
template <class Visit>
void forEachElementOf(const ModelMesh& mesh, const FaceElements& some, const Visit& visit) {
  visitSliceOf(mesh, some.first, [&](const MeshSlice& slice) {
    for (std::size_t e = some.first; e < some.last; ++e) visit(slice, e - slice.firstElement);
  });
}
/// Calls visit(slice, i) for each element i of each slice, in their order.
template <class Visit>
void forEachElement(const ModelMesh& mesh, const Visit& visit) {
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    for (std::size_t i = 0; i < slice.elements.size(); ++i) visit(slice, i);
  });
}

}  // namespace af2::geometry
