#include "cli/compare/planar_domains.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/planar/mesh_planar.h"

namespace af2::cli {
namespace {

TEST(PlanarDomains, EachEncloseOneRegion) {
  geometry::MeshingOptions options;
  options.sizes.size = 0.05;
  for (const NamedDomain& named : namedDomains())
    EXPECT_EQ(geometry::planarModel(named.domain, options).faces.size(), 1u) << named.name;
  options.keepBoundary = true;
  for (std::uint64_t seed = 1; seed <= 240; ++seed) {
    const geometry::DomainModel model = geometry::planarModel(randomDomain(seed, 0.05), options);
    ASSERT_EQ(model.faces.size(), 1u) << "seed " << seed;
    EXPECT_EQ(model.faces[0].loops.size(), 1 + seed % 4) << "seed " << seed;
  }
}

TEST(PlanarDomains, HaveTheAreasOfTheirShapes) {
  geometry::MeshingOptions options;
  options.sizes.size = 0.05;
  for (const auto& [name, area] : {std::pair{"square with hole", 0.8743},
                                   {"disc", 0.7854},
                                   {"L-shape", 0.75},
                                   {"rectangle", 0.6}}) {
    const auto domains = namedDomains();
    const auto named = std::ranges::find(domains, name, &NamedDomain::name);
    ASSERT_NE(named, domains.end());
    EXPECT_NEAR(geometry::planarModel(named->domain, options).faces[0].area, area, 1e-3) << name;
  }
}

TEST(RandomDomain, HasAnEvenNumberOfSegmentsInEachLoop) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const geometry::PlanarDomain domain = randomDomain(seed, 0.05);
    int begin = 0;
    for (const auto& segment : domain.segments)
      if (segment.to < segment.from) {  // back to the first vertex of its loop
        EXPECT_EQ((segment.from + 1 - begin) % 2, 0) << "seed " << seed;
        begin = segment.from + 1;
      }
  }
}

TEST(RandomDomain, IsTheSameForTheSameSeed) {
  EXPECT_EQ(randomDomain(5, 0.05).points, randomDomain(5, 0.05).points);
  EXPECT_NE(randomDomain(5, 0.05).points, randomDomain(6, 0.05).points);
}

TEST(RandomDomain, HasEvenOrUnevenSegments) {
  const auto spread = [](std::uint64_t seed) {
    const geometry::PlanarDomain domain = randomDomain(seed, 0.05);
    double least = 1e9, most = 0;
    for (const auto& segment : domain.segments) {
      if (segment.from > segment.to) break;  // the first loop
      const double length = distance(domain.points[static_cast<std::size_t>(segment.from)],
                                     domain.points[static_cast<std::size_t>(segment.to)]);
      least = std::min(least, length);
      most = std::max(most, length);
    }
    return most / least;
  };
  EXPECT_LT(spread(1), 1.05);
  EXPECT_GT(spread(4), 1.5);
}

}  // namespace
}  // namespace af2::cli
