#include "cli/playground/rule_file.h"

#include <fmt/core.h>

#include "dsl/compile/library.h"
#include "dsl/syntax/grammar.h"
#include "engine/base/error.h"
#include "geometry/base/utf8.h"
#include "geometry/io/output_file.h"

namespace af2::playground {
namespace {

/// FNV-1a of 64 bits: a change by hand goes unnoticed once in 10^19 times.
std::string versionOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace

std::size_t maxTextBytes() { return dsl::ParseLimits{}.bytes; }

RuleFile::RuleFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::string name = path_.string();
  std::error_code ignored;
  if (std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored))
    throw InputError(fmt::format("'{}' is not a regular file, which could be read again", name));
  const FileContent content = read();
  if (!content.fault.empty()) throw InputError(fmt::format("'{}': {}", name, content.fault));
  if (content.text.size() > maxTextBytes())
    throw InputError(fmt::format("'{}' is longer than 8 MiB, which no rule file may be", name));
  if (!geometry::isUtf8(content.text))
    throw InputError(
        fmt::format("'{}' is not UTF-8 text; convert it first, such as with iconv", name));
}

FileContent RuleFile::read() const {
  FileContent content;
  auto text = dsl::readFile(path_, content.fault);
  if (!text) return content;
  content.text = std::move(*text);
  content.version = versionOf(content.text);
  return content;
}

RuleFile::Saved RuleFile::save(const std::string& text, const std::string& basis,
                               Overwrite overwrite) const {
  const std::string now = read().version;
  if (overwrite == Overwrite::No && now != basis) return {true, now};
  geometry::OutputFile file(path_);
  file.text(text);
  file.commit();
  return {false, versionOf(text)};
}

}  // namespace af2::playground
