// Whether what is written to a stream may be coloured.
#pragma once

#include <cstdio>

#include "dsl/text/diagnostic.h"

namespace af2::cli {

/// AF2_COLOR=always or never decides; else NO_COLOR forbids, and a terminal is asked for.
dsl::Colour colourOf(std::FILE* stream);

}  // namespace af2::cli
