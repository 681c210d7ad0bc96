// Wanted sizes by position, evaluated at many positions at once.
#pragma once

#include <concepts>
#include <functional>
#include <span>
#include <utility>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// A function of the position that gives wanted edge lengths, in model units, > 0.
///
/// Made from a callable for one position, `double f(const Point3&)`, or for many, `void
/// f(std::span<const Point3> at, std::span<double> sizes)`, which fills `sizes`. The latter pays
/// off where a call is expensive, e.g. into another language: AF2 evaluates many positions at once
/// along edges and over faces, and single positions for the front. The function must be pure and
/// callable from several threads at once.
class AF2_EXPORT PositionSize {
 public:
  PositionSize() = default;

  template <class F>
  requires std::invocable<const F&, std::span<const Point3>, std::span<double>> PositionSize(
      F sizes) {
    if constexpr (requires(std::span<const Point3> at, std::span<double> s) { sizes.lower(at, s); })
      lower_ = [sizes](std::span<const Point3> at, std::span<double> s) { sizes.lower(at, s); };
    sizes_ = std::move(sizes);
  }

  template <class F>
  requires std::is_invocable_r_v<double, const F&, const Point3&> PositionSize(F size)
      : sizes_([size = std::move(size)](std::span<const Point3> at, std::span<double> sizes) {
          for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = size(at[i]);
        }) {}

  /// Whether there is a function.
  explicit operator bool() const { return static_cast<bool>(sizes_); }

  /// Fills sizes[i] with the size at at[i]. Throws InputError, with the place, unless all of them
  /// are positive (infinity: no limit).
  void at(std::span<const Point3> at, std::span<double> sizes) const;
  double at(const Point3& position) const;

  /// Reduces sizes[i] to the size at at[i] where that is smaller. Cheaper than `at`, because most
  /// positions are far from any small size. A callable may have a function `lower` of its own for
  /// this.
  void lower(std::span<const Point3> at, std::span<double> sizes) const;

 private:
  using Fill = std::function<void(std::span<const Point3>, std::span<double>)>;
  Fill sizes_;
  Fill lower_;  ///< may be empty
};

}  // namespace af2::geometry
