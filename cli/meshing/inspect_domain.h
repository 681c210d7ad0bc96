// `af2 inspect` for planar domains and surfaces of triangles.
#pragma once

#include <filesystem>

namespace af2::cli {

struct DomainInspection {
  std::filesystem::path model;
  double size = 0;  ///< 0: by the diagonal
  bool brief = false, all = false, edges = false;
};

/// Whether a file is a planar domain or a surface of triangles, as its name says.
bool isDomain(const std::filesystem::path& model);

/// Prints the tables; returns an exit code. Throws InputError if the model cannot be read.
int inspectDomain(const DomainInspection& request);

}  // namespace af2::cli
