// Wanted edge lengths.
#pragma once

#include <functional>
#include <utility>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2 {

/// The wanted edge length at each point of a surface. Called once for each new vertex.
/// Must be pure, and callable from several threads at once.
class AF2_EXPORT SizeField {
 public:
  virtual ~SizeField() = default;
  /// In model units, > 0.
  virtual double sizeAt(const SurfacePoint& point) const = 0;
};

class UniformSize final : public SizeField {
 public:
  explicit UniformSize(double size) : size_(size) {}
  double sizeAt(const SurfacePoint&) const override { return size_; }

 private:
  double size_;
};

/// A size field that wraps any callable taking a position.
class SizeFunction final : public SizeField {
 public:
  explicit SizeFunction(std::function<double(const Point3&)> size) : size_(std::move(size)) {}
  double sizeAt(const SurfacePoint& point) const override { return size_(point.position); }

 private:
  std::function<double(const Point3&)> size_;
};

}  // namespace af2
