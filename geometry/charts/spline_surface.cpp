#include "geometry/charts/spline_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "geometry/base/turns.h"

namespace af2::geometry {

namespace {

constexpr std::size_t kMax = SplineSurface::kMaxDegree + 1;  // coefficients in one direction

bool isBasis(const SplineBasis& basis) {
  if (basis.degree < 1 || basis.degree > SplineSurface::kMaxDegree) return false;
  const auto order = static_cast<std::size_t>(basis.degree) + 1;
  if (basis.knots.size() < 2 * order) return false;
  if (!std::all_of(basis.knots.begin(), basis.knots.end(),
                   [](double t) { return std::isfinite(t); }))
    return false;
  return std::is_sorted(basis.knots.begin(), basis.knots.end()) && basis.low() < basis.high();
}

/// The matrix, by rows, from the poles that bear on a span to the coefficients of Bernstein's
/// polynomials on it: coefficient j is the polar form at the start of the span (degree - j times)
/// and its end (j times), found by de Boor's algorithm.
std::vector<double> bezierMatrix(const SplineBasis& basis, std::size_t knot) {
  const auto p = static_cast<std::size_t>(basis.degree);
  const std::vector<double>& t = basis.knots;
  std::vector<double> matrix((p + 1) * (p + 1));
  std::array<double, kMax> d;
  for (std::size_t pole = 0; pole <= p; ++pole) {
    for (std::size_t j = 0; j <= p; ++j) {
      d.fill(0);
      d[pole] = 1;
      for (std::size_t r = 1; r <= p; ++r) {
        const double x = r <= j ? t[knot + 1] : t[knot];
        for (std::size_t i = 0; i + r <= p; ++i) {
          const double low = t[knot + r + i - p], high = t[knot + 1 + i];
          d[i] = ((high - x) * d[i] + (x - low) * d[i + 1]) / (high - low);
        }
      }
      matrix[j * (p + 1) + pole] = d[0];
    }
  }
  return matrix;
}

/// Calls use(c), c being a constant: `count`, if that is small, else 0. What is done a known number
/// of times is done several times as fast.
template <class Use>
auto withConstant(std::size_t count, Use&& use) {
  switch (count) {
    case 2:
      return use(std::integral_constant<std::size_t, 2>());
    case 3:
      return use(std::integral_constant<std::size_t, 3>());
    case 4:
      return use(std::integral_constant<std::size_t, 4>());
    default:
      return use(std::integral_constant<std::size_t, 0>());
  }
}

/// Bernstein's polynomials at a place, and their derivatives up to Order.
///
/// Count  how many there are; 0: as many as the degree says
template <int Order, std::size_t Count>
struct Bernstein {
  using Values = std::array<double, Count == 0 ? kMax : Count>;
  std::array<Values, Order + 1> by;

  Bernstein(int degree, double t, double perUnit) {
    const std::size_t p = Count == 0 ? static_cast<std::size_t>(degree) : Count - 1;
    Values& b = by[0];
    const double s = 1 - t;
    b[0] = 1;
    for (std::size_t n = 1; n <= p; ++n) {
      // b holds those of degree n - 1.
      if constexpr (Order >= 2)
        if (n + 1 == p) differences<2>(n - 1, perUnit * perUnit * static_cast<double>(p * (p - 1)));
      if (n == p) differences<1>(n - 1, perUnit * static_cast<double>(p));
      b[n] = t * b[n - 1];
      for (std::size_t i = n - 1; i > 0; --i) b[i] = s * b[i] + t * b[i - 1];
      b[0] = s * b[0];
    }
    if constexpr (Order >= 2)
      if (p == 1) by[2][0] = by[2][1] = 0;
  }

 private:
  /// The derivative of order K from the polynomials of degree `degree`, which is K less.
  template <int K>
  void differences(std::size_t degree, double factor) {
    const Values& b = by[0];
    Values& d = by[K];
    const auto at = [&](std::size_t i, std::size_t back) {
      return i >= back && i - back <= degree ? b[i - back] : 0.0;
    };
    for (std::size_t i = 0; i <= degree + K; ++i) {
      if constexpr (K == 1)
        d[i] = factor * (at(i, 1) - at(i, 0));
      else
        d[i] = factor * (at(i, 2) - 2 * at(i, 1) + at(i, 0));
    }
  }
};

}  // namespace

SplineSurface::Spans::Spans(const SplineBasis& basis, double from, double to)
    : degree_(basis.degree), period_(basis.period) {
  for (auto k = static_cast<std::size_t>(basis.degree); k < basis.poleCount(); ++k) {
    if (!(basis.knots[k] < basis.knots[k + 1])) continue;
    breaks_.push_back(basis.knots[k]);
    knots_.push_back(k);
  }
  breaks_.push_back(basis.high());
  for (std::size_t i = 0; i < knots_.size(); ++i)
    perUnit_.push_back(1 / (breaks_[i + 1] - breaks_[i]));
  last_ = knots_.size() - 1;
  spansPerUnit_ = static_cast<double>(knots_.size()) / (breaks_.back() - breaks_.front());
  if (period_ > 0) return;
  const auto spanOf = [&](double parameter) {
    const auto end = breaks_.end() - 1;
    return static_cast<std::size_t>(
        std::max<std::ptrdiff_t>(
            std::upper_bound(breaks_.begin(), end, parameter) - breaks_.begin(), 1) -
        1);
  };
  first_ = std::max<std::size_t>(spanOf(from), 1) - 1;
  last_ = std::min(spanOf(to) + 1, last_);
}

double SplineSurface::Spans::brought(double parameter) const {
  if (!(period_ > 0) || (parameter >= breaks_.front() && parameter <= breaks_.back()))
    return parameter;
  return intoPeriod(parameter, breaks_.front(), period_);
}

/// Beyond the ends the first and the last one.
std::size_t SplineSurface::Spans::spanAt(double x) const {
  std::size_t low = 0, high = knots_.size();
  // Mostly spans are alike.
  const double guess =
      std::min(spansPerUnit_ * (x - breaks_.front()), static_cast<double>(high - 1));
  const std::size_t likely = guess > 0 ? static_cast<std::size_t>(guess) : 0;
  const bool isBelow = likely + 1 < high && !(x < breaks_[likely + 1]);
  if (!isBelow && (likely == 0 || !(x < breaks_[likely]))) return likely;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (x < breaks_[middle] ? high : low) = middle;
  }
  return low;
}

std::optional<SplineSurface::Spans::Place> SplineSurface::Spans::find(double parameter) const {
  const double x = brought(parameter);
  const std::size_t low = spanAt(x);
  if (low < first_ || low > last_) return std::nullopt;
  return Place{low - first_, (x - breaks_[low]) * perUnit_[low], perUnit_[low]};
}

SplineSurface::SplineSurface(Spans u, Spans v, bool isRational)
    : u_(std::move(u)),
      v_(std::move(v)),
      isRational_(isRational),
      stride_(4 + 4 * static_cast<std::size_t>((u_.degree() + 1) * (v_.degree() + 1))) {}

std::optional<SplineSurface> SplineSurface::make(const SplineDefinition& definition, const Box& box,
                                                 std::size_t mostNumbers) {
  if (!isBasis(definition.u) || !isBasis(definition.v)) return std::nullopt;
  const std::size_t poles = definition.u.poleCount() * definition.v.poleCount();
  const bool isRational = !definition.weights.empty();
  if (definition.poles.size() != poles) return std::nullopt;
  if (isRational && definition.weights.size() != poles) return std::nullopt;
  SplineSurface surface(Spans(definition.u, box.u1, box.u2), Spans(definition.v, box.v1, box.v2),
                        isRational);
  if (surface.u_.count() > mostNumbers / surface.stride_ / surface.v_.count()) return std::nullopt;
  surface.fill(definition);
  return surface;
}

void SplineSurface::fill(const SplineDefinition& definition) {
  numbers_.resize(u_.count() * v_.count() * stride_);
  std::vector<std::vector<double>> toBezierV;
  for (std::size_t j = 0; j < v_.count(); ++j)
    toBezierV.push_back(bezierMatrix(definition.v, v_.knotOf(j)));
  for (std::size_t i = 0; i < u_.count(); ++i) {
    const std::vector<double> toBezierU = bezierMatrix(definition.u, u_.knotOf(i));
    for (std::size_t j = 0; j < v_.count(); ++j)
      fillPatch(definition, i, j, toBezierU, toBezierV[j]);
  }
}

void SplineSurface::fillPatch(const SplineDefinition& definition, std::size_t iu, std::size_t iv,
                              const std::vector<double>& toBezierU,
                              const std::vector<double>& toBezierV) {
  const auto nu = static_cast<std::size_t>(u_.degree()) + 1;
  const auto nv = static_cast<std::size_t>(v_.degree()) + 1;
  const std::size_t firstU = u_.knotOf(iu) + 1 - nu, firstV = v_.knotOf(iv) + 1 - nv;
  const auto poleAt = [&](std::size_t i, std::size_t j) {
    return (firstU + i) * definition.v.poleCount() + firstV + j;
  };
  double* out = numbers_.data() + (iu * v_.count() + iv) * stride_;
  // Relative to one of its poles, so that derivatives do not suffer far from the origin.
  const Point3 origin = definition.poles[poleAt(0, 0)];
  out[0] = origin.x, out[1] = origin.y, out[2] = origin.z;
  out += 4;

  std::vector<double> alongV(4 * nu * nv, 0.0);  // Bezier by v, still poles by u
  for (std::size_t i = 0; i < nu; ++i) {
    for (std::size_t m = 0; m < nv; ++m) {
      const std::size_t pole = poleAt(i, m);
      const double weight = isRational_ ? definition.weights[pole] : 1;
      const Point3 p = weight * (definition.poles[pole] - origin);
      const std::array<double, 4> homogeneous{p.x, p.y, p.z, weight};
      for (std::size_t j = 0; j < nv; ++j)
        for (std::size_t k = 0; k < 4; ++k)
          alongV[4 * (i * nv + j) + k] += toBezierV[j * nv + m] * homogeneous[k];
    }
  }
  const std::size_t row = 4 * nv;
  for (std::size_t i = 0; i < nu; ++i)
    for (std::size_t m = 0; m < nu; ++m)
      for (std::size_t k = 0; k < row; ++k)
        out[i * row + k] += toBezierU[i * nu + m] * alongV[m * row + k];
}

/// x, y, z and weight, which a processor handles two or four at a time.
struct Four {
  using Pair = double __attribute__((vector_size(16)));
  Pair xy{}, zw{};

  void add(double factor, const Four& numbers) {
    const Pair factors{factor, factor};
    xy += factors * numbers.xy;
    zw += factors * numbers.zw;
  }
  static Four at(const double* numbers) {
    Four four;
    four.xy = Pair{numbers[0], numbers[1]};
    four.zw = Pair{numbers[2], numbers[3]};
    return four;
  }
};

/// What Bernstein's polynomials sum up to: [a][b] is the derivative a times by u, b times by v.
template <int Order>
struct SplineSurface::Sums {
  std::array<std::array<Four, Order + 1>, Order + 1> by;
  Point3 origin;

  Point3 point(std::size_t a, std::size_t b) const {
    return {by[a][b].xy[0], by[a][b].xy[1], by[a][b].zw[0]};
  }
  double weight(std::size_t a, std::size_t b) const { return by[a][b].zw[1]; }
};

template <int Order>
SplineSurface::Sums<Order> SplineSurface::sumsAt(const Spans::Place& u,
                                                 const Spans::Place& v) const {
  const auto nu = static_cast<std::size_t>(u_.degree()) + 1;
  const auto nv = static_cast<std::size_t>(v_.degree()) + 1;
  constexpr std::size_t kQuintic = 6;  // what many programs write for free forms
  if (nu == kQuintic && nv == kQuintic) return sumsOf<Order, kQuintic, kQuintic>(u, v);
  return withConstant(nu, [&](auto inU) {
    return withConstant(nv, [&](auto inV) { return sumsOf<Order, inU, inV>(u, v); });
  });
}

/// CountU, CountV  how many coefficients there are by u and v; 0: as many as the degrees say
template <int Order, std::size_t CountU, std::size_t CountV>
SplineSurface::Sums<Order> SplineSurface::sumsOf(const Spans::Place& u,
                                                 const Spans::Place& v) const {
  const Bernstein<Order, CountU> bu(u_.degree(), u.local, u.perUnit);
  const Bernstein<Order, CountV> bv(v_.degree(), v.local, v.perUnit);
  const std::size_t nu = CountU == 0 ? static_cast<std::size_t>(u_.degree()) + 1 : CountU;
  const std::size_t nv = CountV == 0 ? static_cast<std::size_t>(v_.degree()) + 1 : CountV;
  const double* coefficient = patch(u.span, v.span);
  Sums<Order> sums;
  sums.origin = {coefficient[0], coefficient[1], coefficient[2]};
  for (std::size_t i = 0; i < nu; ++i) {
    std::array<Four, Order + 1> row;
    for (std::size_t j = 0; j < nv; ++j) {
      coefficient += 4;
      const Four pole = Four::at(coefficient);
      for (std::size_t b = 0; b <= Order; ++b) row[b].add(bv.by[b][j], pole);
    }
    for (std::size_t a = 0; a <= Order; ++a)
      for (std::size_t b = 0; a + b <= Order; ++b) sums.by[a][b].add(bu.by[a][i], row[b]);
  }
  return sums;
}

std::optional<SurfaceFrame> SplineSurface::frameAt(double u, double v) const {
  const auto atU = u_.find(u), atV = v_.find(v);
  if (!atU || !atV) return std::nullopt;
  const Sums<1> s = sumsAt<1>(*atU, *atV);
  if (!isRational_) return SurfaceFrame{s.origin + s.point(0, 0), s.point(1, 0), s.point(0, 1)};
  const double inverse = 1 / s.weight(0, 0);
  const Point3 position = inverse * s.point(0, 0);
  return SurfaceFrame{s.origin + position, inverse * (s.point(1, 0) - s.weight(1, 0) * position),
                      inverse * (s.point(0, 1) - s.weight(0, 1) * position)};
}

std::optional<SurfaceJet> SplineSurface::jetAt(double u, double v) const {
  const auto atU = u_.find(u), atV = v_.find(v);
  if (!atU || !atV) return std::nullopt;
  const Sums<2> s = sumsAt<2>(*atU, *atV);
  if (!isRational_)
    return SurfaceJet{s.origin + s.point(0, 0),
                      s.point(1, 0),
                      s.point(0, 1),
                      s.point(2, 0),
                      s.point(1, 1),
                      s.point(0, 2)};
  const double inverse = 1 / s.weight(0, 0);
  const Point3 p = inverse * s.point(0, 0);
  const Point3 du = inverse * (s.point(1, 0) - s.weight(1, 0) * p);
  const Point3 dv = inverse * (s.point(0, 1) - s.weight(0, 1) * p);
  return SurfaceJet{
      s.origin + p,
      du,
      dv,
      inverse * (s.point(2, 0) - 2 * s.weight(1, 0) * du - s.weight(2, 0) * p),
      inverse * (s.point(1, 1) - s.weight(1, 0) * dv - s.weight(0, 1) * du - s.weight(1, 1) * p),
      inverse * (s.point(0, 2) - 2 * s.weight(0, 1) * dv - s.weight(0, 2) * p)};
}

}  // namespace af2::geometry
