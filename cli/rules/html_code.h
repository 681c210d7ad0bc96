// Rule text as HTML.
#pragma once

#include <string>
#include <string_view>

#include "dsl/text/source_text.h"

namespace af2::cli {

std::string escapeHtml(std::string_view text);

/// Part of a rule file as the content of a <pre>, with classes for keywords, strings, numbers and
/// comments. The indent of the first line is removed from all lines.
std::string codeHtml(const dsl::SourceText& source, dsl::Span part);

}  // namespace af2::cli
