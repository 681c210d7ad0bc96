// The language server over a pair of streams.
#pragma once

#include <iosfwd>

#include "cli/lsp/session.h"

namespace af2::lsp {

/// Runs until the editor sends `exit` or closes the stream. Returns the exit code: 0 after a proper
/// shutdown, else 1.
int serve(std::istream& in, std::ostream& out, const Surroundings& surroundings);

}  // namespace af2::lsp
