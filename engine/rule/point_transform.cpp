#include "engine/rule/point_transform.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/error.h"

namespace af2 {
namespace {

using Term = AffinePointTransform::Term;

bool isFinite(const Term& t) {
  return std::isfinite(t.xx) && std::isfinite(t.xy) && std::isfinite(t.yx) && std::isfinite(t.yy);
}

bool isZero(const Term& t) { return t.xx == 0 && t.xy == 0 && t.yx == 0 && t.yy == 0; }

/// Sorted by vertex, one term for each vertex, without terms that contribute nothing.
std::vector<Term> normalized(std::vector<Term> terms) {
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term& s, const Term& t) { return s.vertex < t.vertex; });
  std::vector<Term> result;
  for (const Term& t : terms) {
    if (result.empty() || result.back().vertex != t.vertex) {
      result.push_back(t);
      continue;
    }
    Term& sum = result.back();
    sum = {t.vertex, sum.xx + t.xx, sum.xy + t.xy, sum.yx + t.yx, sum.yy + t.yy};
  }
  std::erase_if(result, isZero);
  return result;
}

}  // namespace

AffinePointTransform::AffinePointTransform(Point2 constant, std::vector<Term> terms)
    : constant_(constant), terms_(normalized(std::move(terms))) {
  if (!std::isfinite(constant.x) || !std::isfinite(constant.y))
    throw InputError("affine transform: the constant is not finite");
  for (const Term& t : terms_) {
    if (t.vertex < 0) throw InputError("affine transform: negative vertex index");
    if (!isFinite(t))
      throw InputError("affine transform: a coefficient of vertex " + std::to_string(t.vertex) +
                       " is not finite");
  }
}

AffinePointTransform AffinePointTransform::vertex(int index) {
  return {{0, 0}, {{index, 1, 0, 0, 1}}};
}

AffinePointTransform AffinePointTransform::fromDeviations(Point2 point,
                                                          std::span<const Point2> reference,
                                                          std::span<const double> xCoefficients,
                                                          std::span<const double> yCoefficients) {
  const auto checkLength = [&](std::span<const double> list, const char* which) {
    if (list.size() != 2 * reference.size())
      throw InputError(std::string("affine transform: ") + std::to_string(list.size()) + " " +
                       which + " coefficients for " + std::to_string(reference.size()) +
                       " reference vertices; give two for each");
  };
  checkLength(xCoefficients, "x");
  checkLength(yCoefficients, "y");

  std::vector<Term> terms;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const Term t{static_cast<int>(i), xCoefficients[2 * i], xCoefficients[2 * i + 1],
                 yCoefficients[2 * i], yCoefficients[2 * i + 1]};
    point.x -= t.xx * reference[i].x + t.xy * reference[i].y;
    point.y -= t.yx * reference[i].x + t.yy * reference[i].y;
    terms.push_back(t);
  }
  return {point, std::move(terms)};
}

std::optional<Point2> AffinePointTransform::transformPoint(const AF2Binding& binding) const {
  if (vertexCount() > static_cast<int>(binding.vertices.size()))
    throw InputError("affine transform: needs " + std::to_string(vertexCount()) +
                     " matched vertices, the binding has " +
                     std::to_string(binding.vertices.size()));
  Point2 result = constant_;
  for (const Term& t : terms_) {
    const Point2 p = binding.vertices[static_cast<std::size_t>(t.vertex)];
    result.x += t.xx * p.x + t.xy * p.y;
    result.y += t.yx * p.x + t.yy * p.y;
  }
  return result;
}

AffinePointTransform AffinePointTransform::blend(const AffinePointTransform& other,
                                                 double t) const {
  std::vector<Term> terms;
  const auto add = [&](const AffinePointTransform& from, double weight) {
    for (const Term& s : from.terms_)
      terms.push_back({s.vertex, weight * s.xx, weight * s.xy, weight * s.yx, weight * s.yy});
  };
  add(*this, t);
  add(other, 1 - t);
  return {t * constant_ + (1 - t) * other.constant_, std::move(terms)};
}

}  // namespace af2
