// The front and the optimiser on one planar region: time and quality in one line each.
//
// planar_front square|disc N [RULES [ROUNDS SWEEPS]]: wanted length 1/N; RULES as for `af2 mesh
// -r`. Raw front first, best of three runs; then the same mesh optimised.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "dsl/diagnostic.h"
#include "dsl/rule_file.h"
#include "engine/algorithm.h"
#include "engine/mesh_check.h"
#include "engine/optimize.h"
#include "engine/stopwatch.h"
#include "tests/support/flat_surface.h"
#include "tests/support/meshing.h"

namespace {

using namespace af2;
using namespace af2::testing;

void tell(const char* what, const Mesh& mesh, double seconds, const FrontInput& input) {
  std::vector<double> quality;
  double sum = 0;
  for (const Element& e : mesh.elements) {
    quality.push_back(triangleQuality(mesh, e));
    sum += quality.back();
  }
  std::sort(quality.begin(), quality.end());
  const auto count = static_cast<double>(quality.size());
  std::printf("%-9s %8zu triangles  %6.0f ns each  min %.3f  p1 %.3f  mean %.4f  faults %zu\n",
              what, quality.size(), 1e9 * seconds / count, quality.front(),
              quality[quality.size() / 100], sum / count,
              checkMesh(mesh, boundaryOf(input)).size());
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3 || !(std::atof(arguments[2]) >= 4)) {
    std::fprintf(stderr, "usage: planar_front square|disc N [RULES [ROUNDS SWEEPS]]\n");
    return 2;
  }
  const double size = 1 / std::atof(arguments[2]);
  const FrontInput input =
      std::string_view(arguments[1]) == "square" ? square(size) : discWithHole(size);
  const auto loaded = dsl::loadRules(count > 3 ? arguments[3] : AF2_SOURCE_RULES "/tri/even.af2");
  if (!loaded.rules) {
    std::fprintf(stderr, "%s", dsl::toPretty(loaded.diagnostics).c_str());
    return 1;
  }
  const AF2Algorithm algorithm(loaded.rules);
  MeshingResult result;
  double best = 1e300;
  for (int run = 0; run < 3; ++run) {
    const Stopwatch watch;
    result = algorithm.execute(FlatMaker(), input, UniformSize(size));
    best = std::min(best, watch.seconds());
  }
  tell("raw", result.mesh, best, input);

  OptimizeOptions options;
  if (count > 5) {
    options.rounds = std::atoi(arguments[4]);
    options.smoothingSweeps = std::atoi(arguments[5]);
  }
  const Stopwatch watch;
  optimizeMesh(result.mesh, boundaryOf(input), FlatMaker(), options);
  tell("optimised", result.mesh, watch.seconds(), input);
  return result.outcome == Outcome::Complete ? 0 : 3;
}
