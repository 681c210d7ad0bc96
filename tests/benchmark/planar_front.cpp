// The engine on one planar region: time, memory and quality in one line for each stage.
//
// planar_front SHAPE N [OPTION...]
//   SHAPE  square, disc (with a hole), graded (a square with sizes from 1/N to 50/N)
//   N      the wanted length is 1/N
//   --rules FILE  other rules
//   --rounds R, --sweeps S   other effort of the optimiser; not with threads
//   --threads T   in pieces and optimised, as the library does it, on T threads
//   --whole       with threads: not cut, as a face of a model that cannot be
//   --raw         without the optimiser
//   --tally       how many steps each rule took, and how many were refused, by level (no times)
//
// Times are CPU times of the process per triangle, but for threads also seconds on the clock.
// Memory is the largest the process ever held, less what it held before, per triangle.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>

#include "dsl/load/rule_file.h"
#include "dsl/text/diagnostic.h"
#include "engine/base/stopwatch.h"
#include "engine/mesh/mesh_check.h"
#include "engine/optimize/optimize.h"
#include "engine/run/mesh_region.h"
#include "tests/support/flat_surface.h"
#include "tests/support/meshing.h"

namespace {

using namespace af2;
using namespace af2::testing;

struct Task {
  std::string_view shape;
  double size = 0;
  const char* rules = AF2_SOURCE_RULES "/tri/even.af2";
  OptimizeOptions how;
  int threads = 0;
  bool optimize = true;
  bool tally = false;
  bool isWhole = false;
};

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peakBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// From h at x = 0 to kGrading h at x = 1.
constexpr double kGrading = 50;

std::shared_ptr<const SizeField> sizeOf(const Task& task) {
  if (task.shape != "graded") return std::make_shared<UniformSize>(task.size);
  return std::make_shared<SizeFunction>(
      [h = task.size](const Point3& p) { return h * (1 + (kGrading - 1) * p.x); });
}

/// A unit square whose lower and upper sides are divided by the graded size.
FrontInput gradedSquare(double size) {
  const double edges = std::round(std::log(kGrading) / (size * (kGrading - 1)));
  std::vector<Point2> lower, polygon;
  for (double k = 0; k < edges; ++k)
    lower.push_back({(std::pow(kGrading, k / edges) - 1) / (kGrading - 1), 0});
  const std::vector<Point2> right = divided({{1, 0}, {1, 1}}, kGrading * size);
  const std::vector<Point2> left = divided({{0, 1}, {0, 0}}, size);
  polygon = lower;
  polygon.insert(polygon.end(), right.begin(), right.begin() + std::ssize(right) / 2);
  polygon.push_back({1, 1});
  for (std::size_t k = lower.size(); k-- > 1;) polygon.push_back({lower[k].x, 1});
  polygon.insert(polygon.end(), left.begin(), left.begin() + std::ssize(left) / 2);
  FrontInput input;
  addLoop(input, polygon);
  return input;
}

FrontInput regionOf(const Task& task) {
  if (task.shape == "graded") return gradedSquare(task.size);
  return task.shape == "square" ? square(task.size) : discWithHole(task.size);
}

void tell(const char* what, const Mesh& mesh, double seconds, double bytes,
          const FrontInput& input) {
  std::vector<double> quality;
  double sum = 0;
  for (const Element& e : mesh.elements) {
    quality.push_back(triangleQuality(mesh, e));
    sum += quality.back();
  }
  std::sort(quality.begin(), quality.end());
  const auto count = static_cast<double>(quality.size());
  std::printf(
      "%-9s %8zu triangles  %6.0f ns and %4.0f bytes each  min %.3f  p1 %.3f  mean %.4f  "
      "faults %zu\n",
      what, quality.size(), 1e9 * seconds / count, bytes / count, quality.front(),
      quality[quality.size() / 100], sum / count, checkMesh(mesh, boundaryOf(input)).size());
}

/// Counts the steps of a run by rule and by level.
class Tally final : public AF2MeshingObserver {
 public:
  explicit Tally(const RuleSet& rules) : rules_(rules), taken_(rules.rules().size() + 1) {}
  void stepTaken(const StepReport& report) override {
    std::array<int, kLevels>& row = taken_[report.applied ? report.rule : taken_.size() - 1];
    ++row[static_cast<std::size_t>(std::min<int>(report.level, kLevels)) - 1];
  }
  void print() const {
    std::printf("%-20s by level 1, 2, ... %d and above\n", "steps", kLevels);
    for (std::size_t r = 0; r < taken_.size(); ++r) {
      const bool isRule = r < rules_.rules().size();
      std::printf("%-20s", isRule ? rules_.rules()[r].definition().name.c_str() : "refused");
      for (const int count : taken_[r]) std::printf(" %8d", count);
      std::printf("\n");
    }
  }

 private:
  static constexpr int kLevels = 8;
  const RuleSet& rules_;
  std::vector<std::array<int, kLevels>> taken_;  // by rule; refused ones last
};

bool tallySteps(const AF2Algorithm& algorithm, const Task& task, const FrontInput& input) {
  Tally tally(algorithm.rules());
  FrontOptions options;
  options.observer = &tally;
  const MeshingResult result = algorithm.execute(FlatMaker(), input, *sizeOf(task), options);
  tally.print();
  return result.outcome == Outcome::Complete;
}

bool meshInPieces(const AF2Algorithm& algorithm, const Task& task, const FrontInput& input) {
  struct Plane final : SurfaceEvaluator {
    SurfacePoint at(double u, double v) const override { return {{u, v, 0}, {0, 0, 1}, u, v}; }
  } plane;
  const auto size = sizeOf(task);
  const RegionTask region{input,
                          [&] {
                            return PieceTools{std::make_unique<FlatMaker>(), size};
                          },
                          task.isWhole ? nullptr : &plane,
                          {},
                          task.optimize,
                          task.threads};
  const double before = peakBytes(), start = cpuSeconds();
  const Stopwatch watch;
  const RegionMesh mesh = meshRegion(algorithm, region, {});
  const double seconds = watch.seconds(), cpu = cpuSeconds() - start;
  tell("pieces", mesh.result.mesh, cpu, peakBytes() - before, input);
  std::printf("%-9s %.3f s on the clock, %.3f s of CPU time\n", "", seconds, cpu);
  return mesh.result.outcome == Outcome::Complete && mesh.fault.empty();
}

bool meshWhole(const AF2Algorithm& algorithm, const Task& task, const FrontInput& input) {
  const auto size = sizeOf(task);
  const double before = peakBytes();
  MeshingResult result;
  double best = 1e300, bytes = 0;
  for (int run = 0; run < 3; ++run) {
    result = {};
    const double start = cpuSeconds();
    result = algorithm.execute(FlatMaker(), input, *size);
    best = std::min(best, cpuSeconds() - start);
    if (run == 0) bytes = peakBytes() - before;
  }
  tell("raw", result.mesh, best, bytes, input);
  std::printf("%-9s %zu steps, %zu of them failed\n", "", result.steps, result.failedSteps);
  if (!task.optimize) return result.outcome == Outcome::Complete;

  const double start = cpuSeconds();
  optimizeMesh(result.mesh, boundaryOf(input), FlatMaker(), task.how);
  tell("optimised", result.mesh, cpuSeconds() - start, peakBytes() - before, input);
  return result.outcome == Outcome::Complete;
}

bool read(int count, char** arguments, Task& task) {
  if (count < 3) return false;
  task.shape = arguments[1];
  task.size = 1 / std::atof(arguments[2]);
  for (int i = 3; i < count; ++i) {
    const std::string_view option = arguments[i];
    task.tally = task.tally || option == "--tally";
    task.isWhole = task.isWhole || option == "--whole";
    task.optimize = task.optimize && option != "--raw";
    if (option == "--raw" || option == "--tally" || option == "--whole") continue;
    if (++i == count) return false;
    if (option == "--rules")
      task.rules = arguments[i];
    else if (option == "--rounds")
      task.how.rounds = std::atoi(arguments[i]);
    else if (option == "--sweeps")
      task.how.smoothingSweeps = std::atoi(arguments[i]);
    else if (option == "--threads")
      task.threads = std::atoi(arguments[i]);
    else
      return false;
  }
  const OptimizeOptions usual;
  const bool isUsual =
      task.how.rounds == usual.rounds && task.how.smoothingSweeps == usual.smoothingSweeps;
  if (task.threads > 0 && !isUsual) return false;  // the library does it as usual
  return (task.shape == "square" || task.shape == "disc" || task.shape == "graded") &&
         task.size > 0 && task.size <= 0.25 && task.threads >= 0;
}

}  // namespace

int main(int count, char** arguments) {
  Task task;
  if (!read(count, arguments, task)) {
    std::fprintf(stderr,
                 "usage: planar_front square|disc|graded N [--rules FILE] [--rounds R] "
                 "[--sweeps S] [--threads T] [--whole] [--raw] [--tally]\n");
    return 2;
  }
  const auto loaded = dsl::loadRules(task.rules);
  if (!loaded.rules) {
    std::fprintf(stderr, "%s", dsl::toPretty(loaded.diagnostics).c_str());
    return 1;
  }
  const AF2Algorithm algorithm(loaded.rules);
  const FrontInput input = regionOf(task);
  const bool isDone = task.tally         ? tallySteps(algorithm, task, input)
                      : task.threads > 0 ? meshInPieces(algorithm, task, input)
                                         : meshWhole(algorithm, task, input);
  return isDone ? 0 : 3;
}
