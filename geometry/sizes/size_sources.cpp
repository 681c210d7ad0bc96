#include "geometry/sizes/size_sources.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "engine/base/error.h"
#include "geometry/base/box_tree.h"

namespace af2::geometry {
namespace {

bool isSize(double size) { return std::isfinite(size) && size > 0; }
bool isFinite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::string numbered(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index + 1) + " of the sizes: ";
}

void check(const SizeSources& sources) {
  for (std::size_t i = 0; i < sources.points.size(); ++i) {
    const SizeSource& point = sources.points[i];
    if (!isSize(point.size)) throw InputError(numbered("point", i) + "the size must be positive");
    if (!isFinite(point.position) || !(point.radius >= 0) || !std::isfinite(point.radius))
      throw InputError(numbered("point", i) + "position and radius must be numbers, radius >= 0");
  }
  for (std::size_t i = 0; i < sources.boxes.size(); ++i) {
    const SizeBox& box = sources.boxes[i];
    if (!isSize(box.size)) throw InputError(numbered("box", i) + "the size must be positive");
    if (!(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z))
      throw InputError(numbered("box", i) + "the corner 'from' must be below 'to' in x, y and z");
  }
  for (std::size_t i = 0; i < sources.grids.size(); ++i) {
    const SizeGrid& grid = sources.grids[i];
    const auto [x, y, z] = grid.counts;
    if (x == 0 || y == 0 || z == 0 || grid.sizes.size() / x / y != z ||
        grid.sizes.size() != x * y * z)
      throw InputError(numbered("field", i) + "there are " + std::to_string(grid.sizes.size()) +
                       " sizes, not one for each of " + std::to_string(x) + " x " +
                       std::to_string(y) + " x " + std::to_string(z) + " nodes");
    if (!isFinite(grid.origin) || !isSize(grid.spacing.x) || !isSize(grid.spacing.y) ||
        !isSize(grid.spacing.z))
      throw InputError(numbered("field", i) + "the spacing must be positive in x, y and z");
    if (!std::all_of(grid.sizes.begin(), grid.sizes.end(), isSize))
      throw InputError(numbered("field", i) + "all sizes must be positive");
  }
  for (const SizeCells& cells : sources.cells) checkCells(cells);
}

/// Lowers sizes until none is larger than that of a neighbour allows.
class GridGrading {
 public:
  GridGrading(SizeGrid& grid, double growth) : grid_(grid), growth_(growth) {}

  void run() {
    const std::size_t count = grid_.sizes.size();
    bool changed = true;
    while (changed) {
      changed = false;
      for (std::size_t i = 0; i < count; ++i) changed = lower(i) || changed;
      for (std::size_t i = count; i-- > 0;) changed = lower(i) || changed;
    }
  }

 private:
  bool lower(std::size_t node) {
    const auto [nx, ny, nz] = grid_.counts;
    const std::size_t x = node % nx, y = node / nx % ny, z = node / nx / ny;
    double least = grid_.sizes[node];
    for (std::size_t k = below(z); k <= above(z, nz); ++k)
      for (std::size_t j = below(y); j <= above(y, ny); ++j)
        for (std::size_t i = below(x); i <= above(x, nx); ++i) {
          const Point3 step{difference(i, x) * grid_.spacing.x, difference(j, y) * grid_.spacing.y,
                            difference(k, z) * grid_.spacing.z};
          least = std::min(least, grid_.sizes[(k * ny + j) * nx + i] + growth_ * length(step));
        }
    // Below this, two nodes could lower each other without end.
    constexpr double kNoticeable = 1e-9;
    if (least >= grid_.sizes[node] * (1 - kNoticeable)) return false;
    grid_.sizes[node] = least;
    return true;
  }
  static std::size_t below(std::size_t i) { return i > 0 ? i - 1 : 0; }
  static std::size_t above(std::size_t i, std::size_t count) { return std::min(i + 1, count - 1); }
  static double difference(std::size_t i, std::size_t j) {
    return static_cast<double>(i) - static_cast<double>(j);
  }

  SizeGrid& grid_;
  double growth_;
};

/// Linear in each direction between the nodes; beyond the grid, as at its nearest point.
class GridSize {
 public:
  explicit GridSize(const SizeGrid& grid) : grid_(grid) {}

  double at(const Point3& p, double growth) const {
    const Point3 &low = grid_.origin, &spacing = grid_.spacing;
    const auto last = [&](std::size_t i) { return static_cast<double>(grid_.counts[i] - 1); };
    const Box3 box{
        low,
        {low.x + last(0) * spacing.x, low.y + last(1) * spacing.y, low.z + last(2) * spacing.z}};
    const Place x = placeOf(p.x, grid_.origin.x, grid_.spacing.x, grid_.counts[0]);
    const Place y = placeOf(p.y, grid_.origin.y, grid_.spacing.y, grid_.counts[1]);
    const Place z = placeOf(p.z, grid_.origin.z, grid_.spacing.z, grid_.counts[2]);
    double size = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const bool i = corner & 1, j = corner & 2, k = corner & 4;
      const double weight = x.weight(i) * y.weight(j) * z.weight(k);
      if (weight == 0) continue;
      size +=
          weight *
          grid_.sizes[((z.cell + k) * grid_.counts[1] + y.cell + j) * grid_.counts[0] + x.cell + i];
    }
    return size + growth * box.distanceTo(p);
  }

 private:
  struct Place {
    std::size_t cell = 0;
    double within = 0;
    double weight(bool upper) const { return upper ? within : 1 - within; }
  };
  static Place placeOf(double value, double origin, double spacing, std::size_t count) {
    const auto last = static_cast<double>(count - 1);
    const double along = std::clamp((value - origin) / spacing, 0.0, last);
    Place place;
    place.cell = static_cast<std::size_t>(along);
    place.within = along - static_cast<double>(place.cell);
    return place;
  }

  const SizeGrid& grid_;
};

/// All sources, ready to be asked from many threads.
struct PreparedSources {
  PreparedSources(SizeSources sources, double growthPerLength, int threads)
      : growth(growthPerLength),
        points(uncovered(sources.points, growthPerLength, threads), growthPerLength,
               std::numeric_limits<double>::infinity(), threads),
        boxes(std::move(sources.boxes)),
        grids(std::move(sources.grids)) {
    for (SizeGrid& grid : grids) GridGrading(grid, growth).run();
    for (SizeCells& field : sources.cells) cells.emplace_back(std::move(field), growth);
  }

  void lower(std::span<const Point3> at, std::span<double> sizes) const {
    points.lower(at, sizes);
    if (boxes.empty() && grids.empty() && cells.empty()) return;
    for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = std::min(sizes[i], beyondPoints(at[i]));
  }

  double beyondPoints(const Point3& p) const {
    double size = std::numeric_limits<double>::infinity();
    for (const SizeBox& box : boxes)
      size = std::min(size, box.size + growth * Box3{box.low, box.high}.distanceTo(p));
    for (const SizeGrid& grid : grids) size = std::min(size, GridSize(grid).at(p, growth));
    for (const CellSize& field : cells) size = std::min(size, field.at(p));
    return size;
  }

  double growth;
  GrowingSize points;
  std::vector<SizeBox> boxes;
  std::vector<SizeGrid> grids;
  std::vector<CellSize> cells;
};

struct SizeFromSources {
  std::shared_ptr<const PreparedSources> sources;

  void operator()(std::span<const Point3> at, std::span<double> sizes) const {
    std::ranges::fill(sizes, std::numeric_limits<double>::infinity());
    lower(at, sizes);
  }
  void lower(std::span<const Point3> at, std::span<double> sizes) const {
    sources->lower(at, sizes);
  }
};

}  // namespace

void addSources(std::vector<SizeSource> points, double least, SizeSources& sources) {
  for (SizeSource& point : points) {
    point.size = std::max(point.size, least);
    sources.points.push_back(point);
  }
}

PositionSize sizeFrom(SizeSources sources, double growth, int threads) {
  check(sources);
  return SizeFromSources{
      std::make_shared<const PreparedSources>(std::move(sources), growth, threads)};
}

}  // namespace af2::geometry
