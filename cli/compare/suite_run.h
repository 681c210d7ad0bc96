// Meshes all models of a suite with two rule sets, with and without the final optimization.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "cli/compare/suite.h"
#include "geometry/quality/mesh_measures.h"

namespace af2::cli {

/// Which of the two rule sets.
inline constexpr std::size_t kFirstSet = 0, kSecondSet = 1;

/// Raw: as the front left it. Finished: after swaps and smoothing.
enum class MeshStage { Raw, Finished };
inline constexpr std::array kMeshStages{MeshStage::Raw, MeshStage::Finished};
const char* toString(MeshStage stage);

/// What came of one rule set on one model.
struct CaseResult {
  bool hasMesh = false;
  std::string fault;            ///< why the model could not be meshed at all; else empty
  std::size_t failedFaces = 0;  ///< at least 1 if there is no mesh
  std::size_t stuckFaces = 0;   ///< with a front that got stuck, also if it was closed afterwards
  std::size_t withoutRule = 0;  ///< elements that no rule made
  geometry::MeshMeasures measures;
  double seconds = 0;                        ///< without reading the model
  std::optional<geometry::ModelMesh> drawn;  ///< only if the case is drawn
};

/// By stage and rule set.
using CasePair = std::array<std::array<CaseResult, 2>, 2>;

struct SuiteResult {
  std::vector<std::string> names;  ///< of the cases
  std::vector<CasePair> cases;
};

struct SuiteControl {
  bool isTimed = false;      ///< one run after the other, each on one thread
  bool strictRules = false;  ///< only rules make elements, as `af2 mesh --strict-rules`
  bool onlyQuads = false;    ///< only quadrilaterals, as `af2 mesh --elements quad`
  bool keepsMeshes = false;  ///< those of cases that are drawn
  std::stop_token stop;
};

/// The result is incomplete if a stop was requested.
SuiteResult runSuite(const Suite& suite, const std::array<ComparedRules, 2>& sets,
                     const SuiteControl& control);

}  // namespace af2::cli
