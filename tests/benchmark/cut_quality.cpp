// Irregular vertices near the cuts of a large region, beside those elsewhere.
//
// cut_quality RULES [N]
//   RULES  file with rules that make quadrilaterals
//   N      the wanted length is 1/N; default: 400
//
// Meshes the unit square with a hole of radius .2 and a disc of radius .5, with quadrilaterals
// only, in one piece and in pieces. "Near" is within four wanted lengths of a cut.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "dsl/load/rule_file.h"
#include "dsl/text/diagnostic.h"
#include "engine/run/mesh_region.h"
#include "tests/support/flat_surface.h"

namespace {

using namespace af2;
using namespace af2::testing;

struct Plane final : SurfaceEvaluator {
  SurfacePoint at(double u, double v) const override { return {{u, v, 0}, {0, 0, 1}, u, v}; }
};

int evenParts(double length, double size) {
  return 2 * static_cast<int>(std::lround(length / (2 * size)));
}

FrontInput disc(double size) {
  FrontInput input;
  addLoop(input, circle({0, 0}, .5, evenParts(M_PI, size)));
  return input;
}

FrontInput squareWithHole(double size) {
  FrontInput input = square(size);
  addLoop(input, circle({.5, .5}, .2, evenParts(.4 * M_PI, size), true));
  return input;
}

struct Share {
  double irregular = 0, all = 0;

  void add(bool isIrregular) {
    irregular += isIrregular ? 1 : 0;
    ++all;
  }
  double percent() const { return all > 0 ? 100 * irregular / all : 0; }
};

class Comparison {
 public:
  Comparison(const AF2Algorithm& algorithm, const FrontInput& input, double size)
      : algorithm_(algorithm),
        input_(input),
        size_(size),
        split_(splitRegion(input, plane_, UniformSize(size), options())) {}

  bool run(const char* domain) const {
    Share near, elsewhere, whole, beside;
    const bool isDone = count(&plane_, near, elsewhere) && count(nullptr, beside, whole);
    std::printf(
        "%-17s %3zu pieces: %.2f %% near cuts, %.2f %% elsewhere; in one piece %.2f %% and "
        "%.2f %%%s\n",
        domain, split_.pieces.size(), near.percent(), elsewhere.percent(), beside.percent(),
        whole.percent(), isDone ? "" : "; NOT COMPLETE");
    return isDone;
  }

 private:
  static SplitOptions options() {
    SplitOptions split;
    split.evenPieces = true;
    return split;
  }

  bool isNearCut(const Point3& p) const {
    constexpr double kNear = 4;
    return std::ranges::any_of(split_.cutVertices, [&](const SurfacePoint& v) {
      return distance(v.position, p) <= kNear * size_;
    });
  }

  bool count(const SurfaceEvaluator* surface, Share& near, Share& elsewhere) const {
    const auto size = std::make_shared<UniformSize>(size_);
    RegionTask task{input_,
                    [&] {
                      return PieceTools{std::make_unique<FlatMaker>(), size};
                    },
                    surface, options()};
    task.quads.onlyQuads = true;
    const RegionMesh mesh = meshRegion(algorithm_, task, {});
    std::vector<int> elements(mesh.result.mesh.vertices.size());
    for (const Element& e : mesh.result.mesh.elements)
      for (const VertexId v : e.vertices()) ++elements[v.value];
    for (std::size_t v = input_.vertexCount; v < elements.size(); ++v)
      (isNearCut(mesh.result.mesh.vertices[v].position) ? near : elsewhere).add(elements[v] != 4);
    return mesh.result.outcome == Outcome::Complete && mesh.fault.empty();
  }

  const AF2Algorithm& algorithm_;
  const FrontInput& input_;
  double size_;
  Plane plane_;
  SplitRegion split_;
};

}  // namespace

int main(int count, char** arguments) {
  const double n = count > 2 ? std::atof(arguments[2]) : 400;
  if (count < 2 || count > 3 || !(n >= 10)) {
    std::fprintf(stderr, "usage: cut_quality RULES [N]\n");
    return 2;
  }
  const auto loaded = dsl::loadRules(arguments[1]);
  if (!loaded.rules) {
    std::fprintf(stderr, "%s", dsl::toPretty(loaded.diagnostics).c_str());
    return 1;
  }
  const AF2Algorithm algorithm(loaded.rules);
  const bool isSquareDone =
      Comparison(algorithm, squareWithHole(1 / n), 1 / n).run("square with hole");
  return Comparison(algorithm, disc(1 / n), 1 / n).run("disc") && isSquareDone ? 0 : 1;
}
