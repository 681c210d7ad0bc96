// B-spline and Bezier surfaces, rational or not, as tables of Bezier patches.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/point.h"
#include "geometry/charts/surface_frame.h"

namespace af2::geometry {

/// One parameter of a spline.
struct SplineBasis {
  int degree = 1;
  /// In ascending order, each repeated by its multiplicity; their number is that of the poles plus
  /// degree + 1.
  std::vector<double> knots;
  /// If above 0, parameters that differ by it are the same place.
  double period = 0;

  std::size_t poleCount() const { return knots.size() - static_cast<std::size_t>(degree) - 1; }
  double low() const { return knots[static_cast<std::size_t>(degree)]; }
  double high() const { return knots[poleCount()]; }
};

/// The definition of a spline surface.
struct SplineDefinition {
  SplineBasis u, v;
  std::vector<Point3> poles;    ///< pole (i, j) is at index i * v.poleCount() + j
  std::vector<double> weights;  ///< of the poles, > 0; empty: not rational
};

/// Immutable, so threads may share it. Where the derivatives jump, at a multiple knot, the values
/// are those of the side of greater parameters. Beyond the ends of a parameter that is not
/// periodic, the last patch is extrapolated.
class SplineSurface {
 public:
  static constexpr int kMaxDegree = 25;

  /// The range of parameters in which the surface is needed.
  struct Box {
    double u1, u2, v1, v2;
  };

  /// Makes the patches of the box and one more on each side. Nothing if a degree is above
  /// kMaxDegree, if the table would have more than `mostNumbers` numbers, or if the definition is
  /// invalid.
  static std::optional<SplineSurface> make(const SplineDefinition& definition, const Box& box,
                                           std::size_t mostNumbers = std::size_t{1} << 22);

  /// Returns nothing outside the patches that were made.
  std::optional<SurfaceFrame> frameAt(double u, double v) const;
  std::optional<SurfaceJet> jetAt(double u, double v) const;

 private:
  /// The spans between distinct knots that have patches; finds the span of a parameter.
  class Spans {
   public:
    Spans(const SplineBasis& basis, double from, double to);
    struct Place {
      std::size_t span;  ///< from the first that has patches
      double local;      ///< 0 ... 1
      double perUnit;    ///< change of the local parameter per unit of the surface's parameter
    };
    std::optional<Place> find(double parameter) const;
    std::size_t count() const { return last_ - first_ + 1; }
    /// The index of the knot at which a span starts.
    std::size_t knotOf(std::size_t span) const { return knots_[first_ + span]; }
    int degree() const { return degree_; }

   private:
    double brought(double parameter) const;
    std::size_t spanAt(double x) const;

    int degree_;
    double period_;
    std::vector<double> breaks_;      ///< one more than spans
    std::vector<double> perUnit_;     ///< by span
    std::vector<std::size_t> knots_;  ///< by span
    double spansPerUnit_ = 0;         ///< if all spans were equally long
    std::size_t first_ = 0, last_ = 0;
  };

  SplineSurface(Spans u, Spans v, bool isRational);
  void fill(const SplineDefinition& definition);
  void fillPatch(const SplineDefinition& definition, std::size_t iu, std::size_t iv,
                 const std::vector<double>& toBezierU, const std::vector<double>& toBezierV);
  const double* patch(std::size_t u, std::size_t v) const {
    return numbers_.data() + (u * v_.count() + v) * stride_;
  }

  template <int Order>
  struct Sums;
  template <int Order>
  Sums<Order> sumsAt(const Spans::Place& u, const Spans::Place& v) const;
  template <int Order, std::size_t CountU, std::size_t CountV>
  Sums<Order> sumsOf(const Spans::Place& u, const Spans::Place& v) const;

  Spans u_, v_;
  bool isRational_;
  std::size_t stride_;  ///< numbers per patch: four for its origin and four for each of its poles,
                        ///< by u and v
  std::vector<double> numbers_;
};

}  // namespace af2::geometry
