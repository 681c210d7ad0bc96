#include "cli/lsp/pictures.h"

#include <algorithm>

#include "cli/lsp/rule_facts.h"
#include "dsl/picture/rule_picture.h"

namespace af2::lsp {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string pictureLink(const RuleSet& rules, const AF2Rule& rule) {
  dsl::PictureOptions options;
  options.width = options.height = 320;
  const std::string svg = dsl::drawRule(rules, rule, dsl::PictureFormat::Svg, options);
  return "![the rule](data:image/svg+xml;base64," + base64(svg) + ")";
}

std::string drawingOf(const RuleSet& rules, const std::vector<std::string>& titles) {
  if (titles.size() == 1)
    if (const AF2Rule* rule = findSound(rules, titles.front()))
      return dsl::drawRule(rules, *rule, dsl::PictureFormat::Svg);
  RuleSetDefinition some = rules.definition();
  std::erase_if(some.rules, [&](const AF2Rule& rule) {
    return std::ranges::find(titles, rule.name()) == titles.end();
  });
  return drawingOf(RuleSet(std::move(some)));
}

std::string drawingOf(const RuleSet& rules) {
  return dsl::drawRuleSet(rules, dsl::PictureFormat::Svg);
}

}  // namespace af2::lsp
