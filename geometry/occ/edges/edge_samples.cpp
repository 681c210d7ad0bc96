#include "geometry/occ/edges/edge_samples.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/place_text.h"
#include "geometry/edges/curve_division.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_cells.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/sizes/wanted_along_edge.h"

namespace af2::geometry {

namespace {

/// Samples per wanted segment: position errors are then a few thousandths of a segment.
constexpr double kSamplesPerSegment = 10;
constexpr double kMaxSamples = 2e6;
constexpr const char* kNoNumbers = "has a curve with values that are not numbers";

/// Chord between unit tangents beyond which a curve has a kink, i.e. an angle of about 20 degrees.
constexpr double kKink = 0.35;

/// However short an edge is against the wanted size, it may have this many segments to follow its
/// turns: a small hole is to stay a hole.
constexpr double kSegmentsForTurns = 6;

struct CurvePoint {
  Point3 position, tangent;  ///< tangent of any length
};

CurvePoint pointAt(const BRepAdaptor_Curve& curve, double parameter) {
  gp_Pnt position;
  gp_Vec tangent;
  curve.D1(parameter, position, tangent);
  return {toPoint(position), toPoint(tangent)};
}

/// The part of a curve that makes an edge.
struct Extent {
  double first, last;
};

/// Parameters at which the curve changes its formula, and the ends.
std::vector<double> breaksOf(const BRepAdaptor_Curve& curve, Extent extent) {
  const int count = curve.NbIntervals(GeomAbs_C1);
  TColStd_Array1OfReal bounds(1, count + 1);
  curve.Intervals(bounds, GeomAbs_C1);
  std::vector<double> breaks{extent.first};
  for (const double bound : bounds)
    if (bound > extent.first && bound < extent.last) breaks.push_back(bound);
  breaks.push_back(extent.last);
  return breaks;
}

double roughLength(const BRepAdaptor_Curve& curve) {
  constexpr int kChords = 24;
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  double sum = 0;
  Point3 previous = toPoint(curve.Value(first));
  for (int i = 1; i <= kChords; ++i) {
    const Point3 next = toPoint(curve.Value(first + (last - first) * i / kChords));
    sum += distance(previous, next);
    previous = next;
  }
  return sum;
}

/// At the ends of an interval the derivative may be that of the neighbour: it is taken just inside.
double insetOf(double low, double high) { return 1e-7 * (high - low); }

/// Samples one interval in which the curve is smooth.
class IntervalSampler {
 public:
  IntervalSampler(const BRepAdaptor_Curve& curve, const WantedAlongEdge& wanted,
                  const CadSizes& sizes, double length)
      : curve_(curve),
        wanted_(wanted),
        turn_(sizes.edgeTurn),
        least_(std::min(sizes.edgeLeast * wanted.largest(), length / kSegmentsForTurns)) {}

  /// Appends the interval to a piece. `atStart` and `atEnd` become the unit tangents at its ends.
  void append(EdgePiece& piece, const IntervalCells& cells, Point3& atStart, Point3& atEnd) {
    const std::vector<double>& parameters = cells.parameters;
    const double low = parameters.front(), high = parameters.back();
    CurvePoint before = pointAt(curve_, low + insetOf(low, high));
    atStart = unit(before.tangent);
    if (piece.parameters.size() == 0) addPoint(piece, low, 0, before.position);
    for (std::size_t i = 1; i < parameters.size(); ++i) {
      const bool isLast = i + 1 == parameters.size();
      const double parameter = parameters[i];
      const double step = cells.step > 0 ? cells.step : parameter - parameters[i - 1];
      const CurvePoint here = pointAt(curve_, isLast ? high - insetOf(low, high) : parameter);
      const double ds = (length(before.tangent) + length(here.tangent)) / 2 * step;
      addPoint(piece, parameter, piece.arcLength.back() + ds, here.position);
      limitByTurn(piece, distance(unit(before.tangent), unit(here.tangent)), ds);
      before = here;
    }
    atEnd = unit(before.tangent);
  }

 private:
  void addPoint(EdgePiece& piece, double parameter, double arcLength, const Point3& position) {
    piece.parameters.edit().push_back(parameter);
    piece.arcLength.edit().push_back(arcLength);
    piece.positions.edit().push_back(position);
    const WantedAlongEdge::Size size = wanted_.at(position, parameter);
    piece.sizes.push_back(size.wanted);
    piece.least.edit().push_back(size.least);
  }

  /// The last cell turns by `turn` within `ds`.
  void limitByTurn(EdgePiece& piece, double turn, double ds) const {
    double size = std::numeric_limits<double>::infinity();
    if (turn * piece.sizes.back() > turn_ * ds) size = std::max(turn_ * ds / turn, least_);
    if (turn > 0) size = std::min(size, longestChord(ds / turn, wanted_.chord()));
    for (std::size_t i = piece.sizes.size() - 2; i < piece.sizes.size(); ++i)
      piece.sizes[i] = std::min(piece.sizes[i], size);
  }

  const BRepAdaptor_Curve& curve_;
  const WantedAlongEdge& wanted_;
  double turn_, least_;
};

/// Brings sizes along a piece below those that are wanted by position, and between the bounds.
void limitByPosition(const EdgePiece& piece, const PositionSize& function, const CadSizes& bounds,
                     std::vector<double>& sizes) {
  const bool areLeast = std::ranges::equal(sizes, piece.least, std::ranges::less_equal{});
  if (function && !areLeast) function.lower(piece.positions, sizes);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sizes[i] = std::clamp(sizes[i], piece.least[i], bounds.maxSize);
}

void limitByPosition(std::vector<EdgePiece>& pieces, const CadSizes& sizes) {
  for (EdgePiece& piece : pieces) limitByPosition(piece, sizes.function, sizes, piece.sizes);
}

/// Room for so many samples.
void reserve(EdgePiece& piece, std::size_t count) {
  piece.parameters.edit().reserve(count);
  piece.arcLength.edit().reserve(count);
  piece.positions.edit().reserve(count);
  piece.sizes.reserve(count);
  piece.least.edit().reserve(count);
}

std::vector<EdgePiece> sampleInCells(const BRepAdaptor_Curve& curve, const WantedAlongEdge& wanted,
                                     const CadSizes& sizes, double length, const Cells& cells) {
  IntervalSampler sampler(curve, wanted, sizes, length);
  std::vector<EdgePiece> pieces;
  Point3 previousEnd;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double low = cells[i].parameters.front(), high = cells[i].parameters.back();
    Point3 atStart, atEnd;
    const bool smooth =
        i > 0 &&
        distance(previousEnd, unit(pointAt(curve, low + insetOf(low, high)).tangent)) < kKink;
    if (!smooth) reserve(pieces.emplace_back(), cells[i].parameters.size());
    sampler.append(pieces.back(), cells[i], atStart, atEnd);
    previousEnd = atEnd;
  }
  return pieces;
}

/// The parameter at which an edge begins, as seen from one of its ends. A curve may end next to its
/// vertex, within the tolerance, and pass the vertex before its end: the part after the point
/// nearest to the vertex is left out.
double beginOf(const BRepAdaptor_Curve& curve, double end, double otherEnd,
               const TopoDS_Vertex& vertex, double wanted) {
  constexpr double kBeside = 0.01;  // share of the wanted size
  constexpr int kSteps = 64;        // to the middle
  if (vertex.IsNull()) return end;
  const gp_Pnt place = BRep_Tool::Pnt(vertex);
  const double gap = place.Distance(curve.Value(end));
  if (!(gap > kBeside * wanted)) return end;
  const auto at = [&](int step) { return end + (otherEnd - end) * step / (2 * kSteps); };
  for (int step = 1; step <= kSteps; ++step)
    if (place.Distance(curve.Value(at(step))) > gap) return at(step - 1);
  return end;
}

/// The part of a curve that lies between the vertices of its edge.
Extent extentOf(const BRepAdaptor_Curve& curve, const TopoDS_Edge& edge, double wanted) {
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  return {beginOf(curve, first, last, TopExp::FirstVertex(forward), wanted),
          beginOf(curve, last, first, TopExp::LastVertex(forward), wanted)};
}

/// One edge of a model, to be sampled as finely as it takes.
class EdgeSampler {
 public:
  EdgeSampler(const BRepAdaptor_Curve& curve, const ModelShape& model, int edge,
              const CadSizes& sizes)
      : sizes_(sizes),
        curve_(curve),
        wanted_(model, edge, sizes),
        extent_(extentOf(curve, model.edge(edge), wanted())),
        length_(roughLength(curve)) {}

  double wanted() const { return wanted_.largest(); }
  /// How many samples the wanted size alone takes.
  double fewest() const { return kSamplesPerSegment * length_ / wanted(); }

  Cells equalCells(double total) const {
    return geometry::equalCells(breaksOf(curve_, extent_), total);
  }
  std::vector<EdgePiece> pieces(const Cells& cells) const {
    return sampleInCells(curve_, wanted_, sizes_, length_, cells);
  }

 private:
  const CadSizes& sizes_;
  const BRepAdaptor_Curve& curve_;
  WantedAlongEdge wanted_;
  Extent extent_;
  double length_;
};

void samplePlain(const ModelShape& model, int edge, const CadSizes& sizes, EdgeSamples& samples) {
  const BRepAdaptor_Curve curve(model.edge(edge));
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) {
    samples.problem = "is infinite";
    return;
  }
  if (!(last > first)) return;
  samples.start = toPoint(curve.Value(first));
  samples.end = toPoint(curve.Value(last));
  const EdgeSampler sampler(curve, model, edge, sizes);
  samples.wanted = sampler.wanted();
  const double total = sampler.fewest();
  if (std::isnan(total))
    samples.problem = kNoNumbers;
  else if (total > kMaxSamples)
    samples.problem = "needs more than " + textOf(total / kSamplesPerSegment, 3) +
                      " segments; ask for a larger size";
  else
    samples.pieces = sampler.pieces(sampler.equalCells(total));
}

/// Samples more densely where cells are long against the sizes that are wanted by position.
void resample(const ModelShape& model, int edge, const CadSizes& sizes, EdgeSamples& samples) {
  constexpr int kMaxRounds = 4;
  // All cells become shorter first, so that no place between samples is missed that wants less.
  constexpr double kMaxEqual = 4e4;
  double tooCoarse = coarseness(samples.pieces);
  if (tooCoarse <= 1) return;
  const BRepAdaptor_Curve curve(model.edge(edge));
  const EdgeSampler sampler(curve, model, edge, sizes);
  double total = sampler.fewest();
  Cells cells = sampler.equalCells(total);
  for (int round = 0; round < kMaxRounds && tooCoarse > 1; ++round) {
    total = partsFor(tooCoarse) * std::max(total, double(kMinCells));
    cells = total < kMaxEqual ? sampler.equalCells(total) : finer(cells, samples.pieces);
    if (countOf(cells) > kMaxSamples) return;
    samples.pieces = sampler.pieces(cells);
    limitByPosition(samples.pieces, sizes);
    tooCoarse = coarseness(samples.pieces);
  }
}

/// Does something with the curve of an edge that may turn out to be unusable.
template <class Use>
void tryCurve(EdgeSamples& samples, Use&& use) {
  try {
    use();
  } catch (const Standard_Failure& failure) {
    samples.problem = std::string("has no usable curve (") + failure.DynamicType()->Name() + ")";
  }
  samples.length = 0;
  for (const EdgePiece& piece : samples.pieces) samples.length += piece.arcLength.back();
  if (samples.problem.empty() && !std::isfinite(samples.length)) samples.problem = kNoNumbers;
  if (!samples.problem.empty()) samples.pieces.clear();
}

}  // namespace

EdgeSamples sampleEdge(const ModelShape& model, int edge, const CadSizes& sizes) {
  EdgeSamples samples;
  if (BRep_Tool::Degenerated(model.edge(edge))) return samples;
  tryCurve(samples, [&] { samplePlain(model, edge, sizes, samples); });
  return samples;
}

EdgeSamples limitedByPosition(const ModelShape& model, int edge, const CadSizes& sizes,
                              EdgeSamples samples) {
  limitByPosition(samples.pieces, sizes);
  if (sizes.function || sizes.elementsPerTurn > 0)
    tryCurve(samples, [&] { resample(model, edge, sizes, samples); });
  return samples;
}

bool isWithinLimits(const PositionSize& function, const CadSizes& sizes, const EdgeSamples& samples,
                    bool areDense) {
  if (!areDense && coarseness(samples.pieces) > 1) return false;
  std::vector<double> limited;
  return std::ranges::all_of(samples.pieces, [&](const EdgePiece& piece) {
    limited = piece.sizes;
    limitByPosition(piece, function, sizes, limited);
    return limited == piece.sizes;
  });
}

void gradeSizes(EdgeSamples& samples, double first, double last, double growth) {
  if (samples.pieces.empty()) return;
  double& front = samples.pieces.front().sizes.front();
  double& back = samples.pieces.back().sizes.back();
  front = std::min(front, first);
  back = std::min(back, last);
  for (std::size_t i = 0; i < samples.pieces.size(); ++i) {
    std::vector<double>& sizes = samples.pieces[i].sizes;
    if (i > 0) sizes.front() = std::min(sizes.front(), samples.pieces[i - 1].sizes.back());
    gradeAlong(samples.pieces[i].arcLength, sizes, growth);
  }
  for (std::size_t i = samples.pieces.size() - 1; i-- > 0;) {
    std::vector<double>& sizes = samples.pieces[i].sizes;
    sizes.back() = std::min(sizes.back(), samples.pieces[i + 1].sizes.front());
    gradeAlong(samples.pieces[i].arcLength, sizes, growth);
  }
}

}  // namespace af2::geometry
