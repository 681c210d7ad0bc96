// The rule files that AF2 comes with, by their texts.
#pragma once

#include "dsl/load/loaded_file.h"

namespace af2::cli {

/// Whether a file and all its imports are rule files that AF2 comes with, unchanged since the
/// program was built. The tests of AF2 have checked these.
bool isShipped(const dsl::LoadedFile& file);

}  // namespace af2::cli
