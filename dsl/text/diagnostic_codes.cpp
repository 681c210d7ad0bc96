#include "dsl/text/diagnostic_codes.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace af2::dsl {
namespace {

constexpr std::array kCodes{
#define AF2_CODE(id, name, severity, allowance, evidence, stage, page, title, explanation)     \
  CodeInfo{                                                                                    \
      Code::name,   #id,  #name, Severity::severity, Allowance::allowance, Evidence::evidence, \
      Stage::stage, page, title, explanation},
#include "dsl/text/diagnostic_codes.def"
#undef AF2_CODE
};

constexpr std::string_view kPrefix = "AF2-";

}  // namespace

std::span<const CodeInfo> diagnosticCodes() { return kCodes; }

const CodeInfo& infoOf(Code code) { return kCodes[static_cast<std::size_t>(code)]; }

std::optional<Code> findCode(std::string_view id) {
  std::string wanted(id);
  std::transform(wanted.begin(), wanted.end(), wanted.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  if (wanted.starts_with(kPrefix)) wanted = wanted.substr(kPrefix.size());
  const auto found = std::ranges::find(kCodes, std::string_view(wanted), &CodeInfo::id);
  return found == kCodes.end() ? std::nullopt : std::optional(found->code);
}

std::string idOf(Code code) { return std::string(infoOf(code).id); }

std::string fullIdOf(Code code) { return std::string(kPrefix) + idOf(code); }

}  // namespace af2::dsl
