#include "geometry/faceted/sparse_system.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {
namespace {

using Vector = std::vector<double>;

double product(const Vector& x, const Vector& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

/// x += factor y
void add(double factor, const Vector& y, Vector& x) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += factor * y[i];
}

}  // namespace

SparseSystem::SparseSystem(std::vector<std::vector<SparseEntry>> rows) : rows_(std::move(rows)) {
  factorize();
}

/// Gauss's elimination that leaves out whatever would fill places that are empty in the matrix.
void SparseSystem::factorize() {
  factors_ = rows_;
  inverseDiagonal_.assign(rows_.size(), 1);
  std::vector<SparseEntry*> at(rows_.size(), nullptr);  // of the row at hand, by column
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (SparseEntry& entry : factors_[i]) at[entry.column] = &entry;
    for (SparseEntry& entry : factors_[i]) {
      const std::size_t k = entry.column;
      if (k >= i) break;
      entry.value *= inverseDiagonal_[k];
      for (const SparseEntry& above : factors_[k])
        if (above.column > k && at[above.column])
          at[above.column]->value -= entry.value * above.value;
    }
    inverseDiagonal_[i] = 1 / at[i]->value;
    for (const SparseEntry& entry : factors_[i]) at[entry.column] = nullptr;
  }
}

std::vector<double> SparseSystem::times(const Vector& x) const {
  Vector y(x.size(), 0);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (const SparseEntry& entry : rows_[i]) y[i] += entry.value * x[entry.column];
  return y;
}

std::vector<double> SparseSystem::roughly(const Vector& right) const {
  Vector x = right;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (const SparseEntry& entry : factors_[i]) {
      if (entry.column >= i) break;
      x[i] -= entry.value * x[entry.column];
    }
  for (std::size_t i = x.size(); i-- > 0;) {
    for (const SparseEntry& entry : factors_[i])
      if (entry.column > i) x[i] -= entry.value * x[entry.column];
    x[i] *= inverseDiagonal_[i];
  }
  return x;
}

/// The stabilised method of biconjugate gradients. Source: [Vorst92].
std::vector<double> SparseSystem::solve(const Vector& right) const {
  constexpr int kMostSteps = 500;
  constexpr double kEnough = 1e-14;  // of the right side
  Vector x = roughly(right), rest = right;
  add(-1, times(x), rest);
  const Vector shadow = rest;
  const double aim = kEnough * kEnough * product(right, right);
  Vector direction(x.size(), 0), moved(x.size(), 0), best = x;
  double rho = 1, alpha = 1, omega = 1, least = product(rest, rest);
  for (int step = 0; step < kMostSteps && least > aim; ++step) {
    const double before = rho;
    rho = product(shadow, rest);
    if (rho == 0 || omega == 0) break;
    const double beta = rho / before * (alpha / omega);
    for (std::size_t i = 0; i < x.size(); ++i)
      direction[i] = rest[i] + beta * (direction[i] - omega * moved[i]);
    const Vector along = roughly(direction);
    moved = times(along);
    alpha = rho / product(shadow, moved);
    if (!std::isfinite(alpha)) break;
    add(alpha, along, x);
    add(-alpha, moved, rest);
    const Vector smooth = roughly(rest), smoothed = times(smooth);
    const double square = product(smoothed, smoothed);
    omega = square > 0 ? product(smoothed, rest) / square : 0;
    add(omega, smooth, x);
    add(-omega, smoothed, rest);
    const double now = product(rest, rest);
    if (!(now < least)) continue;
    least = now;
    best = x;
  }
  return best;
}

}  // namespace af2::geometry
