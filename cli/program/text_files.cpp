#include "cli/program/text_files.h"

#include <cstdio>

#include "cli/program/usage_error.h"
#include "engine/base/error.h"
#include "geometry/io/output_file.h"

namespace af2::cli {

void writeText(const std::string& path, std::string_view text) {
  if (path == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  try {
    geometry::OutputFile file(path);
    file.text(text);
    file.commit();
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace af2::cli
