#include "geometry/check/model_check.h"

#include <cstdint>
#include <optional>

#include "geometry/check/edge_checker.h"
#include "geometry/check/element_checker.h"

namespace af2::geometry {

namespace {

/// Where all vertices inside faces are surrounded, only edges between others may be wrong.
void checkEdgesOf(const ModelMesh& mesh, const ElementChecker& elements, int threads,
                  Findings& findings) {
  const std::vector<WantedUses> wanted = wantedUses(mesh);
  const std::optional<std::uint32_t> inside = elements.firstInside();
  const bool isSoundInside = inside && elements.areSurrounded(*inside, threads);
  checkEdges({mesh, wanted, isSoundInside ? elements.atSegments() : elements.sound(),
              isSoundInside ? *inside : 0xffffffffu},
             threads, findings);
}

}  // namespace

bool isWrongArea(double ratio, std::size_t elements) {
  constexpr std::size_t kFew = 60;
  constexpr double kMaxFactor = 1.4, kMaxFactorOfFew = 5;
  const double most = elements < kFew ? kMaxFactorOfFew : kMaxFactor;
  return ratio < 1 / most || ratio > most;
}

std::vector<MeshFinding> checkModelMesh(const ModelMesh& mesh, std::size_t limit, int threads) {
  Findings findings(limit);
  ElementChecker elements(mesh, firstInside(mesh), findings);
  elements.checkElements(threads);
  checkEdgesOf(mesh, elements, threads, findings);
  checkAreas(mesh, elements.areas(), findings);
  return findings.result();
}

}  // namespace af2::geometry
