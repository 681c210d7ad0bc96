// Wanted sizes by position, evaluated at many positions at once.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
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
    Fill lower;
    if constexpr (requires(std::span<const Point3> at, std::span<double> s) { sizes.lower(at, s); })
      lower = [sizes](std::span<const Point3> at, std::span<double> s) { sizes.lower(at, s); };
    make(std::move(sizes), std::move(lower));
  }

  template <class F>
  requires std::is_invocable_r_v<double, const F&, const Point3&> PositionSize(F size)
      : PositionSize([size = std::move(size)](std::span<const Point3> at, std::span<double> sizes) {
          for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = size(at[i]);
        }) {}

  /// Whether there is a function.
  explicit operator bool() const { return made_ != nullptr; }
  /// The smaller size of both, where `less` tells less than `asked`.
  static PositionSize smallerOf(PositionSize asked, PositionSize less);
  /// What `smallerOf` made of a copy of `asked` and `less` has sizes below `asked` only where
  /// `less` has. Returns `less` of such a function, and this function itself if it is another one.
  const PositionSize& below(const PositionSize& asked) const;
  /// Whether both are copies of one function, or there is none.
  bool isSameAs(const PositionSize& other) const { return made_ == other.made_; }

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
  struct Made;
  void make(Fill sizes, Fill lower);

  std::shared_ptr<const Made> made_;  ///< null: there is no function
};

}  // namespace af2::geometry
