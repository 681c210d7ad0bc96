#include "dsl/checks/affine_form.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace af2::dsl {
namespace {

constexpr double kSame = 1e-11;  // of coefficients; they are sums of a few written numbers

Form blend(const Form& p, const Form& q, double t) {
  Form result(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) result[i] = t * p[i] + (1 - t) * q[i];
  return result;
}

FormPoint matchedVertex(std::size_t vertex, std::size_t variables) {
  FormPoint point{Form(variables + 1), Form(variables + 1)};
  if (vertex == 1) point.x[1] = 1;
  if (vertex < 2) return point;
  point.x[2 * vertex - 2] = 1;
  point.y[2 * vertex - 1] = 1;
  return point;
}

void add(Form& sum, double weight, const Form& form) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * form[i];
}

std::optional<FormPoint> formOf(const AF2PointTransform& transform,
                                const std::vector<FormPoint>& matched, std::size_t variables) {
  const auto* affine = dynamic_cast<const AffinePointTransform*>(&transform);
  if (!affine) return std::nullopt;
  FormPoint point{Form(variables + 1), Form(variables + 1)};
  point.x[0] = affine->constant().x;
  point.y[0] = affine->constant().y;
  for (const auto& term : affine->terms()) {
    add(point.x, term.xx, matched[term.vertex].x);
    add(point.x, term.xy, matched[term.vertex].y);
    add(point.y, term.yx, matched[term.vertex].x);
    add(point.y, term.yy, matched[term.vertex].y);
  }
  return point;
}

bool addZone(const ConvexPolygonZoneDef& zone, int level, AffineRule& rule,
             const std::vector<FormPoint>& matched) {
  for (const auto& corner : zone.corners()) {
    auto preferred = formOf(*corner.preferred, matched, rule.variables);
    if (!preferred) return false;
    if (corner.limiting) {
      const auto limiting = formOf(*corner.limiting, matched, rule.variables);
      if (!limiting) return false;
      const double t = zone.fade(level);
      preferred =
          FormPoint{blend(preferred->x, limiting->x, t), blend(preferred->y, limiting->y, t)};
    }
    rule.zone.push_back(std::move(*preferred));
  }
  return true;
}

/// Solves for the weights of the given corners by least squares; nothing unless they fit exactly,
/// add up to 1 and are not negative.
std::optional<Weights> solve(const FormPoint& point, const std::vector<FormPoint>& zone,
                             const std::vector<std::size_t>& corners) {
  const std::size_t n = corners.size(), m = point.x.size();
  const auto row = [&](const FormPoint& p, std::size_t k) {
    return k < m ? p.x[k] : k < 2 * m ? p.y[k - m] : 1.0;  // the last row: weights add up to 1
  };
  std::array<std::array<double, 4>, 3> a{};
  for (std::size_t k = 0; k <= 2 * m; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        a[i][j] += row(zone[corners[i]], k) * row(zone[corners[j]], k);
      a[i][3] += row(zone[corners[i]], k) * row(point, k);
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
  for (std::size_t k = 0; k <= 2 * m; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += weights[corners[i]] * row(zone[corners[i]], k);
    if (std::abs(sum - row(point, k)) > kSame) return std::nullopt;
  }
  return weights;
}

double minorOf(const Weights& p, const Weights& q, const Weights& r, std::size_t i, std::size_t j,
               std::size_t k) {
  return p[i] * (q[j] * r[k] - q[k] * r[j]) - p[j] * (q[i] * r[k] - q[k] * r[i]) +
         p[k] * (q[i] * r[j] - q[j] * r[i]);
}

/// The turn of p, q, r is the sum over i < j < k of a minor of the weights times the turn of the
/// corners i, j, k. No minor may be negative, and one must be positive.
bool haveGoodMinors(const Weights& p, const Weights& q, const Weights& r) {
  bool anyPositive = false;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j)
      for (std::size_t k = j + 1; k < p.size(); ++k) {
        const double minor = minorOf(p, q, r, i, j, k);
        if (minor < -kSame) return false;
        anyPositive = anyPositive || minor > kSame;
      }
  return anyPositive;
}

}  // namespace

std::optional<AffineRule> affineRule(const AF2Rule& rule, int level) {
  const RuleDefinition& definition = rule.definition();
  const auto* zone = dynamic_cast<const ConvexPolygonZoneDef*>(definition.zone.get());
  if (!zone) return std::nullopt;
  AffineRule result;
  const std::size_t matched = definition.vertices.size();
  result.variables = 2 * matched - 3;
  for (std::size_t i = 0; i < matched; ++i)
    result.placed.push_back(matchedVertex(i, result.variables));
  const std::vector<FormPoint> vertices = result.placed;
  for (const auto& transform : definition.newVertices) {
    const auto point = formOf(*transform, vertices, result.variables);
    if (!point) return std::nullopt;
    result.placed.push_back(*point);
  }
  if (!addZone(*zone, level, result, vertices)) return std::nullopt;
  return result;
}

std::vector<Weights> convexCombinations(const FormPoint& point,
                                        const std::vector<FormPoint>& zone) {
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

bool neverTurnRight(const FormPoint& p, const FormPoint& q, const FormPoint& r,
                    const std::vector<FormPoint>& zone) {
  const auto ofP = convexCombinations(p, zone), ofQ = convexCombinations(q, zone),
             ofR = convexCombinations(r, zone);
  for (const Weights& u : ofP)
    for (const Weights& v : ofQ)
      for (const Weights& w : ofR)
        if (haveGoodMinors(u, v, w)) return true;
  return false;
}

}  // namespace af2::dsl
