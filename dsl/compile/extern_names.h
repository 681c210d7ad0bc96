// Names that a rule file declares with `extern` and a program registers.
#pragma once

#include <memory>

#include "dsl/compile/compile_context.h"

namespace af2::dsl {

/// What the declaration stands for: what the program registered under the name, or a stand-in.
/// Null if the declaration is malformed or contradicts what is registered, which is reported at it.
std::shared_ptr<const ExternName> resolveExtern(CompileContext& context, const Module& module,
                                                const Extern& item);

/// Whether both are declared, and in the same way: several files may declare what they call.
bool areDeclaredAlike(const FunctionName& one, const FunctionName& other);

}  // namespace af2::dsl
