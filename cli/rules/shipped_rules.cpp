#include "cli/rules/shipped_rules.h"

#include <algorithm>

#include "dsl/load/shipped_rules.h"

namespace af2::cli {

bool isShipped(const dsl::LoadedFile& file) {
  return std::ranges::all_of(file.modules, [](const auto& module) {
    return std::ranges::count(dsl::shippedFiles(), module->source.text(), &dsl::ShippedFile::text) >
           0;
  });
}

}  // namespace af2::cli
