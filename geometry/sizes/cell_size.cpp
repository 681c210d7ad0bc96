#include "geometry/sizes/cell_size.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "geometry/base/box_tree.h"

namespace af2::geometry {
namespace {

using Cell = std::array<std::uint32_t, 4>;

std::size_t cornersOf(const Cell& cell) {
  return static_cast<std::size_t>(std::ranges::find(cell, SizeCells::kNone) - cell.begin());
}

/// The nearest point of a cell, as weights of its corners. From so far away that distances are not
/// finite, any corner will do.
struct Foot {
  double distance = std::numeric_limits<double>::infinity();
  std::array<double, 4> weights{1, 0, 0, 0};
};

class FootFinder {
 public:
  FootFinder(const SizeCells& cells, const Cell& cell, const Point3& p)
      : cells_(cells), cell_(cell), p_(p) {}

  Foot find() {
    const std::size_t corners = cornersOf(cell_);
    if (corners == 4) tryInside();
    if (corners == 4 && best_.distance > 0)
      for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}})
        tryTriangle(a, b, c);
    if (corners == 3) tryTriangle(0, 1, 2);
    if (corners == 2) trySegment(0, 1);
    if (corners == 1) take({1, 0, 0, 0});
    return best_;
  }

 private:
  const Point3& at(int i) const { return cells_.vertices[cell_[static_cast<std::size_t>(i)]]; }

  void take(const std::array<double, 4>& weights) {
    Point3 place{};
    for (int i = 0; i < 4; ++i)
      if (weights[static_cast<std::size_t>(i)] != 0)
        place = place + weights[static_cast<std::size_t>(i)] * at(i);
    const double d = distance(place, p_);
    if (d < best_.distance) best_ = {d, weights};
  }

  /// A tetrahedron without volume has no inside.
  void tryInside() {
    const Point3 &a = at(0), &b = at(1), &c = at(2), &d = at(3);
    const auto volume = [](const Point3& u, const Point3& v, const Point3& w) {
      return dot(cross(u, v), w);
    };
    const double all = volume(b - a, c - a, d - a);
    if (all == 0) return;
    const double atB = volume(p_ - a, c - a, d - a) / all, atC = volume(b - a, p_ - a, d - a) / all,
                 atD = volume(b - a, c - a, p_ - a) / all, atA = 1 - atB - atC - atD;
    if (std::min({atA, atB, atC, atD}) >= 0) best_ = {0, {atA, atB, atC, atD}};
  }

  void tryTriangle(int i, int j, int k) {
    const Point3 u = at(j) - at(i), v = at(k) - at(i), w = p_ - at(i);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
    const double all = uu * vv - uv * uv;
    const double atJ = all > 0 ? (vv * wu - uv * wv) / all : -1,
                 atK = all > 0 ? (uu * wv - uv * wu) / all : -1;
    if (atJ >= 0 && atK >= 0 && atJ + atK <= 1) {
      std::array<double, 4> weights{};
      weights[static_cast<std::size_t>(i)] = 1 - atJ - atK;
      weights[static_cast<std::size_t>(j)] = atJ;
      weights[static_cast<std::size_t>(k)] = atK;
      return take(weights);
    }
    trySegment(i, j);
    trySegment(j, k);
    trySegment(k, i);
  }

  void trySegment(int i, int j) {
    const Point3 along = at(j) - at(i);
    const double all = dot(along, along);
    const double t = all > 0 ? std::clamp(dot(p_ - at(i), along) / all, 0.0, 1.0) : 0;
    std::array<double, 4> weights{};
    weights[static_cast<std::size_t>(i)] = 1 - t;
    weights[static_cast<std::size_t>(j)] += t;
    take(weights);
  }

  const SizeCells& cells_;
  const Cell& cell_;
  const Point3& p_;
  Foot best_;
};

/// Lowers the size of a vertex until no neighbour in a cell is smaller than the growth allows:
/// smallest first, as in Dijkstra's algorithm.
void grade(SizeCells& cells, double growth) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> edges;
  for (const Cell& cell : cells.cells)
    for (std::size_t i = 0; i < cornersOf(cell); ++i)
      for (std::size_t j = 0; j < cornersOf(cell); ++j)
        if (cell[i] != cell[j]) edges.emplace_back(cell[i], cell[j]);
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < cells.sizes.size(); ++v) queue.emplace(cells.sizes[v], v);
  while (!queue.empty()) {
    const auto [size, from] = queue.top();
    queue.pop();
    if (size > cells.sizes[from]) continue;
    for (auto edge = std::ranges::lower_bound(edges, Edge{from, 0});
         edge != edges.end() && edge->first == from; ++edge) {
      const std::uint32_t to = edge->second;
      const double most = size + growth * distance(cells.vertices[from], cells.vertices[to]);
      if (most >= cells.sizes[to]) continue;
      cells.sizes[to] = most;
      queue.emplace(most, to);
    }
  }
}

std::vector<Box3> boxesOf(const SizeCells& cells) {
  std::vector<Box3> boxes;
  for (const Cell& cell : cells.cells) {
    Box3& box = boxes.emplace_back();
    for (std::size_t i = 0; i < cornersOf(cell); ++i) box.add(cells.vertices[cell[i]]);
  }
  return boxes;
}

}  // namespace

void checkCells(const SizeCells& cells) {
  if (cells.cells.empty()) throw InputError("a field of sizes has no cells");
  if (cells.sizes.size() != cells.vertices.size())
    throw InputError("a field of sizes has " + std::to_string(cells.sizes.size()) + " sizes for " +
                     std::to_string(cells.vertices.size()) + " vertices");
  for (const Cell& cell : cells.cells)
    for (std::size_t i = 0; i < std::max<std::size_t>(1, cornersOf(cell)); ++i)
      if (cell[i] >= cells.vertices.size())
        throw InputError("a cell of a field of sizes has a vertex that is none");
  for (std::size_t v = 0; v < cells.vertices.size(); ++v) {
    const Point3& p = cells.vertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError("a vertex of a field of sizes has a coordinate that is not a number");
    if (!std::isfinite(cells.sizes[v]) || !(cells.sizes[v] > 0))
      throw InputError("a field of sizes has the size " + std::to_string(cells.sizes[v]) + " at (" +
                       std::to_string(p.x) + ", " + std::to_string(p.y) + ", " +
                       std::to_string(p.z) + "); a size is a number greater than 0");
  }
}

struct CellSize::Prepared {
  explicit Prepared(SizeCells graded) : cells(std::move(graded)), tree(boxesOf(cells)) {}
  SizeCells cells;
  BoxTree tree;
};

CellSize::CellSize(SizeCells cells, double growth) {
  grade(cells, growth);
  prepared_ = std::make_shared<const Prepared>(std::move(cells));
}

double CellSize::at(const Point3& p) const {
  const SizeCells& cells = prepared_->cells;
  const auto footOn = [&](std::uint32_t cell) {
    return FootFinder(cells, cells.cells[cell], p).find();
  };
  const std::uint32_t nearest =
      prepared_->tree.nearest(p, std::numeric_limits<double>::infinity(),
                              [&](std::uint32_t cell) { return footOn(cell).distance; });
  const Foot foot = footOn(nearest);
  double size = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (foot.weights[i] != 0) size += foot.weights[i] * cells.sizes[cells.cells[nearest][i]];
  return size;
}

}  // namespace af2::geometry
