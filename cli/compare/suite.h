// The models on which `af2 compare` runs rule sets.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/meshing/meshing_options.h"

namespace af2::cli {

/// A rule set to be compared.
struct ComparedRules {
  std::string name;  ///< as on the command line
  std::shared_ptr<const RuleSet> rules;
  AF2Algorithm algorithm;

  ComparedRules(std::string named, std::shared_ptr<const RuleSet> its)
      : name(std::move(named)), rules(its), algorithm(std::move(its)) {}
};

/// A model with its size. One pair of meshes in the comparison.
struct SuiteCase {
  std::string name;  ///< such as "gear, size 0.05"
  /// Of the options, the threads, the request to stop and the optimization are given.
  std::function<geometry::ModelMesh(const ComparedRules&, geometry::MeshingOptions)> mesh;
  bool isDrawn = false;  ///< planar, and on the page
  /// Not to be meshed at the same time as another one: a CAD model, because the readers of
  /// OpenCASCADE have global state.
  bool isAlone = false;
};

struct Suite {
  std::vector<SuiteCase> cases;
  std::vector<std::string> notes;  ///< what was left out
};

/// Planar domains, random planar domains and surfaces. A long suite also has the planar domains at
/// a quarter of the size, and four times as many random domains.
Suite builtInSuite(bool isLong);

/// The models in a folder that AF2 can mesh, sorted by name. The optional file `suite.json` in it
/// gives their sizes; the default is a fortieth of the diagonal of the model.
///
/// Throws InputError if there is no folder or no model, or if suite.json cannot be used.
Suite suiteIn(const std::filesystem::path& folder);

}  // namespace af2::cli
