#include "cli/rules_location.h"

#include <fmt/core.h>

#include <cstdlib>

#include "engine/error.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

bool isDirectory(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

fs::path programDirectory() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : program.parent_path();
}

}  // namespace

fs::path rulesDirectory() {
  if (const char* chosen = std::getenv("AF2_RULES"); chosen != nullptr && *chosen != '\0') {
    if (isDirectory(chosen)) return chosen;
    throw InputError(fmt::format("AF2_RULES='{}' is no directory; unset it or correct it", chosen));
  }
  const fs::path program = programDirectory();
  for (const fs::path& place : {program / ".." / "share" / "af2" / "rules",  // installed
                                program / ".." / ".." / "rules",             // build/cli/af2
                                fs::path(AF2_SOURCE_RULES)}) {               // any build tree
    if (isDirectory(place)) return place.lexically_normal();
  }
  throw InputError("the rules that AF2 comes with are not where the program is; set AF2_RULES");
}

fs::path findRuleFile(const fs::path& name) {
  if (isFile(name)) return name;
  if (isDirectory(name)) {
    throw InputError(fmt::format("'{}' is a directory; give a rule file", name.string()));
  }
  const fs::path rules = rulesDirectory();
  for (const fs::path& place : {rules / name, rules / (name.string() + ".af2")}) {
    if (isFile(place)) return place;
  }
  throw InputError(fmt::format("there is no rule file '{}', neither here nor in '{}'",
                               name.string(), rules.string()));
}

}  // namespace af2::cli
