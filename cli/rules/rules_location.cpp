#include "cli/rules/rules_location.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "engine/base/error.h"

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

/// The rule sets below a directory, sorted by name.
std::string listOf(const fs::path& rules) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(rules))
    if (entry.path().extension() == ".af2")
      names.push_back(entry.path().lexically_relative(rules).string());
  std::ranges::sort(names);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

fs::path rulesDirectory() {
  if (const char* chosen = std::getenv("AF2_RULES"); chosen != nullptr && *chosen != '\0') {
    if (isDirectory(chosen)) return chosen;
    throw InputError(
        fmt::format("AF2_RULES='{}' is not a directory; unset it or correct it", chosen));
  }
  const fs::path program = programDirectory();
  for (const fs::path& place : {program / ".." / "share" / "af2" / "rules",  // installed
                                program / ".." / ".." / "rules",             // build/cli/af2
                                fs::path(AF2_SOURCE_RULES)}) {               // any build tree
    if (isDirectory(place)) return place.lexically_normal();
  }
  throw InputError(
      "the rule files that come with AF2 are not beside the program; set AF2_RULES to their "
      "folder");
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
  throw InputError(fmt::format("there is no rule file '{}', neither here nor in '{}'; AF2 has {}",
                               name.string(), rules.string(), listOf(rules)));
}

}  // namespace af2::cli
