#include "dsl/checks/proof.h"

#include <algorithm>
#include <cmath>

#include "dsl/checks/affine_form.h"

namespace af2::dsl {
namespace {

constexpr double kRounding = 1e-9;
constexpr int kMostBoxes = 20000;

struct Interval {
  double low, high;
  double width() const { return high - low; }
};

using Box = std::vector<Interval>;  // by variable, [0] stands for the constant 1

/// sum of m[i][j] v_i v_j with v_0 = 1; j >= i.
class Polynomial {
 public:
  explicit Polynomial(std::size_t variables)
      : size_(variables + 1), m_((variables + 1) * (variables + 1)) {}

  void addProduct(double weight, const Form& p, const Form& q) {
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j)
        m_[std::min(i, j) * size_ + std::max(i, j)] += weight * p[i] * q[j];
  }

  Polynomial minus(double weight, const Polynomial& other) const {
    Polynomial result = *this;
    for (std::size_t k = 0; k < m_.size(); ++k) result.m_[k] -= weight * other.m_[k];
    return result;
  }

  double at(const std::vector<double>& v) const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = i; j < size_; ++j) sum += m_[i * size_ + j] * v[i] * v[j];
    return sum;
  }

  std::vector<double> gradientAt(const std::vector<double>& v) const {
    std::vector<double> gradient(size_);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = i; j < size_; ++j) {
        gradient[i] += m_[i * size_ + j] * v[j];
        gradient[j] += m_[i * size_ + j] * v[i];
      }
    gradient[0] = 0;
    return gradient;
  }

  /// Bounds over a box, from the expansion about its middle: exact value, linear and quadratic
  /// part.
  Interval over(const Box& box) const {
    std::vector<double> middle, half;
    for (const Interval& side : box) {
      middle.push_back(0.5 * (side.low + side.high));
      half.push_back(0.5 * side.width());
    }
    const double value = at(middle);
    const std::vector<double> gradient = gradientAt(middle);
    double low = value, high = value;
    for (std::size_t i = 1; i < size_; ++i) {
      const double reach = std::abs(gradient[i]) * half[i];
      low -= reach;
      high += reach;
      for (std::size_t j = i; j < size_; ++j) {
        const double w = m_[i * size_ + j], size = w * half[i] * half[j];
        low -= i == j ? std::max(0.0, -size) : std::abs(size);
        high += i == j ? std::max(0.0, size) : std::abs(size);
      }
    }
    return {low, high};
  }

 private:
  std::size_t size_;
  std::vector<double> m_;
};

/// Twice the signed area of p, q, r.
Polynomial turnOf(const FormPoint& p, const FormPoint& q, const FormPoint& r,
                  std::size_t variables) {
  const auto difference = [](const Form& to, const Form& from) {
    Form result(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) result[i] = to[i] - from[i];
    return result;
  };
  Polynomial turn(variables);
  turn.addProduct(1, difference(q.x, p.x), difference(r.y, p.y));
  turn.addProduct(-1, difference(q.y, p.y), difference(r.x, p.x));
  return turn;
}

/// The matches to be looked at: a box, and polynomials that are >= -kRounding at each of them.
struct Domain {
  Box box;
  std::vector<Polynomial> facts;
};

/// tolerance - w(x - reference) >= 0
Polynomial toleranceFact(const ToleranceForm& w, Point2 reference, double tolerance,
                         std::size_t vertex, std::size_t variables) {
  Form one(variables + 1), x(variables + 1), y(variables + 1);
  one[0] = 1;
  x[0] = -reference.x;
  y[0] = -reference.y;
  x[2 * vertex - 2] = y[2 * vertex - 1] = 1;
  Polynomial fact(variables);
  fact.addProduct(tolerance, one, one);
  fact.addProduct(-w.xx, x, x);
  fact.addProduct(-w.xy, x, y);
  fact.addProduct(-w.yy, y, y);
  return fact;
}

/// Nothing if a tolerance does not bound its vertex.
std::optional<Domain> domainOf(const RuleSet& rules, const AF2Rule& rule, const AffineRule& affine,
                               int level) {
  const bool isScaled = rules.definition().unit == ChartUnit::BaseLength;
  const double tolerance = rules.matchTolerance(level);
  Domain domain{{{1, 1}, isScaled ? Interval{1, 1} : Interval{0.7, 1.4}}, {}};
  const auto& pattern = rule.definition().vertices;
  for (std::size_t i = 2; i < pattern.size(); ++i) {
    if (!pattern[i].tolerance) return std::nullopt;
    const ToleranceForm& w = *pattern[i].tolerance;
    const double det = w.xx * w.yy - 0.25 * w.xy * w.xy;
    if (!(det > 1e-9) || !(w.xx > 0)) return std::nullopt;
    const double dx = std::sqrt(tolerance * w.yy / det), dy = std::sqrt(tolerance * w.xx / det);
    const Point2 r = pattern[i].reference;
    domain.box.push_back({r.x - dx, r.x + dx});
    domain.box.push_back({r.y - dy, r.y + dy});
    domain.facts.push_back(toleranceFact(w, r, tolerance, i, affine.variables));
  }
  const auto& zone = affine.zone;
  for (std::size_t i = 0; i < zone.size(); ++i)
    for (std::size_t j = i + 1; j < zone.size(); ++j)
      for (std::size_t k = j + 1; k < zone.size(); ++k)
        domain.facts.push_back(turnOf(zone[i], zone[j], zone[k], affine.variables));
  return domain;
}

enum class Verdict { Holds, Empty, Open };

/// Whether goal >= 0 on all of a box that satisfies the facts: at once, or because it exceeds a
/// multiple of a fact.
Verdict judge(const Polynomial& goal, const Domain& domain, const Box& box) {
  if (goal.over(box).low >= -kRounding) return Verdict::Holds;
  std::vector<double> middle;
  for (const Interval& side : box) middle.push_back(0.5 * (side.low + side.high));
  const std::vector<double> slope = goal.gradientAt(middle);
  for (const Polynomial& fact : domain.facts) {
    if (fact.over(box).high < -kRounding) return Verdict::Empty;
    const std::vector<double> other = fact.gradientAt(middle);
    double along = 0, size = 0;
    for (std::size_t i = 1; i < slope.size(); ++i) {
      along += slope[i] * other[i];
      size += other[i] * other[i];
    }
    if (size == 0 || along <= 0) continue;
    if (goal.minus(along / size, fact).over(box).low >= -kRounding) return Verdict::Holds;
  }
  return Verdict::Open;
}

/// Branch and bound: splits the widest side of boxes that are still open.
bool holdsOn(const Polynomial& goal, const Domain& domain) {
  std::vector<Box> open{domain.box};
  for (int seen = 0; !open.empty(); ++seen) {
    if (seen == kMostBoxes) return false;
    Box box = std::move(open.back());
    open.pop_back();
    if (judge(goal, domain, box) != Verdict::Open) continue;
    const auto widest = std::max_element(
        box.begin() + 1, box.end(),
        [](const Interval& p, const Interval& q) { return p.width() < q.width(); });
    if (widest->width() < 1e-3) return false;  // undecided however finely it is cut
    const auto side = static_cast<std::size_t>(widest - box.begin());
    const double middle = 0.5 * (widest->low + widest->high);
    Box upper = box;
    box[side].high = upper[side].low = middle;
    open.push_back(std::move(box));
    open.push_back(std::move(upper));
  }
  return true;
}

bool liesInZone(const FormPoint& point, const std::vector<FormPoint>& zone) {
  return !convexCombinations(point, zone).empty();
}

}  // namespace

bool provesPositive(const RuleSet& rules, const AF2Rule& rule, int level) {
  const auto affine = affineRule(rule, level);
  if (!affine) return false;
  std::optional<Domain> domain;
  for (const RuleElement& element : rule.definition().elements) {
    const int n = element.size();
    for (int i = 0; i < (n == 3 ? 1 : n); ++i) {
      const FormPoint& p = affine->placed[element.corners[i]];
      const FormPoint& q = affine->placed[element.corners[(i + 1) % n]];
      const FormPoint& r = affine->placed[element.corners[(i + 2) % n]];
      if (neverTurnRight(p, q, r, affine->zone)) continue;
      if (!domain) domain = domainOf(rules, rule, *affine, level);
      if (!domain || !holdsOn(turnOf(p, q, r, affine->variables), *domain)) return false;
    }
  }
  return true;
}

bool provesCovered(const RuleSet& rules, const AF2Rule& rule, int level) {
  const auto affine = affineRule(rule, level);
  if (!affine) return false;
  const auto& zone = affine->zone;
  std::optional<Domain> domain;
  for (const RuleElement& element : rule.definition().elements)
    for (int i = 0; i < element.size(); ++i) {
      const FormPoint& p = affine->placed[element.corners[i]];
      if (liesInZone(p, zone)) continue;
      if (!domain) domain = domainOf(rules, rule, *affine, level);
      if (!domain) return false;
      for (std::size_t k = 0; k < zone.size(); ++k)
        if (!holdsOn(turnOf(zone[k], zone[(k + 1) % zone.size()], p, affine->variables), *domain))
          return false;
    }
  return true;
}

}  // namespace af2::dsl
