#include "geometry/occ/edges/tip_fans.h"

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/occ/base/points.h"
#include "geometry/occ/model/face_surfaces.h"

namespace af2::geometry {

namespace {

/// Three would lean by 60 degrees against the surface, and a front hardly goes on from their rim.
constexpr double kFewestAround = 4;
/// Two quadrilaterals around a tip have flat corners there: they need three pairs of triangles.
constexpr double kFewestForQuads = 5;
constexpr double kWidest = std::numbers::pi / 3;  // angle of an element at the tip

/// Around a blunter tip a front has room.
constexpr double kSharp = 3.3;

struct TipOfModel {
  double angle = 0;
  double length = std::numeric_limits<double>::infinity();  ///< of the shortest edge there
  double size = std::numeric_limits<double>::infinity();    ///< that is wanted
};

/// The vertices of a face that are sharp tips of its surface.
void findTips(const ModelShape& model, int face, std::map<std::uint32_t, TipOfModel>& found) {
  const std::vector<SharpTip> tips = model.surfaces->sharpTipsOf(model.face(face), face);
  if (tips.empty()) return;
  for (TopExp_Explorer it(model.face(face), TopAbs_VERTEX); it.More(); it.Next()) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(it.Current());
    const Point3 position = toPoint(BRep_Tool::Pnt(vertex));
    for (const SharpTip& tip : tips) {
      if (distance(position, tip.position) >= tip.slack || tip.angle > kSharp) continue;
      const auto point = static_cast<std::uint32_t>(model.vertices.FindIndex(vertex) - 1);
      found[point].angle = tip.angle;
    }
  }
}

/// For quadrilaterals an even number.
int elementsAround(const FaceSurface& surface, const SharpTip& tip, const SurfacePoint& from,
                   const SurfacePoint& to, FanElements kind) {
  constexpr double kRounding = 0.01;
  const double angle = surface.angleAroundTip(from, to, tip.position);
  const bool areQuads = kind == FanElements::Quads;
  const double around = (areQuads ? kFewestForQuads : kFewestAround) * angle / tip.angle;
  const int count =
      static_cast<int>(std::max({1.0, std::ceil(around - kRounding), std::round(angle / kWidest)}));
  return areQuads ? count + count % 2 : count;
}

class FanCutter {
 public:
  FanCutter(const FaceSurface& surface, FanElements kind, FaceBoundary& boundary)
      : surface_(surface), kind_(kind), tips_(surface.sharpTips()), boundary_(boundary) {}

  void cut() {
    if (tips_.empty()) return;
    for (auto& loop : boundary_.input.loops) cutFrom(loop);
    renumber();
  }

 private:
  using Loop = std::vector<BoundaryCorner>;

  std::optional<SharpTip> tipAt(const BoundaryCorner& before, const BoundaryCorner& corner,
                                const BoundaryCorner& behind) const {
    constexpr double kSame = 0.05;
    const Point3& position = corner.point.position;
    const auto tip = std::ranges::find_if(
        tips_, [&](const SharpTip& t) { return distance(t.position, position) < t.slack; });
    if (tip == tips_.end() || tip->angle > kSharp) return std::nullopt;
    const double one = distance(before.point.position, position);
    const double other = distance(behind.point.position, position);
    return std::abs(one - other) <= kSame * one ? std::optional(*tip) : std::nullopt;
  }

  void cutFrom(Loop& loop) {
    for (std::size_t i = 0; i < loop.size() && loop.size() > 3; ++i) {
      const std::size_t before = (i + loop.size() - 1) % loop.size();
      const std::size_t behind = (i + 1) % loop.size();
      const auto tip = tipAt(loop[before], loop[i], loop[behind]);
      if (!tip || isUsedElsewhere(loop[i])) continue;
      const Loop rim = rimBetween(loop[before], loop[behind], *tip);
      FaceBoundary::Fan& fan = boundary_.fans.emplace_back();
      fan.tip = boundary_.points[loop[i].vertex.value];
      fan.place = loop[i].point;
      fan.place.normal = {};  // around a sharp tip, it differs from all nearby
      cut_.push_back(loop[i].vertex);
      fan.rim.push_back(loop[before].vertex);
      for (const BoundaryCorner& corner : rim) fan.rim.push_back(corner.vertex);
      fan.rim.push_back(loop[behind].vertex);
      boundary_.notes.push_back("has a sharp tip; " + std::to_string(rim.size() + 1) +
                                " triangles around it were made before the front");
      const auto at = loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
      loop.insert(at, rim.begin(), rim.end());
      i += rim.size();
    }
  }

  bool isUsedElsewhere(const BoundaryCorner& corner) const {
    std::ptrdiff_t uses = 0;
    for (const Loop& loop : boundary_.input.loops)
      uses += std::ranges::count(loop, corner.vertex, &BoundaryCorner::vertex);
    return uses > 1;
  }

  /// Without the ends.
  Loop rimBetween(const BoundaryCorner& from, const BoundaryCorner& to, const SharpTip& tip) {
    Loop rim;
    const int count = elementsAround(surface_, tip, from.point, to.point, kind_);
    for (int i = 1; i < count; ++i)
      rim.push_back({VertexId(boundary_.input.vertexCount++),
                     surface_.aroundTip(from.point, to.point, static_cast<double>(i) / count)});
    return rim;
  }

  /// Tips are no vertices of the loops any more.
  void renumber() {
    if (cut_.empty()) return;
    std::ranges::sort(cut_, {}, &VertexId::value);
    const auto renumbered = [&](VertexId& v) {
      const auto less = std::ranges::lower_bound(cut_, v.value, {}, &VertexId::value);
      v = VertexId(v.value - static_cast<std::uint32_t>(less - cut_.begin()));
    };
    for (Loop& loop : boundary_.input.loops)
      for (BoundaryCorner& corner : loop) renumbered(corner.vertex);
    for (BoundaryCorner& corner : boundary_.input.isolated) renumbered(corner.vertex);
    for (FaceBoundary::Fan& fan : boundary_.fans)
      for (VertexId& v : fan.rim) renumbered(v);
    boundary_.input.vertexCount -= cut_.size();
    std::erase_if(boundary_.points, [&](std::uint32_t point) {
      return std::ranges::find(boundary_.fans, point, &FaceBoundary::Fan::tip) !=
             boundary_.fans.end();
    });
  }

  const FaceSurface& surface_;
  FanElements kind_;
  std::vector<SharpTip> tips_;
  FaceBoundary& boundary_;
  std::vector<VertexId> cut_;
};

}  // namespace

std::map<std::uint32_t, double> segmentsAtTips(const ModelShape& model,
                                               const std::vector<Ends>& ends,
                                               const std::vector<EdgeSamples>& samples,
                                               const std::vector<bool>& isGiven) {
  std::map<std::uint32_t, TipOfModel> found;
  for (int face = 1; face <= model.faces.Extent(); ++face) {
    try {
      findTips(model, face, found);
    } catch (const std::exception&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
  }
  if (found.empty()) return {};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (samples[i].pieces.empty()) continue;
    const auto add = [&](std::uint32_t point, double size) {
      const auto tip = found.find(point);
      if (tip == found.end()) return;
      tip->second.length = isGiven[i] ? 0 : std::min(tip->second.length, samples[i].length);
      tip->second.size = std::min(tip->second.size, size);
    };
    add(ends[i].first, samples[i].pieces.front().sizes.front());
    add(ends[i].last, samples[i].pieces.back().sizes.back());
  }
  constexpr double kMaxOfEdge = 0.25;
  std::map<std::uint32_t, double> segments;
  for (const auto& [point, tip] : found) {
    const double length = std::min(kFewestAround * tip.size / tip.angle, kMaxOfEdge * tip.length);
    if (length > 0 && std::isfinite(length)) segments[point] = length;
  }
  return segments;
}

std::vector<double> divideFromTips(const EdgePart& part,
                                   const std::map<std::uint32_t, double>& tips, AskedSegments asked,
                                   const CadSizes& sizes) {
  constexpr double kMax = 0.4;  // of the part
  const EdgeSamples& all = part.samples;
  const auto tipAt = [&](std::uint32_t end) {
    const auto tip = tips.find(end);
    return tip != tips.end() && tip->second <= kMax * all.length ? tip : tips.end();
  };
  const auto none = tips.end(), first = tipAt(part.ends.first), last = tipAt(part.ends.last);
  std::vector<double> ends;
  if (first != none) ends.push_back(parameterAt(all, first->second));
  if (last != none) ends.push_back(parameterAt(all, all.length - last->second));
  if (ends.empty()) return divide(all, asked, sizes);
  asked.least = asked.least > ends.size() ? asked.least - ends.size() : 1;
  std::vector<double> parameters = divide(split(all, ends)[first != none ? 1 : 0], asked, sizes);
  if (first != none) parameters.insert(parameters.begin(), all.pieces.front().parameters.front());
  if (last != none) parameters.push_back(all.pieces.back().parameters.back());
  return parameters;
}

void leaveOutFans(const FaceSurface& surface, FanElements kind, FaceBoundary& boundary) {
  FanCutter(surface, kind, boundary).cut();
}

}  // namespace af2::geometry
