#include "geometry/faceted/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/elementary.h"
#include "geometry/base/constants.h"
#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {
namespace {

class Denoising {
 public:
  Denoising(const Facets& facets, const std::vector<HalfEdge>& twins, std::vector<Point3> normals)
      : facets_(facets), twins_(twins), normals_(std::move(normals)) {
    for (std::uint32_t t = 0; t < normals_.size(); ++t) areas_.push_back(areaOf(facets, t));
  }

  FacetDirections run(const std::function<double(const Point3&)>& sizeAt) {
    constexpr int kPlainRounds = 2, kRounds = 12;  // the first so that no triangle stands out
    findRough(sizeAt);
    if (std::ranges::any_of(isRough_, std::identity()))
      for (int round = 0; round < kRounds; ++round)
        average(round < kPlainRounds ? Weights::Plain : Weights::ByDifference);
    return {std::move(normals_), std::move(isRough_)};
  }

 private:
  std::uint32_t cornerOf(HalfEdge h) const { return startOf(facets_.triangles, h); }
  const Point3& at(std::uint32_t v) const { return facets_.vertices[v]; }

  /// The mean of a triangle and those across its edges.
  std::vector<double> spread(const std::vector<double>& values) const {
    std::vector<double> means(values.size());
    for (std::uint32_t t = 0; t < values.size(); ++t) {
      double sum = values[t], count = 1;
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
        if (twins_[h] != kNoHalfEdge) {
          sum += values[twins_[h] / 3];
          ++count;
        }
      means[t] = sum / count;
    }
    return means;
  }

  /// At many vertices ridges and furrows take turns all around. Where surfaces are smooth, or meet
  /// at edges, that is rare.
  void findRough(const std::function<double(const Point3&)>& sizeAt) {
    constexpr double kShare = 0.12;
    constexpr int kRounds = 25;  // enough that chance does not count
    const std::vector<bool> isRugged = ruggedVertices();
    std::vector<double> share(normals_.size(), 0);
    for (std::uint32_t t = 0; t < share.size(); ++t)
      if (isSmall(t, sizeAt))
        for (const std::uint32_t v : facets_.triangles[t]) share[t] += isRugged[v] ? 1.0 / 3 : 0;
    for (int round = 0; round < kRounds; ++round) share = spread(share);
    for (const double of : share) isRough_.push_back(of > kShare);
    keepRoughParts();
  }

  /// Noise is nearly everywhere on what was scanned; elsewhere it is a detail.
  void keepRoughParts() {
    constexpr double kShare = 0.25;
    DisjointSets parts(normals_.size());
    for (HalfEdge h = 0; h < twins_.size(); ++h)
      if (twins_[h] != kNoHalfEdge) parts.join(h / 3, twins_[h] / 3);
    std::vector<double> rough(normals_.size(), 0), all = rough;
    for (std::uint32_t t = 0; t < normals_.size(); ++t) {
      rough[parts.of(t)] += isRough_[t] ? areas_[t] : 0;
      all[parts.of(t)] += areas_[t];
    }
    for (std::uint32_t t = 0; t < normals_.size(); ++t)
      isRough_[t] = isRough_[t] && rough[parts.of(t)] > kShare * all[parts.of(t)];
  }

  bool isSmall(std::uint32_t t, const std::function<double(const Point3&)>& sizeAt) const {
    constexpr double kSmall = 2;
    const double size = kSmall * sizeAt(middleOf(facets_, t));
    return lengthOf(facets_, 3 * t) < size && lengthOf(facets_, 3 * t + 1) < size &&
           lengthOf(facets_, 3 * t + 2) < size;
  }

  std::vector<bool> ruggedVertices() const {
    constexpr int kTurns = 4;  // two ridges and two furrows
    std::vector<HalfEdge> first(facets_.vertices.size(), kNoHalfEdge);
    for (HalfEdge h = 0; h < twins_.size(); ++h)
      if (first[cornerOf(h)] == kNoHalfEdge || twins_[h] == kNoHalfEdge) first[cornerOf(h)] = h;
    std::vector<bool> isRugged(first.size(), false);
    for (std::size_t v = 0; v < first.size(); ++v)
      isRugged[v] = first[v] != kNoHalfEdge && changesAround(first[v]) >= kTurns;
    return isRugged;
  }
  /// How often a ridge follows a furrow, or a furrow a ridge, around the start of a half-edge.
  int changesAround(HalfEdge first) const {
    int changes = 0, begin = 0, before = 0;
    HalfEdge h = first;
    do {
      if (const int bend = bendAt(h); bend != 0) {
        changes += before != 0 && bend != before ? 1 : 0;
        if (begin == 0) begin = bend;
        before = bend;
      }
      h = twins_[previousIn(h)];
    } while (h != kNoHalfEdge && h != first);
    return changes + (h == first && before != begin ? 1 : 0);
  }
  /// 1: a ridge, -1: a furrow, 0: neither.
  int bendAt(HalfEdge h) const {
    constexpr double kBend = 10 * kDegree;
    if (twins_[h] == kNoHalfEdge) return 0;
    const Point3 &m = normals_[h / 3], &n = normals_[twins_[h] / 3];
    if (m == Point3{} || n == Point3{} || angleBetween(m, n) < kBend) return 0;
    const Point3 beyond = at(cornerOf(previousIn(twins_[h]))) - at(cornerOf(h));
    return dot(beyond, m) < 0 ? 1 : -1;
  }

  enum class Weights { Plain, ByDifference };

  /// Normals that differ as much as neighbours do in the surroundings differ by noise; a larger
  /// difference is an edge.
  void average(Weights weights) {
    constexpr double kMin = 0.25;
    std::vector<double> noise(normals_.size(), 0);
    if (weights == Weights::ByDifference) noise = spread(spread(differences()));
    std::vector<Point3> next = normals_;
    for (std::uint32_t t = 0; t < noise.size(); ++t) {
      if (!isRough_[t]) continue;
      const double width = std::max(kMin, noise[t]);
      Point3 sum = areas_[t] * normals_[t];
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        if (twins_[h] == kNoHalfEdge) continue;
        const std::uint32_t other = twins_[h] / 3;
        const double off = distance(normals_[t], normals_[other]) / width;
        const double weight = weights == Weights::Plain ? 1 : exponential(-off * off / 2);
        sum = sum + (weight * areas_[other]) * normals_[other];
      }
      next[t] = unit(sum);
    }
    normals_ = std::move(next);
  }

  /// Of the normal of each triangle and those across its edges.
  std::vector<double> differences() const {
    std::vector<double> means(normals_.size(), 0);
    for (std::uint32_t t = 0; t < means.size(); ++t) {
      double sum = 0, count = 0;
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
        if (twins_[h] != kNoHalfEdge) {
          sum += distance(normals_[t], normals_[twins_[h] / 3]);
          ++count;
        }
      if (count > 0) means[t] = sum / count;
    }
    return means;
  }

  const Facets& facets_;
  const std::vector<HalfEdge>& twins_;
  std::vector<Point3> normals_;  // by triangle
  std::vector<double> areas_;
  std::vector<bool> isRough_;
};

}  // namespace

FacetDirections withoutNoise(const Facets& facets, const std::vector<HalfEdge>& twins,
                             std::vector<Point3> normals,
                             const std::function<double(const Point3&)>& sizeAt) {
  if (!sizeAt) return {std::move(normals), std::vector<bool>(facets.triangles.size(), false)};
  return Denoising(facets, twins, std::move(normals)).run(sizeAt);
}

}  // namespace af2::geometry
