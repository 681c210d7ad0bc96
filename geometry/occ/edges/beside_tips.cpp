#include "geometry/occ/edges/beside_tips.h"

#include <Standard_Failure.hxx>
#include <algorithm>
#include <exception>
#include <optional>
#include <set>

#include "geometry/occ/edges/edge_line.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

/// The fan reaches this share of the way to the edge.
constexpr double kReach = 0.5;
/// The rim of the fan is divided by this.
constexpr double kAround = 4;

class TipNeighbors {
 public:
  TipNeighbors(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
               const std::map<std::uint32_t, double>& tips, const std::vector<bool>& isGiven,
               std::vector<EdgeSamples>& samples)
      : model_(model),
        sizes_(sizes),
        ends_(ends),
        tips_(tips),
        isGiven_(isGiven),
        samples_(samples) {}

  /// Whether an edge passes near by a tip of the face.
  bool limitAt(int face) {
    std::set<std::size_t> edges;
    std::map<std::uint32_t, Point3> tips;
    for (const EdgeUse& use : model_.edgesOfFaces[static_cast<std::size_t>(face) - 1]) {
      const auto edge = static_cast<std::size_t>(use.id) - 1;
      if (samples_[edge].pieces.empty()) continue;
      edges.insert(edge);
      if (tips_.contains(ends_[edge].first)) tips[ends_[edge].first] = samples_[edge].start;
      if (tips_.contains(ends_[edge].last)) tips[ends_[edge].last] = samples_[edge].end;
    }
    bool isAny = false;
    for (const auto& [point, place] : tips) {
      const std::optional<double> angle = angleAt(face, place);
      if (!angle) continue;  // another face's tip
      const auto nearest = nearestTo(edges, point, place);
      if (!nearest) continue;
      limit(edges, place, *nearest, kReach * *angle / kAround);
      isAny = true;
    }
    return isAny;
  }

 private:
  std::optional<double> angleAt(int face, const Point3& place) const {
    for (const SharpTip& tip : model_.surface(face).sharpTips())
      if (distance(tip.position, place) < tip.slack) return tip.angle;
    return std::nullopt;
  }

  /// How far it is to the nearest edge that does not end at a tip, if that is within the fan.
  std::optional<double> nearestTo(const std::set<std::size_t>& edges, std::uint32_t point,
                                  const Point3& place) const {
    constexpr double kMin = 1e-3;  // of the size
    const double reach = tips_.at(point) / kReach;
    std::optional<double> nearest;
    for (const std::size_t edge : edges) {
      if (ends_[edge].first == point || ends_[edge].last == point) continue;
      const EdgeLine line(model_, edge, samples_[edge]);
      const auto foot = line.footOf(place, nearest ? std::min(*nearest, reach) : reach);
      if (foot && foot->distance > kMin * samples_[edge].wanted) nearest = foot->distance;
    }
    return nearest;
  }

  void limit(const std::set<std::size_t>& edges, const Point3& place, double nearest,
             double share) {
    CadSizes here = sizes_;
    here.function = PositionSize([=](const Point3& position) {
      return share * std::max(nearest, distance(position, place));
    });
    for (const std::size_t edge : edges)
      if (!isGiven_[edge])
        samples_[edge] =
            limitedByPosition(model_, static_cast<int>(edge) + 1, here, std::move(samples_[edge]));
  }

  const ModelShape& model_;
  const CadSizes& sizes_;
  const std::vector<Ends>& ends_;
  const std::map<std::uint32_t, double>& tips_;
  const std::vector<bool>& isGiven_;
  std::vector<EdgeSamples>& samples_;
};

}  // namespace

bool limitBesideTips(const ModelShape& model, const CadSizes& sizes, const std::vector<Ends>& ends,
                     const std::map<std::uint32_t, double>& tips, const std::vector<bool>& isGiven,
                     std::vector<EdgeSamples>& samples) {
  if (tips.empty()) return false;
  TipNeighbors neighbors(model, sizes, ends, tips, isGiven, samples);
  bool isAny = false;
  for (int face = 1; face <= model.faces.Extent(); ++face) {
    try {
      if (neighbors.limitAt(face)) isAny = true;
    } catch (const std::exception&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
  }
  return isAny;
}

}  // namespace af2::geometry
