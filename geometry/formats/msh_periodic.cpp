#include "geometry/formats/msh_periodic.h"

namespace af2::geometry {

void writeMshPeriodic(const ModelMesh& mesh, OutputFile& file) {
  constexpr std::int32_t kSurface = 2;
  if (mesh.periodic.empty()) return;
  file.text("$Periodic\n");
  file.binary(std::uint64_t{mesh.periodic.size()});
  for (const PeriodicPair& pair : mesh.periodic) {
    file.binary(kSurface);
    file.binary(std::int32_t{pair.second});
    file.binary(std::int32_t{pair.first});
    file.binary(std::uint64_t{pair.transform.size()});
    for (const double number : pair.transform) file.binary(number);
    file.binary(std::uint64_t{pair.vertices.size()});
    for (const auto& [second, first] : pair.vertices) {
      file.binary(std::uint64_t{second.value} + 1);
      file.binary(std::uint64_t{first.value} + 1);
    }
  }
  file.text("\n$EndPeriodic\n");
}

}  // namespace af2::geometry
