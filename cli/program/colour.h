// Whether output to a stream may be coloured.
#pragma once

#include <cstdio>

#include "dsl/text/diagnostic.h"

namespace af2::cli {

/// AF2_COLOR=always or never decides; otherwise NO_COLOR forbids colour, and else a terminal gets
/// it.
dsl::Colour colourOf(std::FILE* stream);

}  // namespace af2::cli
