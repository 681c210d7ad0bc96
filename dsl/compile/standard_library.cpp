#include "dsl/compile/standard_library.h"

namespace af2::dsl {
namespace {

constexpr std::string_view kQuality = R"(af2 1;
# Measures of elements beyond the predefined ones. The last parameters are the corners.

## 0 for the equilateral triangle, 1 for a flat one.
metric thin(u, v, w) = 1 - scaled_jacobian(u, v, w);

## 0 for a rectangle, 1 where a corner is straight or folds back.
metric skew(u, v, w, x) = 1 - scaled_jacobian(u, v, w, x);

## How far the smallest angle of a triangle falls short of 60 degrees, as a share.
metric narrow(u, v, w) = 1 - min_angle(u, v, w) / 60deg;

## How far the smallest angle of a quadrilateral falls short of a right angle, as a share.
metric slanted(u, v, w, x) = 1 - min_angle(u, v, w, x) / 90deg;
)";

}  // namespace

std::optional<std::string> standardFile(std::string_view path) {
  if (path == "std/quality.af2") return std::string(kQuality);
  return std::nullopt;
}

}  // namespace af2::dsl
