#include "dsl/proof/linear_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace af2::dsl {
namespace {

constexpr double kSame = 1e-11;  // coefficients are sums of a few numbers of the rule file

/// Coefficients of x, then of y, by constant and node. The last number is 1, so that the weights of
/// columns add up to 1.
using Column = std::vector<double>;

/// Columns with the nodes of all of the points.
std::vector<Column> columnsOf(const std::vector<const LinearPoint*>& points) {
  std::map<Node, std::size_t> place;
  for (const LinearPoint* p : points)
    for (const LinearForm* form : {&p->x, &p->y})
      for (const auto& [node, c] : form->terms) place.emplace(node, 1 + place.size());
  std::vector<Column> columns;
  const std::size_t half = place.size() + 1;
  for (const LinearPoint* p : points) {
    Column& column = columns.emplace_back(2 * half + 1);
    column.back() = 1;
    column[0] = p->x.constant;
    column[half] = p->y.constant;
    for (const auto& [node, c] : p->x.terms) column[place[node]] = c;
    for (const auto& [node, c] : p->y.terms) column[half + place[node]] = c;
  }
  return columns;
}

/// Solves for the weights of the given corners by least squares. Nothing unless they fit exactly,
/// add up to 1 and are non-negative.
std::optional<Weights> solve(const Column& point, const std::vector<Column>& zone,
                             const std::vector<std::size_t>& corners) {
  const std::size_t n = corners.size();
  std::array<std::array<double, 4>, 3> a{};
  for (std::size_t k = 0; k < point.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) a[i][j] += zone[corners[i]][k] * zone[corners[j]][k];
      a[i][3] += zone[corners[i]][k] * point[k];
    }
  for (std::size_t i = 0; i < n; ++i) {  // Gauss-Jordan with pivots
    std::size_t pivot = i;
    for (std::size_t r = i; r < n; ++r)
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    if (std::abs(a[pivot][i]) < 1e-9) return std::nullopt;
    std::swap(a[i], a[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == i) continue;
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = 0; c < 4; ++c) a[r][c] -= factor * a[i][c];
    }
  }
  Weights weights(zone.size());
  for (std::size_t i = 0; i < n; ++i) {
    const double w = a[i][3] / a[i][i];
    if (w < -kSame) return std::nullopt;
    weights[corners[i]] = std::max(w, 0.0);
  }
  for (std::size_t k = 0; k < point.size(); ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += weights[corners[i]] * zone[corners[i]][k];
    if (std::abs(sum - point[k]) > kSame) return std::nullopt;
  }
  return weights;
}

double minorOf(const Weights& p, const Weights& q, const Weights& r, std::size_t i, std::size_t j,
               std::size_t k) {
  return p[i] * (q[j] * r[k] - q[k] * r[j]) - p[j] * (q[i] * r[k] - q[k] * r[i]) +
         p[k] * (q[i] * r[j] - q[j] * r[i]);
}

/// Whether three corners are collinear at every match: all products of coordinates in their
/// orientation cancel.
bool isFlat(const Column& p, const Column& q, const Column& r) {
  const std::size_t half = (p.size() - 1) / 2;
  const auto x = [&](const Column& to, std::size_t i) { return to[i] - p[i]; };
  const auto y = [&](const Column& to, std::size_t i) { return to[half + i] - p[half + i]; };
  for (std::size_t i = 0; i < half; ++i)
    for (std::size_t j = i; j < half; ++j) {
      double product = x(q, i) * y(r, j) - y(q, i) * x(r, j);
      if (i != j) product += x(q, j) * y(r, i) - y(q, j) * x(r, i);
      if (std::abs(product) > kSame) return false;
    }
  return true;
}

/// The orientation of p, q, r is the sum over i < j < k of a minor of the weights times the
/// orientation of the corners i, j, k. No minor may be negative, and one must be positive for
/// corners that are not collinear.
bool haveGoodMinors(const Weights& p, const Weights& q, const Weights& r,
                    const std::vector<Column>& zone) {
  bool anyPositive = false;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j)
      for (std::size_t k = j + 1; k < p.size(); ++k) {
        const double minor = minorOf(p, q, r, i, j, k);
        if (minor < -kSame) return false;
        anyPositive = anyPositive || (minor > kSame && !isFlat(zone[i], zone[j], zone[k]));
      }
  return anyPositive;
}

std::vector<Weights> combinationsOf(const Column& point, const std::vector<Column>& zone) {
  std::vector<Weights> found;
  const auto attempt = [&](const std::vector<std::size_t>& corners) {
    auto weights = solve(point, zone, corners);
    if (weights && std::find(found.begin(), found.end(), *weights) == found.end())
      found.push_back(std::move(*weights));
  };
  for (std::size_t i = 0; i < zone.size(); ++i) attempt({i});
  if (!found.empty()) return found;
  for (std::size_t i = 0; i < zone.size(); ++i)
    for (std::size_t j = i + 1; j < zone.size(); ++j) attempt({i, j});
  for (std::size_t i = 0; i < zone.size(); ++i)
    for (std::size_t j = i + 1; j < zone.size(); ++j)
      for (std::size_t k = j + 1; k < zone.size(); ++k) attempt({i, j, k});
  return found;
}

}  // namespace

LinearForm sumOf(double s, const LinearForm& p, double t, const LinearForm& q) {
  LinearForm result{s * p.constant + t * q.constant, {}};
  for (const auto& [node, c] : p.terms) result.terms[node] += s * c;
  for (const auto& [node, c] : q.terms) result.terms[node] += t * c;
  // A tiny remainder of a cancellation is a rounding error.
  std::erase_if(result.terms, [](const auto& term) { return std::abs(term.second) < 1e-14; });
  return result;
}

std::vector<Weights> convexCombinations(const LinearPoint& point,
                                        const std::vector<LinearPoint>& corners) {
  std::vector<const LinearPoint*> points{&point};
  for (const LinearPoint& corner : corners) points.push_back(&corner);
  const std::vector<Column> columns = columnsOf(points);
  return combinationsOf(columns[0], {columns.begin() + 1, columns.end()});
}

bool turnLeftInConvex(const LinearPoint& p, const LinearPoint& q, const LinearPoint& r,
                      const std::vector<LinearPoint>& zone) {
  std::vector<const LinearPoint*> points{&p, &q, &r};
  for (const LinearPoint& corner : zone) points.push_back(&corner);
  const std::vector<Column> columns = columnsOf(points);
  const std::vector<Column> corners(columns.begin() + 3, columns.end());
  const auto ofP = combinationsOf(columns[0], corners), ofQ = combinationsOf(columns[1], corners),
             ofR = combinationsOf(columns[2], corners);
  for (const Weights& u : ofP)
    for (const Weights& v : ofQ)
      for (const Weights& w : ofR)
        if (haveGoodMinors(u, v, w, corners)) return true;
  return false;
}

}  // namespace af2::dsl
