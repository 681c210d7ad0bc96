// R2: every rule has a title of its own.
#pragma once

#include <span>

#include "dsl/compiled_rule.h"
#include "dsl/diagnostic.h"
#include "dsl/module.h"

namespace af2::dsl {

/// Rules of one title, by the text of the file and by what families, templates and other files make
/// of it.
void checkTitles(const Module& main, std::span<const CompiledRule> rules,
                 DiagnosticList& diagnostics);

}  // namespace af2::dsl
