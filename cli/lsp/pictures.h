// Pictures of rules for editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/rule/rule_set.h"

namespace af2::lsp {

std::string base64(std::string_view bytes);

/// A Markdown image that contains the picture of the rule as SVG; empty if there is none.
std::string pictureLink(const RuleSet& rules, const AF2Rule& rule);

/// SVG of some rules of a set: one rule large, several on a sheet.
std::string drawingOf(const RuleSet& rules, const std::vector<std::string>& titles);

/// SVG of a whole set.
std::string drawingOf(const RuleSet& rules);

}  // namespace af2::lsp
