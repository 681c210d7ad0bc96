// What every driver of the whole-mesh benchmark measures and prints, so that the figures compare.
// Needs the standard library only: the drivers of the peers share nothing else with AF2.
#pragma once

#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace af2::benchmark {

/// User CPU seconds of this process so far: little disturbed by what else the machine does.
inline double userSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// Largest memory this process ever held, in MiB.
inline double peakMebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

using Corner = std::array<double, 3>;

inline double squaredDistance(const Corner& p, const Corner& q) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  return sum;
}

/// 4 sqrt(3) area / sum of squared edges: 1 for the equilateral triangle, 0 for a flat one.
inline double triangleQuality(const Corner& a, const Corner& b, const Corner& c) {
  const double ab = squaredDistance(a, b), bc = squaredDistance(b, c), ca = squaredDistance(c, a);
  // The squared area from the squared edges (Heron), which needs no normal.
  const double sixteenAreas = 2 * (ab * bc + bc * ca + ca * ab) - (ab * ab + bc * bc + ca * ca);
  if (ab + bc + ca <= 0) return 0;
  return std::sqrt(3 * std::max(0.0, sixteenAreas)) / (ab + bc + ca);
}

/// Prints one line of JSON, which whole_mesh_benchmark.py reads.
inline void printResult(std::FILE* file, double seconds, std::vector<double> qualities) {
  if (qualities.empty()) {
    std::fprintf(file, "{\"triangles\": 0}\n");
    return;
  }
  std::sort(qualities.begin(), qualities.end());
  double sum = 0;
  for (const double quality : qualities) sum += quality;
  std::fprintf(file,
               "{\"triangles\": %zu, \"seconds\": %.6f, \"min\": %.4f, \"percentile1\": %.4f, "
               "\"mean\": %.4f, \"mebibytes\": %.0f}\n",
               qualities.size(), seconds, qualities.front(), qualities[qualities.size() / 100],
               sum / static_cast<double>(qualities.size()), peakMebibytes());
}

}  // namespace af2::benchmark
