// The titles of the rules of a file, and the check that they are unique (R2).
#pragma once

#include <span>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/module.h"
#include "dsl/text/diagnostic.h"

namespace af2::dsl {

/// The titles of the rules that an item of a file defines: those of `titlesOf`, and for an instance
/// also those of the mirror images in its template.
std::vector<const Name*> titlesMadeBy(const Item& item, const Module& module);

/// Reports rules with equal titles, both in the text of the file and after families, templates and
/// imports are expanded.
void checkTitles(const Module& main, std::span<const CompiledRule> rules,
                 DiagnosticList& diagnostics);

}  // namespace af2::dsl
