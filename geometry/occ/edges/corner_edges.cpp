#include "geometry/occ/edges/corner_edges.h"

#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "engine/base/elementary.h"
#include "geometry/occ/edges/edge_on_face.h"
#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

/// Segments next to a short edge are at most this many times longer.
constexpr double kMaxOfLength = 2;
/// But no shorter than this share of the size: around a tiny edge that would take too many.
constexpr double kMinShare = 0.02;

/// From an end of an edge to a place on it as far away as that.
Point3 awayFrom(const EdgeSamples& samples, bool first, double reach) {
  const EdgePiece& piece = first ? samples.pieces.front() : samples.pieces.back();
  const std::vector<double>& s = piece.arcLength;
  if (first) {
    const auto i = std::ranges::lower_bound(s, reach) - s.begin();
    const auto last = static_cast<std::ptrdiff_t>(s.size()) - 1;
    return piece.positions[static_cast<std::size_t>(std::min(i, last))] - piece.positions.front();
  }
  const auto i = std::ranges::upper_bound(s, s.back() - reach) - s.begin();
  return piece.positions[static_cast<std::size_t>(std::max<std::ptrdiff_t>(i - 1, 0))] -
         piece.positions.back();
}

/// By how much one direction turns to the left into another, seen against a normal.
double turnBetween(const Point3& from, const Point3& to, const Point3& normal) {
  return angleOf({dot(from, to), dot(unit(normal), cross(from, to))});
}

/// One face around its short edges.
class FaceCorners {
 public:
  FaceCorners(const ModelShape& model, int face, const std::vector<Ends>& ends,
              const std::vector<EdgeSamples>& samples)
      : model_(model),
        face_(face),
        forward_(TopoDS::Face(model.face(face).Oriented(TopAbs_FORWARD))),
        samples_(samples),
        atPoint_(endsByPoint(uses(), ends, samples)) {}

  /// Whether the face gets wider from an edge on.
  bool opensFrom(const EdgeUse& use, const Ends& ends) {
    constexpr double kMinOpening = 0.5;  // radians between the edges beyond the ends
    const std::size_t edge = indexOf(use);
    const EdgeSamples& samples = samples_[edge];
    const std::optional<Point3> before = beyond(edge, ends.first), after = beyond(edge, ends.last);
    if (!before || !after) return false;
    if (!surface_) surface_.emplace(model_.surface(face_));
    const std::vector<double>& parameters = samples.pieces[samples.pieces.size() / 2].parameters;
    const Point3 normal =
        normalOnEdge(*surface_, forward_, use.edge, parameters[parameters.size() / 2]);
    if (!(length(normal) > 0)) return false;
    const Point3 along = samples.end - samples.start;
    double turn = turnBetween(-1.0 * *before, along, normal) + turnBetween(along, *after, normal);
    if (use.edge.Orientation() == TopAbs_REVERSED) turn = -turn;
    return turn < std::numbers::pi - kMinOpening;
  }

  const std::vector<EdgeUse>& uses() const {
    return model_.edgesOfFaces[static_cast<std::size_t>(face_) - 1];
  }
  static std::size_t indexOf(const EdgeUse& use) { return static_cast<std::size_t>(use.id - 1); }

 private:
  /// Along the one other edge at a point; none if there are more.
  std::optional<Point3> beyond(std::size_t edge, std::uint32_t point) const {
    const std::vector<EdgeEnd>& there = atPoint_.at(point);
    if (there.size() != 2) return std::nullopt;
    const EdgeEnd& other = there[there[0].edge == edge ? 1 : 0];
    const Point3 way =
        awayFrom(samples_[other.edge], other.isStart, kMaxOfLength * samples_[edge].length);
    return length(way) > 0 ? std::optional(way) : std::nullopt;
  }

  const ModelShape& model_;
  int face_;
  TopoDS_Face forward_;
  const std::vector<EdgeSamples>& samples_;
  std::map<std::uint32_t, std::vector<EdgeEnd>> atPoint_;
  std::optional<FaceSurface> surface_;
};

bool isShort(const EdgeSamples& samples, const Ends& ends) {
  if (samples.pieces.empty() || ends.first == ends.last) return false;
  double largest = 0;
  for (const EdgePiece& piece : samples.pieces)
    largest = std::max(largest, *std::ranges::max_element(piece.sizes));
  return kMaxOfLength * samples.length < largest;
}

}  // namespace

void limitAtShortEdges(const ModelShape& model, const CadSizes& sizes,
                       const std::vector<Ends>& ends, std::vector<EdgeSamples>& samples) {
  std::vector<bool> isAtOpenCorner;
  for (std::size_t i = 0; i < samples.size(); ++i)
    isAtOpenCorner.push_back(!sizes.edgeSizes.contains(static_cast<int>(i) + 1) &&
                             isShort(samples[i], ends[i]));
  for (int face = 1; face <= model.faces.Extent(); ++face) {
    const auto& uses = model.edgesOfFaces[static_cast<std::size_t>(face) - 1];
    const auto isWorthALook = [&](const EdgeUse& use) {
      return isAtOpenCorner[FaceCorners::indexOf(use)];
    };
    if (std::ranges::none_of(uses, isWorthALook)) continue;
    try {
      FaceCorners corners(model, face, ends, samples);
      for (const EdgeUse& use : uses) {
        const std::size_t i = FaceCorners::indexOf(use);
        if (isWorthALook(use)) isAtOpenCorner[i] = corners.opensFrom(use, ends[i]);
      }
    } catch (const std::exception&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!isAtOpenCorner[i]) continue;
    const double limit =
        bounded(sizes, std::max(kMaxOfLength * samples[i].length, kMinShare * samples[i].wanted));
    for (EdgePiece& piece : samples[i].pieces)
      for (double& size : piece.sizes) size = std::min(size, limit);
  }
}

}  // namespace af2::geometry
