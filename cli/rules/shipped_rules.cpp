#include "cli/rules/shipped_rules.h"

#include <algorithm>
#include <string_view>

namespace af2::cli {
namespace {

constexpr std::string_view kTexts[] = {
#include "shipped_rules.inc"
};

}  // namespace

bool isShipped(const dsl::LoadedFile& file) {
  return std::ranges::all_of(file.modules, [](const auto& module) {
    return std::ranges::count(kTexts, std::string_view(module->source.text())) > 0;
  });
}

}  // namespace af2::cli
