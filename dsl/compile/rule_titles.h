// Which titles a file gives to rules; and that every rule has one of its own (R2).
#pragma once

#include <span>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/module.h"
#include "dsl/text/diagnostic.h"

namespace af2::dsl {

/// The titles that an item of a file gives to rules: those of `titlesOf`, and of an instance the
/// ones that its template gives to mirror images.
std::vector<const Name*> titlesMadeBy(const Item& item, const Module& module);

/// Rules of one title, by the text of the file and by what families, templates and other files make
/// of it.
void checkTitles(const Module& main, std::span<const CompiledRule> rules,
                 DiagnosticList& diagnostics);

}  // namespace af2::dsl
