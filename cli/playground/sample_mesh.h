// Meshes a sample domain with the rules of a text.
#pragma once

#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>

#include "cli/playground/sample_domains.h"
#include "dsl/load/rule_file.h"

namespace af2::playground {

struct SampleRequest {
  const SampleDomain* domain = nullptr;
  const SampleSize* size = nullptr;
  bool byRule = true;  ///< colours of elements; otherwise by quality
  bool optimize = true;
};

/// {fault, svg, makers: [{title, line, count, color}], elements, triangles, quads, withoutRule,
/// quality: {min, mean, minAngle, maxAngle}, notes}. `makers` are the rules that made elements, the
/// most frequent first, and what made the others; `line` is 0 unless it is a rule of the text.
/// `fault` says why there is no mesh.
nlohmann::json sampleMesh(const std::string& path, const std::string& text,
                          const dsl::LoadOptions& loading, const SampleRequest& request,
                          const std::stop_token& stop);

}  // namespace af2::playground
