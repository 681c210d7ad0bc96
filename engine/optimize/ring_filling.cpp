#include "engine/optimize/ring_filling.h"

#include "engine/optimize/ring_outline.h"

namespace af2 {
namespace {

class Filler {
 public:
  Filler(const Ring& ring, const FillingPlan& plan)
      : sides_(ring.points.size(), plan.corners), plan_(plan) {
    filling_.points = ring.points;
    ringSize_ = ring.points.size();
  }

  RingFilling fill() {
    if (plan_.cut) {
      const FillingPlan::Cut& cut = *plan_.cut;
      cut_ =
          line(sides_.placeAt(cut.from, cut.fromAt), sides_.placeAt(cut.to, cut.toAt), cut.length);
      for (const Outline& part : sides_.partsOf(cut)) star(part);
    } else if (plan_.corners.size() == 4) {
      const std::vector<Path> paths = pathsOf(sides_.whole());
      grid(paths[0], paths[1], paths[2], paths[3]);
    } else {
      star(sides_.whole());
    }
    return std::move(filling_);
  }

 private:
  using Path = std::vector<std::size_t>;  ///< vertices, both ends included

  std::size_t add(Point2 point) {
    filling_.points.push_back(point);
    return filling_.points.size() - 1;
  }

  Path line(std::size_t from, std::size_t to, int sides) {
    const Point2 begin = filling_.points[from], end = filling_.points[to];
    Path path{from};
    for (int i = 1; i < sides; ++i) path.push_back(add(begin + (1.0 * i / sides) * (end - begin)));
    path.push_back(to);
    return path;
  }

  Path pathOf(const Stretch& stretch) const {
    if (stretch.line == Stretch::Line::Cut) return cut_;
    if (stretch.line == Stretch::Line::CutBackwards) return {cut_.rbegin(), cut_.rend()};
    Path path;
    for (int i = 0; i <= stretch.length; ++i)
      path.push_back((stretch.begin + static_cast<std::size_t>(i)) % ringSize_);
    return path;
  }
  std::vector<Path> pathsOf(const Outline& outline) const {
    std::vector<Path> paths;
    for (std::size_t i = 0; i < outline.size(); ++i) paths.push_back(pathOf(outline[i]));
    return paths;
  }

  /// Around each corner lies a grid between the lines to the two sides of the corner.
  void star(const Outline& outline) {
    const StarLines lengths = starLines(outline).value();
    const std::vector<Path> sides = pathsOf(outline);
    const std::size_t k = sides.size();
    const auto splitAt = [&](std::size_t i) {
      return static_cast<std::size_t>(lengths[(i + k - 1) % k]);
    };
    Point2 sum;
    for (std::size_t i = 0; i < k; ++i) sum = sum + filling_.points[sides[i][splitAt(i)]];
    const std::size_t centre = add((1.0 / static_cast<double>(k)) * sum);
    std::vector<Path> lines;
    for (std::size_t i = 0; i < k; ++i)
      lines.push_back(line(centre, sides[i][splitAt(i)], lengths[i]));
    for (std::size_t i = 0; i < k; ++i) {
      const std::size_t j = (i + 1) % k;
      const auto split = [](const Path& side, std::size_t at) {
        return side.begin() + static_cast<std::ptrdiff_t>(at);
      };
      grid(Path(split(sides[i], splitAt(i)), sides[i].end()),
           Path(sides[j].begin(), split(sides[j], splitAt(j)) + 1),
           Path(lines[j].rbegin(), lines[j].rend()), lines[i]);
    }
  }

  /// Between four lines, each of which begins where the one before it ends. The vertices inside are
  /// interpolated from all of them (a Coons patch).
  void grid(const Path& bottom, const Path& right, const Path& top, const Path& left) {
    const std::size_t m = bottom.size() - 1, n = right.size() - 1;
    std::vector<Path> rows(n + 1, Path(m + 1));
    const auto at = [&](std::size_t v) { return filling_.points[v]; };
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t i = 0; i <= m; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(m);
        const double y = static_cast<double>(j) / static_cast<double>(n);
        rows[j][i] = j == 0   ? bottom[i]
                     : j == n ? top[m - i]
                     : i == 0 ? left[n - j]
                     : i == m ? right[j]
                              : add((1 - y) * at(bottom[i]) + y * at(top[m - i]) +
                                    (1 - x) * at(left[n - j]) + x * at(right[j]) -
                                    (1 - y) * ((1 - x) * at(bottom[0]) + x * at(bottom[m])) -
                                    y * ((1 - x) * at(top[m]) + x * at(top[0])));
      }
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < m; ++i)
        filling_.quads.push_back({rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]});
  }

  RingSides sides_;
  const FillingPlan& plan_;
  std::size_t ringSize_;
  RingFilling filling_;
  Path cut_;
};

}  // namespace

RingFilling fillRing(const Ring& ring, const FillingPlan& plan) {
  return Filler(ring, plan).fill();
}

}  // namespace af2
