#include "geometry/occ/faces/face_boundary.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "engine/base/error.h"
#include "geometry/base/plane_axes.h"
#include "geometry/mesh/sharp_seams.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_on_face.h"
#include "geometry/occ/edges/touching_edges.h"
#include "geometry/occ/faces/chains.h"
#include "geometry/occ/faces/wire_orientation.h"

namespace af2::geometry {

namespace {

class BoundaryFinder {
 public:
  BoundaryFinder(const ModelShape& model, int faceId, const DividedEdges& divided,
                 const FaceSurface& surface, const std::vector<FaceOnFace>& onFaces,
                 const FaceCell* cell = nullptr)
      : model_(model),
        divided_(divided),
        surface_(surface),
        face_(faceId),
        cell_(cell),
        box_(cell ? model.surface(faceId).box() : surface.box()) {
    for (const FaceOnFace& lying : onFaces)
      if (lying.under == faceId && !lying.isDouble()) lying_.push_back(lying);
    const TopoDS_Face face = model.face(faceId);
    reversed_ = face.Orientation() == TopAbs_REVERSED;
    forward_ = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    const GeomAdaptor_Surface adaptor(BRep_Tool::Surface(forward_));
    if (adaptor.GetType() == GeomAbs_Plane) plane_ = adaptor.Plane();
  }

  FaceBoundary find() {
    for (TopoDS_Iterator wire(forward_); wire.More(); wire.Next()) {
      for (TopExp_Explorer it(wire.Value(), TopAbs_EDGE); it.More(); it.Next())
        addEdge(TopoDS::Edge(it.Current()));
      wire_.resize(chains_.size(), wires_++);
    }
    for (const FaceOnFace& lying : lying_) leaveOut(lying);
    if (cell_) addCreases();
    if (cell_ && chains_.empty()) return std::move(result_);
    if (chains_.empty() && !result_.pointEdges.empty()) return std::move(result_);
    if (chains_.empty())
      throw GeometryError(
          "the face has no boundary, and its surface is unbounded: its edges are lost");
    noteTwins();
    if (surface_.isPlane() && lying_.empty()) orientWiresOfPlane();
    if (hasNoWidth()) return std::move(result_);
    cancelWhereTheyTouch();
    takeNormalsBesidePoints();
    cancelOppositeChains(chains_);
    if (chains_.empty()) return std::move(result_);
    result_.points = numberVertices(chains_);
    for (const Chain& chain : chains_) addUses(chain);
    LinkedLoops linked = linkChains(std::move(chains_));
    result_.input.loops = std::move(linked.loops);
    result_.closedInParameters = linked.closedInParameters();
    result_.canBeCut = std::ranges::all_of(
        linked.jumps, [&](const LinkedLoops::Jump& jump) { return isAtPole(jump); });
    result_.input.vertexCount = result_.points.size();
    partSharpSeams(result_.input, result_.points);
    addIsolatedVertices();
    return std::move(result_);
  }

 private:
  /// Whether all parameters between the two belong to the same point.
  bool isAtPole(const LinkedLoops::Jump& jump) const {
    constexpr double kSamePoint = 1e-6;  // of the extent of the face
    if (surface_.isPlane()) return false;
    const Point3 between =
        (*surface_.inParameters())
            .pointAt(0.5 * (jump.end.u + jump.start.u), 0.5 * (jump.end.v + jump.start.v))
            .position;
    return distance(between, jump.end.position) <= kSamePoint * surface_.extent();
  }

  /// The two sides of a seam are one turn apart. If they are more, the area within them in the
  /// parameters is counted more than once.
  void checkSeam(int edge, const gp_Pnt2d& start) {
    constexpr double kMax = 1.5;  // turns
    const auto [other, isFirst] = starts_.try_emplace(edge, start);
    if (isFirst) return;
    const GeomAdaptor_Surface adaptor(BRep_Tool::Surface(forward_));
    const gp_Pnt2d& first = other->second;
    const bool isFarInU =
        adaptor.IsUPeriodic() && std::abs(first.X() - start.X()) > kMax * adaptor.UPeriod();
    const bool isFarInV =
        adaptor.IsVPeriodic() && std::abs(first.Y() - start.Y()) > kMax * adaptor.VPeriod();
    if (isFarInU || isFarInV)
      result_.repairs.push_back("the sides of edge " + std::to_string(edge) +
                                ", a seam, were several turns apart in the parameters");
  }

  /// Whether each edge runs back along another one, on the same side of every seam. Without curves
  /// in the parameters, the side is unknown.
  bool hasNoWidth() const {
    if (lacksCurves_) return false;
    std::vector<bool> isMatched(chains_.size(), false);
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      for (std::size_t k = i + 1; k < chains_.size() && !isMatched[i]; ++k)
        if (!isMatched[k] && runsBackAlong(chains_[i], chains_[k]))
          isMatched[i] = isMatched[k] = true;
      if (!isMatched[i]) return false;
    }
    return true;
  }

  bool runsBackAlong(const Chain& one, const Chain& other) const {
    const double most =
        kMaxApart * std::max(dividedEdge(one.edge).wanted, dividedEdge(other.edge).wanted);
    return std::equal(one.corners.begin(), one.corners.end(), other.corners.rbegin(),
                      other.corners.rend(), [&](const BoundaryCorner& a, const BoundaryCorner& b) {
                        return a.vertex == b.vertex && widthBetween(a.point, b.point) <= most;
                      });
  }

  const DividedEdge& dividedEdge(int id) const {
    return divided_.edges[static_cast<std::size_t>(id) - 1];
  }

  void cancelWhereTheyTouch() {
    if (lacksCurves_ && !surface_.isPlane()) return;
    const auto runBack = [&](const Chain& a, const Chain& b) { return runsBackAlong(a, b); };
    std::optional<PlaneAxes> axes;
    if (surface_.isPlane()) axes.emplace(chains_[0].corners[0].point);
    const auto inPlane = [&](const SurfacePoint& p) {
      return axes ? (*axes)(p) : Point2{p.u, p.v};
    };
    for (const auto& [one, other] : cancelTouching(chains_, wire_, runBack, inPlane))
      addTouching(one, other);
  }

  void addTouching(const Chain& one, const Chain& other) {
    FaceBoundary::TouchingEdges edges{one.edge, other.edge, 0, 0};
    const BRepAdaptor_Curve first(model_.edge(one.edge)), second(model_.edge(other.edge));
    const auto count = static_cast<std::uint32_t>(one.corners.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      const gp_Pnt p = first.Value(parameterOf(one, i));
      edges.gap = std::max(edges.gap, p.Distance(second.Value(parameterOf(other, count - 1 - i))));
      if (i > 0)
        edges.length += distance(one.corners[i - 1].point.position, one.corners[i].point.position);
    }
    result_.touching.push_back(edges);
  }

  /// Of a corner of a chain, along its edge.
  double parameterOf(const Chain& chain, std::uint32_t corner) const {
    const auto last = static_cast<std::uint32_t>(chain.corners.size()) - 1;
    return dividedEdge(chain.edge)
        .parameters[chain.firstSegment + (chain.reversed ? last - corner : corner)];
  }

  /// How far it is along the surface from one place to another one of the same point; not nothing
  /// across a seam.
  double widthBetween(const SurfacePoint& a, const SurfacePoint& b) const {
    if (surface_.isPlane()) return 0;
    const SurfaceFrame frame = surface_.inParameters()->frameAt(a.u, a.v);
    return length(frame.du) * std::abs(a.u - b.u) + length(frame.dv) * std::abs(a.v - b.v);
  }

  void orientWiresOfPlane() {
    const PlaneAxes axes(chains_[0].corners[0].point);
    const int turned = orientWires(chains_, wire_, [&](const SurfacePoint& p) { return axes(p); });
    if (turned > 0)
      result_.repairs.push_back(std::to_string(turned) +
                                " of its wires had the wrong direction; reversed");
  }

  void addEdge(const TopoDS_Edge& edge) {
    if (edge.Orientation() == TopAbs_EXTERNAL) return;
    const int id = model_.edges.FindIndex(edge);
    if (isFold(id)) return;
    const DividedEdge& divided = dividedEdge(id);
    if (!divided.problem.empty())
      throw GeometryError("edge " + std::to_string(id) + " " + divided.problem);
    if (divided.points.empty()) {
      if (!BRep_Tool::Degenerated(edge)) result_.pointEdges.push_back(id);
      return;
    }
    if (edge.Orientation() == TopAbs_INTERNAL) {
      addChain(id, divided, TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)));
      addChain(id, divided, TopoDS::Edge(edge.Oriented(TopAbs_REVERSED)));
    } else {
      addChain(id, divided, edge);
    }
  }

  bool isFold(int edge) const {
    return std::ranges::any_of(
        lying_, [&](const FaceOnFace& lying) { return std::ranges::count(lying.folds, edge) > 0; });
  }

  /// Where another face lies on this one, folded back, neither has elements: the boundary of the
  /// other face, in its direction, closes the rest of the boundary of this one.
  void leaveOut(const FaceOnFace& lying) {
    for (TopExp_Explorer it(model_.face(lying.face), TopAbs_EDGE); it.More(); it.Next()) {
      const bool isReversed = (it.Current().Orientation() == TopAbs_REVERSED) != reversed_;
      addEdge(TopoDS::Edge(it.Current().Oriented(isReversed ? TopAbs_REVERSED : TopAbs_FORWARD)));
    }
    wire_.resize(chains_.size(), wires_++);
    result_.notes.push_back("face " + std::to_string(lying.face) +
                            " lies on it, folded back: there it has no elements");
  }

  /// The creases around the cell, each with the region on its left.
  void addCreases() {
    const auto found = model_.creaseEdges.find(face_);
    if (found == model_.creaseEdges.end()) return;
    for (const CreaseEdge& crease : found->second) {
      const std::size_t own = crease.isAtU ? cell_->u : cell_->v;
      if (own != crease.crease && own != crease.crease + 1) continue;
      // A line of constant u has smaller u on its left, one of constant v greater v.
      const bool isForward = (own == crease.crease) == crease.isAtU;
      const TopoDS_Shape edge =
          model_.edge(crease.id).Oriented(isForward ? TopAbs_FORWARD : TopAbs_REVERSED);
      addEdge(TopoDS::Edge(edge));
    }
    wire_.resize(chains_.size(), wires_++);
  }

  bool isCrease(int edge) const { return edge > model_.edgesOfFile; }

  /// Whether the part of a face next to a chain is in the cell.
  bool isInCell(const Chain& chain, const std::vector<gp_Pnt2d>& places) const {
    if (!cell_) return true;
    const gp_Pnt2d& p = places[(places.size() - 1) / 2];
    const gp_Pnt2d& q = places[places.size() / 2];
    // A crease is between two cells; that case is handled above.
    const double slack = isCrease(chain.edge) ? kOnCrease : 0;
    return isIn(*cell_, model_.cells.at(face_), (p.X() + q.X()) / 2, (p.Y() + q.Y()) / 2, slack);
  }

  void addChain(int id, const DividedEdge& divided, const TopoDS_Edge& edge) {
    Chain chain;
    chain.edge = id;
    std::vector<gp_Pnt2d> places;  // of the corners
    EdgeOnFace onFace(edge, forward_, plane_, box_);
    lacksCurves_ = lacksCurves_ || onFace.lacksCurve();
    if (onFace.isAstray(divided, divided_.points, surface_)) {
      onFace.dropCurve();
      result_.repairs.push_back("the curve of edge " + std::to_string(id) +
                                " in its parameters was in the wrong place; computed again");
    }
    chain.reversed = (edge.Orientation() == TopAbs_REVERSED) != reversed_;
    auto stop = divided.stops.begin();
    chain.corners.reserve(divided.points.size());
    places.reserve(divided.points.size());
    for (std::uint32_t i = 0; i < divided.points.size(); ++i) {
      const Point3& position = divided_.points[divided.points[i]];
      const gp_Pnt2d uv = onFace.at(divided.parameters[i], position);
      if (i == 0) checkSeam(id, uv);
      places.push_back(uv);
      chain.corners.push_back(
          {VertexId(divided.points[i]), surface_.boundaryPoint(position, uv.X(), uv.Y())});
      if (stop == divided.stops.end() || *stop != i) continue;
      ++stop;
      Chain rest{chain.edge, chain.reversed, i, {chain.corners.back()}};
      addDirected(std::exchange(chain, std::move(rest)), std::exchange(places, {uv}));
    }
    addDirected(std::move(chain), places);
  }

  void addDirected(Chain chain, const std::vector<gp_Pnt2d>& places) {
    if (!isInCell(chain, places)) return;
    if (chain.reversed) std::reverse(chain.corners.begin(), chain.corners.end());
    chains_.push_back(std::move(chain));
  }

  /// Those on other faces.
  void noteTwins() {
    for (const Chain& chain : chains_) {
      const int twin = divided_.edges[static_cast<std::size_t>(chain.edge) - 1].twin;
      if (twin == 0 || std::ranges::find(chains_, twin, &Chain::edge) != chains_.end()) continue;
      result_.notes.push_back("edge " + std::to_string(chain.edge) + " runs along edge " +
                              std::to_string(twin) + " and uses its vertices");
    }
  }

  /// The surface may turn over at an edge that was taken for a point although it can be seen: what
  /// counts there is how it lies a segment away.
  void takeNormalsBesidePoints() {
    std::map<VertexId, Point3> sums;
    for (const int id : result_.pointEdges) {
      const auto& point = divided_.edges[static_cast<std::size_t>(id) - 1].point;
      if (point) sums[VertexId(*point)] = {};
    }
    if (sums.empty()) return;
    const auto add = [&](const BoundaryCorner& corner, const BoundaryCorner& beside) {
      const auto found = sums.find(corner.vertex);
      if (found != sums.end()) found->second = found->second + beside.point.normal;
    };
    const auto turn = [&](BoundaryCorner& corner) {
      const auto found = sums.find(corner.vertex);
      if (found != sums.end() && length(found->second) > 0)
        corner.point.normal = unit(found->second);
    };
    for (const Chain& chain : chains_) {
      add(chain.corners.front(), chain.corners[1]);
      add(chain.corners.back(), chain.corners[chain.corners.size() - 2]);
    }
    for (Chain& chain : chains_) {
      turn(chain.corners.front());
      turn(chain.corners.back());
    }
  }

  VertexId addVertex(std::uint32_t point) {
    result_.points.push_back(point);
    return VertexId(result_.points.size() - 1);
  }

  void addUses(const Chain& chain) {
    for (std::uint32_t i = 0; i + 1 < chain.corners.size(); ++i)
      result_.uses.push_back({chain.edge, chain.firstSegment + i});
  }

  /// Vertices inside the face that stand on no edge of it.
  void addIsolatedVertices() {
    std::optional<std::unordered_set<std::uint32_t>> known;  // points, once there is such a vertex
    for (TopoDS_Iterator it(forward_); it.More(); it.Next()) {
      if (it.Value().ShapeType() != TopAbs_VERTEX) continue;
      if (!known) known.emplace(result_.points.begin(), result_.points.end());
      const TopoDS_Vertex vertex = TopoDS::Vertex(it.Value());
      const auto point = static_cast<std::uint32_t>(model_.vertices.FindIndex(vertex) - 1);
      if (!known->insert(point).second) continue;
      const Point3& position = divided_.points[point];
      // The file may not say where on the surface such a vertex lies; it is rare, so look.
      const gp_Pnt2d uv =
          ShapeAnalysis_Surface(BRep_Tool::Surface(forward_)).ValueOfUV(toOcc(position), 1e-7);
      if (cell_ && !isInCell({}, {uv})) continue;
      const VertexId id = addVertex(point);
      result_.input.isolated.push_back({id, surface_.boundaryPoint(position, uv.X(), uv.Y())});
      result_.input.vertexCount = result_.points.size();
    }
  }

  /// Of the wanted size: sides of a seam are farther apart in the parameters, edges that were made
  /// one are not.
  static constexpr double kMaxApart = 2 * kMaxBetweenTouching;
  static constexpr double kOnCrease = 1e-6;  // of the parameters of the face

  const ModelShape& model_;
  const DividedEdges& divided_;
  const FaceSurface& surface_;
  int face_;
  const FaceCell* cell_;           ///< null: all of the face
  SplineSurface::Box box_;         ///< that all of the face takes up
  std::vector<FaceOnFace> lying_;  // on this face
  TopoDS_Face forward_;
  std::optional<gp_Pln> plane_;
  bool reversed_ = false;
  bool lacksCurves_ = false;  ///< in the parameters
  std::vector<Chain> chains_;
  std::unordered_map<int, gp_Pnt2d> starts_;  // by edge: where it begins; looked up only
  std::vector<std::size_t> wire_;             // by chain
  std::size_t wires_ = 0;
  FaceBoundary result_;
};

}  // namespace

FaceBoundary findBoundary(const ModelShape& model, int face, const DividedEdges& divided,
                          const FaceSurface& surface, const std::vector<FaceOnFace>& onFaces) {
  return BoundaryFinder(model, face, divided, surface, onFaces).find();
}

FaceBoundary findBoundary(const ModelShape& model, int face, const FaceCell& cell,
                          const DividedEdges& divided, const FaceSurface& surface) {
  return BoundaryFinder(model, face, divided, surface, {}, &cell).find();
}

}  // namespace af2::geometry
