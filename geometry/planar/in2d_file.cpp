#include "geometry/planar/in2d_file.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>

#include "geometry/planar/word_file.h"

namespace af2::geometry {
namespace {

class In2dReader {
 public:
  explicit In2dReader(const std::filesystem::path& path) : file_(path) {
    curves_.name = path.string();
  }

  PlanarCurves read() {
    file_.expectLine("'splinecurves2dv2'");
    const bool isOld = file_.word(0) == "splinecurves2d";
    if (!isOld && file_.word(0) != "splinecurves2dv2")
      file_.fail("only files that begin with 'splinecurves2d' or 'splinecurves2dv2' can be read");
    file_.expectLine("the grading");
    file_.number(0, "the grading");  // of another mesher; --grading is ours
    isOld ? readCounted() : readSections();
    if (curves_.curves.empty()) file_.fail("the file contains no segments");
    numberNamedBoundaries();
    return std::move(curves_);
  }

 private:
  /// The old kind: a number of points, which are numbered in their order, and one of segments.
  void readCounted() {
    file_.expectLine("the number of points");
    const long points = file_.countAt(0, "number of points");
    for (long i = 1; i <= points; ++i) {
      file_.expectLine("point " + std::to_string(i) + " of " + std::to_string(points));
      index_[i] = static_cast<int>(curves_.points.size());
      curves_.points.push_back({file_.number(0, "x"), file_.number(1, "y")});
    }
    file_.expectLine("the number of segments");
    const long segments = file_.countAt(0, "number of segments");
    for (long i = 1; i <= segments; ++i) {
      file_.expectLine("segment " + std::to_string(i) + " of " + std::to_string(segments));
      addCurve();
    }
  }

  void readSections() {
    enum { kNowhere, kPoints, kSegments, kMaterials } section = kNowhere;
    while (file_.next()) {
      if (file_.word(0) == "points")
        section = kPoints;
      else if (file_.word(0) == "segments")
        section = kSegments;
      else if (file_.word(0) == "materials")
        section = kMaterials;
      else if (section == kPoints)
        addPoint();
      else if (section == kSegments && isFlag(file_.word(0)) && !curves_.curves.empty())
        takeFlags(0);  // of a curve that takes several lines
      else if (section == kSegments)
        addCurve();
      else if (section == kMaterials)
        addMaterial();
      else
        file_.fail("expected 'points', 'segments' or 'materials'");
    }
  }

  void addPoint() {
    const long id = file_.whole(0, "number of a point");
    if (!index_.try_emplace(id, static_cast<int>(curves_.points.size())).second)
      file_.fail("point " + std::to_string(id) + " is defined a second time");
    curves_.points.push_back({file_.number(1, "x"), file_.number(2, "y")});
  }

  int pointAt(std::size_t word) const {
    const long id = file_.whole(word, "number of a point");
    const auto found = index_.find(id);
    if (found == index_.end()) file_.fail("there is no point " + std::to_string(id));
    return found->second;
  }

  void addCurve() {
    PlanarCurves::Curve curve;
    curve.left = static_cast<int>(file_.countAt(0, "number of the domain on the left"));
    curve.right = static_cast<int>(file_.countAt(1, "number of the domain on the right"));
    curve.line = file_.line();
    if (file_.count() > 2 &&
        (file_.word(2) == "bsplinepoints" || file_.word(2) == "discretepoints")) {
      addPoles(std::move(curve), file_.word(2) == "bsplinepoints");
      return;
    }
    const long count = file_.whole(2, "number of points");
    if (count != 2 && count != 3) file_.fail("a segment has two or three points");
    curve.from = pointAt(3);
    curve.to = pointAt(static_cast<std::size_t>(2 + count));
    if (count == 3) curve.control = pointAt(4);
    addWithFlags(std::move(curve), static_cast<std::size_t>(3 + count));
  }

  /// first  the first word that may be a flag
  void addWithFlags(PlanarCurves::Curve curve, std::size_t first) {
    curves_.curves.push_back(std::move(curve));
    takeFlags(first);
  }

  /// Of the last curve.
  void takeFlags(std::size_t first) {
    PlanarCurves::Curve& curve = curves_.curves.back();
    curve.maxSize = maxSizeFrom(first).value_or(curve.maxSize);
    const std::string_view number = flag(first, "-bc=");
    std::string_view name = flag(first, "-bcname=");
    if (const auto value = numberIn<long>(number))
      curve.boundary = checkedNumber(*value);
    else if (name.empty())
      name = number;  // some write the name there
    if (!name.empty()) nameBoundary(std::string(name), curve.boundary);
  }

  int checkedNumber(long boundary) const {
    if (boundary < -kMaxItems || boundary > kMaxItems)
      file_.fail("boundary " + std::to_string(boundary) + ": numbers go up to " +
                 std::to_string(kMaxItems));
    return static_cast<int>(boundary);
  }

  /// Of the last curve.
  void nameBoundary(const std::string& name, int number) {
    if (number == 0) {
      named_.emplace_back(curves_.curves.size() - 1, name);
      return;
    }
    const auto [known, isNew] = curves_.boundaryNames.try_emplace(number, name);
    if (!isNew && known->second != name)
      file_.fail("boundary " + std::to_string(number) + " has the name '" + known->second +
                 "' already; give this segment another number");
  }

  void numberNamedBoundaries() {
    int highest = 0;
    for (const PlanarCurves::Curve& curve : curves_.curves)
      highest = std::max(highest, curve.boundary);
    std::map<std::string, int> numbers;
    for (const auto& [number, name] : curves_.boundaryNames) numbers.try_emplace(name, number);
    for (const auto& [curve, name] : named_) {
      const auto [known, isNew] = numbers.try_emplace(name, highest + 1);
      if (isNew) curves_.boundaryNames[++highest] = name;
      curves_.curves[curve].boundary = known->second;
    }
  }

  /// Coordinates instead of numbers of points, on one line or on several.
  void addPoles(PlanarCurves::Curve curve, bool isBSpline) {
    const long count = file_.countAt(3, "number of points");
    std::size_t word = 4;
    curve.order = 2;  // straight from point to point
    if (isBSpline) {
      curve.order = static_cast<int>(file_.countAt(word++, "order of the B-spline"));
      if (curve.order < 2 || curve.order > kHighestOrder)
        file_.fail("a B-spline has order 2 to " + std::to_string(kHighestOrder));
    }
    if (count < curve.order)
      file_.fail("a curve of order " + std::to_string(curve.order) +
                 " has at least as many points");
    const auto next = [&](const char* what) {
      while (word >= file_.count()) {
        file_.expectLine("a point of the curve");
        word = 0;
      }
      return file_.number(word++, what);
    };
    for (long i = 0; i < count; ++i) {
      const double x = next("x"), y = next("y");
      curve.poles.push_back({x, y});
    }
    curve.from = static_cast<int>(curves_.points.size());
    curve.to = curve.from + 1;
    curves_.points.push_back(curve.poles.front());
    curves_.points.push_back(curve.poles.back());
    addWithFlags(std::move(curve), word);
  }

  void addMaterial() {
    const int domain = static_cast<int>(file_.countAt(0, "number of a domain"));
    if (file_.count() < 2) file_.fail("the name of the domain is missing");
    curves_.domainNames[domain] = std::string(file_.word(1));
    if (const auto size = maxSizeFrom(2)) curves_.domainSizes[domain] = *size;
  }

  static bool isFlag(std::string_view word) {
    return word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1]));
  }

  /// What follows `name` where that begins one of the words from `first` on; else empty.
  std::string_view flag(std::size_t first, std::string_view name) const {
    for (std::size_t i = first; i < file_.count(); ++i)
      if (const std::string_view word = file_.word(i); word.starts_with(name))
        return word.substr(name.size());
    return {};
  }

  std::optional<double> maxSizeFrom(std::size_t first) const {
    const std::string_view word = flag(first, "-maxh=");
    if (word.empty()) return std::nullopt;
    const auto size = numberIn<double>(word);
    if (!size || !(*size > 0)) file_.fail("'" + std::string(word) + "' is not a size");
    return size;
  }

  static constexpr int kHighestOrder = 20;

  WordFile file_;
  PlanarCurves curves_;
  std::map<long, int> index_;
  std::vector<std::pair<std::size_t, std::string>> named_;  // boundaries without a number, by curve
};

/// A point of a B-spline whose knots are equally far apart, but for those at its ends, where it
/// goes through its first and last pole: by repeated interpolation between poles.
Point2 pointOnBSpline(const std::vector<Point2>& poles, int order, double t) {
  const auto degree = static_cast<std::size_t>(order) - 1;
  const std::size_t spans = poles.size() - degree;
  const double x = t * static_cast<double>(spans);
  const std::size_t span = std::min(static_cast<std::size_t>(x), spans - 1);
  const auto knot = [&](std::size_t i) {  // 0 for the first degree + 1, then 1, 2, ...
    return static_cast<double>(i <= degree ? 0 : std::min(i - degree, spans));
  };
  std::vector<Point2> near(poles.begin() + static_cast<std::ptrdiff_t>(span),
                           poles.begin() + static_cast<std::ptrdiff_t>(span + degree + 1));
  for (std::size_t round = 1; round <= degree; ++round)
    for (std::size_t i = degree; i >= round; --i) {
      const double low = knot(span + i), high = knot(span + i + degree + 1 - round);
      const double share = (x - low) / (high - low);
      near[i] = (1 - share) * near[i - 1] + share * near[i];
    }
  return near[degree];
}

/// The parameters between which a curve is almost straight.
std::vector<double> stepsOf(const PlanarCurves::Curve& curve) {
  constexpr std::size_t kSteps = 64, kStepsInSpan = 16;
  std::size_t steps = 1;
  if (curve.control) steps = kSteps;
  if (curve.order == 2) steps = curve.poles.size() - 1;
  if (curve.order > 2)
    steps = std::max(
        kSteps, kStepsInSpan * (curve.poles.size() + 1 - static_cast<std::size_t>(curve.order)));
  std::vector<double> parameters;
  for (std::size_t i = 0; i <= steps; ++i)
    parameters.push_back(static_cast<double>(i) / static_cast<double>(steps));
  return parameters;
}

}  // namespace

PlanarCurves readIn2d(const std::filesystem::path& path) { return In2dReader(path).read(); }

Point2 pointOn(const PlanarCurves& curves, const PlanarCurves::Curve& curve, double t) {
  const auto at = [&](int i) { return curves.points[static_cast<std::size_t>(i)]; };
  const Point2 a = at(curve.from), c = at(curve.to);
  if (t == 0) return a;
  if (t == 1) return c;
  if (curve.order > 0) return pointOnBSpline(curve.poles, curve.order, t);
  if (!curve.control) return a + t * (c - a);
  const Point2 b = at(*curve.control);
  const double legs = (dot(b - a, b - a) + dot(c - b, c - b)) / 2;
  if (!(legs > 0)) return a;
  const double weight = std::sqrt(dot(c - a, c - a) / legs);
  const double wa = (1 - t) * (1 - t), wb = weight * t * (1 - t), wc = t * t;
  return (1 / (wa + wb + wc)) * (wa * a + wb * b + wc * c);
}

PlanarDomain domainOf(const PlanarCurves& curves) {
  PlanarDomain domain;
  domain.name = curves.name;
  domain.points = curves.points;
  domain.keepsPoints = false;  // some are control points
  domain.domainNames = curves.domainNames;
  domain.domainSizes = curves.domainSizes;
  domain.markerNames = curves.boundaryNames;
  const auto shared = std::make_shared<const PlanarCurves>(curves);
  for (std::size_t c = 0; c < curves.curves.size(); ++c) {
    const PlanarCurves::Curve& curve = curves.curves[c];
    PlanarDomain::Segment segment;
    segment.line = curve.line;
    segment.edge = static_cast<int>(c) + 1;
    segment.left = curve.left;
    segment.right = curve.right;
    segment.maxSize = curve.maxSize;
    segment.marker = curve.boundary;
    const std::vector<double> steps = stepsOf(curve);
    if (steps.size() > 2)
      domain.curves[segment.edge] = [shared, c](double t) {
        return pointOn(*shared, shared->curves[c], t);
      };
    segment.to = curve.from;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      segment.from = segment.to;
      segment.fromParameter = steps[i - 1];
      segment.toParameter = steps[i];
      segment.to = curve.to;
      if (i + 1 < steps.size()) {
        segment.to = static_cast<int>(domain.points.size());
        domain.points.push_back(pointOn(curves, curve, steps[i]));
      }
      domain.segments.push_back(segment);
    }
  }
  return domain;
}

}  // namespace af2::geometry
