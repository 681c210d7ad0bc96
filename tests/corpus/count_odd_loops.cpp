// Counts faces with odd loops, without and with MeshingOptions::evenLoops:
// `count_odd_loops MODEL...`, CAD models, each meshed at a fortieth of its diagonal.
#include <Standard_Failure.hxx>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "geometry/occ/model/model.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/support/triangle_rules.h"

namespace {

using namespace af2::geometry;

constexpr double kShareOfDiagonal = 1.0 / 40;

struct Counts {
  std::size_t faces = 0, meshed = 0, even = 0, elements = 0;
  double seconds = 0;

  void operator+=(const Counts& other) {
    faces += other.faces;
    meshed += other.meshed;
    even += other.even;
    elements += other.elements;
    seconds += other.seconds;
  }
};

Counts countsOf(const Model& model, bool evenLoops) {
  static const af2::AF2Algorithm algorithm(af2::testing::triangleSet());
  MeshingOptions options;
  options.sizes.size = kShareOfDiagonal * model.diagonal();
  options.evenLoops = evenLoops;
  const ModelMesh mesh = meshModel(model, algorithm, options);
  Counts counts;
  for (const FaceReport& face : mesh.faces) {
    ++counts.faces;
    const bool isMeshed = face.status == FaceStatus::Complete;
    counts.meshed += isMeshed;
    counts.even += isMeshed && face.oddLoops.empty();
  }
  counts.elements = mesh.elements.size();
  counts.seconds = mesh.seconds.edges;
  return counts;
}

void print(const std::string& name, const Counts& counts) {
  std::printf("%-52s %6zu %6zu %6zu %9zu %8.2f\n", name.c_str(), counts.faces, counts.meshed,
              counts.even, counts.elements, counts.seconds);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "count_odd_loops MODEL...\n");
    return 2;
  }
  std::printf("%-52s %6s %6s %6s %9s %8s\n", "model", "faces", "meshed", "even", "elements",
              "edges, s");
  Counts without, with;
  for (int i = 1; i < count; ++i) {
    const std::string name = std::filesystem::path(words[i]).filename().string();
    try {
      const Model model = readModel(words[i]);
      const Counts before = countsOf(model, false), after = countsOf(model, true);
      print(name, before);
      print(name + ", even loops", after);
      without += before;
      with += after;
    } catch (const Standard_Failure& failure) {
      std::printf("%-52s %s\n", name.c_str(), failure.GetMessageString());
    } catch (const std::exception& error) {
      std::printf("%-52s %.60s\n", name.c_str(), error.what());
    }
  }
  print("all", without);
  print("all, even loops", with);
}
