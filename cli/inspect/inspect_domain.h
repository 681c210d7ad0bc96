// `af2 inspect` for planar domains and surfaces of triangles.
#pragma once

#include <filesystem>

namespace af2::cli {

struct DomainInspection {
  std::filesystem::path model;
  double size = 0;  ///< 0: derived from the diagonal
  bool brief = false, all = false, edges = false, json = false;
};

/// Prints the tables of a model that is not a CAD model; returns an exit code. Throws InputError if
/// the model cannot be read.
int inspectDomain(const DomainInspection& request);

}  // namespace af2::cli
