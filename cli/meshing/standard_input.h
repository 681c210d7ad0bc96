// A model that comes through standard input.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace af2::cli {

/// Whether an argument means standard input: "-" or "/dev/stdin".
bool isStandardInput(const std::string& model);

/// The extension of the format that a model has by its content, with the dot; empty if that cannot
/// be told.
std::string extensionByContent(const std::string& content);

/// A temporary file with what standard input had, named so that its extension tells the format.
/// Goes away with this, in the process that made it.
class StandardInput {
 public:
  /// Reads to the end. `format` is the name of an extension, without the dot; empty: the content
  /// tells.
  ///
  /// Throws UsageError if there is no such format, InputError if nothing comes, or nothing that
  /// tells its format.
  explicit StandardInput(const std::string& format);
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;
  ~StandardInput();

  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path folder_, file_;
  pid_t owner_;
};

}  // namespace af2::cli
