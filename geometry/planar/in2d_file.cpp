#include "geometry/planar/in2d_file.h"

#include <algorithm>

#include "geometry/curve_division.h"
#include "geometry/domain_size.h"
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
    if (curves_.curves.empty()) file_.fail("the file holds no segments");
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
      else if (section == kSegments)
        addCurve();
      else if (section == kMaterials)
        addMaterial();
      else
        file_.fail("'points', 'segments' or 'materials' should stand here");
    }
  }

  void addPoint() {
    const long id = file_.whole(0, "number of a point");
    if (!index_.try_emplace(id, static_cast<int>(curves_.points.size())).second)
      file_.fail("point " + std::to_string(id) + " stands here for the second time");
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
    if (file_.count() > 2 &&
        (file_.word(2) == "bsplinepoints" || file_.word(2) == "discretepoints"))
      file_.fail("curves given by '" + std::string(file_.word(2)) +
                 "' cannot be read; write them as segments of two or three points");
    const long count = file_.whole(2, "number of points");
    if (count != 2 && count != 3) file_.fail("a segment has two or three points");
    curve.from = pointAt(3);
    curve.to = pointAt(static_cast<std::size_t>(2 + count));
    if (count == 3) curve.control = pointAt(4);
    curve.maxSize = maxSizeFrom(static_cast<std::size_t>(3 + count)).value_or(curve.maxSize);
    curve.line = file_.line();
    curves_.curves.push_back(curve);
  }

  void addMaterial() {
    const int domain = static_cast<int>(file_.countAt(0, "number of a domain"));
    if (file_.count() < 2) file_.fail("the name of the domain is missing");
    curves_.domainNames[domain] = std::string(file_.word(1));
    if (const auto size = maxSizeFrom(2)) curves_.domainSizes[domain] = *size;
  }

  /// Of the flags from a word on: -maxh=SIZE.
  std::optional<double> maxSizeFrom(std::size_t first) const {
    constexpr std::string_view kFlag = "-maxh=";
    for (std::size_t i = first; i < file_.count(); ++i) {
      std::string_view word = file_.word(i);
      if (!word.starts_with(kFlag)) continue;
      word.remove_prefix(kFlag.size());
      double size = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), size);
      if (error != std::errc() || end != word.data() + word.size() || !(size > 0))
        file_.fail("'" + std::string(word) + "' is no size");
      return size;
    }
    return std::nullopt;
  }

  WordFile file_;
  PlanarCurves curves_;
  std::map<long, int> index_;
};

/// A curve at equal steps of its parameter, with the sizes wanted there.
struct SampledPlanarCurve {
  std::vector<Point2> points;
  SampledCurve samples;
};

class Divider {
 public:
  Divider(const PlanarCurves& curves, const PlanarMeshingOptions& options)
      : curves_(curves), options_(options), size_(options) {}

  PlanarDomain divide() {
    std::vector<std::vector<Point2>> points;
    std::vector<SampledCurve> samples;
    std::vector<CurveEnds> ends;
    for (const PlanarCurves::Curve& curve : curves_.curves) {
      SampledPlanarCurve sampled = sample(curve);
      points.push_back(std::move(sampled.points));
      ends.push_back({static_cast<std::size_t>(curve.from), static_cast<std::size_t>(curve.to)});
      samples.push_back(std::move(sampled.samples));
      samples.back().ends = ends.back();
    }
    gradeTogether(samples, curves_.points.size(), options_.growth);
    const std::vector<std::size_t> least = leastSegments(ends);
    PlanarDomain domain;
    domain.name = curves_.name;
    domain.points = curves_.points;
    domain.domainNames = curves_.domainNames;
    domain.domainSizes = curves_.domainSizes;
    for (std::size_t c = 0; c < samples.size(); ++c) {
      const std::vector<double> count = segmentsAlong(samples[c].arcLength, samples[c].sizes);
      const std::size_t segments =
          options_.keepBoundary ? 1 : wholeSegments(count.back(), least[c]);
      add(curves_.curves[c], points[c], equalShares(count, segments), domain);
    }
    return domain;
  }

 private:
  double wantedAt(const PlanarCurves::Curve& curve, Point2 p) const {
    double size = curve.maxSize;
    for (const int side : {curve.left, curve.right})
      if (const auto own = curves_.domainSizes.find(side); own != curves_.domainSizes.end())
        size = std::min(size, own->second);
    return std::min(size, size_.at({p.x, p.y, 0}));
  }

  SampledPlanarCurve sample(const PlanarCurves::Curve& curve) const {
    constexpr std::size_t kSamples = 1000;
    SampledPlanarCurve result;
    for (std::size_t i = 0; i <= kSamples; ++i) {
      const Point2 p =
          pointOn(curves_, curve, static_cast<double>(i) / static_cast<double>(kSamples));
      std::vector<double>& s = result.samples.arcLength;
      s.push_back(i == 0 ? 0 : s.back() + distance(result.points.back(), p));
      result.points.push_back(p);
      result.samples.sizes.push_back(wantedAt(curve, p));
    }
    limitByTurn(result);
    return result;
  }

  void limitByTurn(SampledPlanarCurve& curve) const {
    constexpr double kGentleLeast = 0.1;
    const auto direction = [&](std::size_t i) {
      const Point2 d = curve.points[i + 1] - curve.points[i];
      return (1 / length(d)) * d;
    };
    for (std::size_t i = 0; i + 2 < curve.points.size(); ++i) {
      const double bend = distance(direction(i), direction(i + 1));
      const double step = distance(curve.points[i], curve.points[i + 2]) / 2;
      if (!(bend > 0)) continue;
      double& size = curve.samples.sizes[i + 1];
      size = size_.limitedByTurn(size, step / bend, kGentleLeast);
    }
  }

  static void add(const PlanarCurves::Curve& curve, const std::vector<Point2>& points,
                  const std::vector<CurvePlace>& places, PlanarDomain& domain) {
    int from = curve.from;
    const auto join = [&](int to) {
      domain.segments.push_back({from, to, 0, curve.line, curve.left, curve.right});
      from = to;
    };
    for (const CurvePlace& place : places) {
      domain.points.push_back(place.between(points));
      join(static_cast<int>(domain.points.size()) - 1);
    }
    join(curve.to);
  }

  const PlanarCurves& curves_;
  const PlanarMeshingOptions& options_;
  DomainSize size_;
};

}  // namespace

PlanarCurves readIn2d(const std::filesystem::path& path) { return In2dReader(path).read(); }

Point2 pointOn(const PlanarCurves& curves, const PlanarCurves::Curve& curve, double t) {
  const auto at = [&](int i) { return curves.points[static_cast<std::size_t>(i)]; };
  const Point2 a = at(curve.from), c = at(curve.to);
  if (t == 0) return a;
  if (t == 1) return c;
  if (!curve.control) return a + t * (c - a);
  const Point2 b = at(*curve.control);
  const double legs = (dot(b - a, b - a) + dot(c - b, c - b)) / 2;
  const double weight = std::sqrt(dot(c - a, c - a) / legs);
  const double wa = (1 - t) * (1 - t), wb = weight * t * (1 - t), wc = t * t;
  return (1 / (wa + wb + wc)) * (wa * a + wb * b + wc * c);
}

PlanarDomain divideCurves(const PlanarCurves& curves, const PlanarMeshingOptions& options) {
  return Divider(curves, options).divide();
}

}  // namespace af2::geometry
