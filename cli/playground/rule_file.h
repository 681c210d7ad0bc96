// The one file that the playground reads and writes.
#pragma once

#include <filesystem>
#include <string>

namespace af2::playground {

/// The content of the file at some time.
struct FileContent {
  std::string text;
  std::string version;  ///< equal for equal texts
  std::string fault;    ///< not empty: why it could not be read; the text is empty then
};

class RuleFile {
 public:
  /// Throws InputError if it cannot be read, is longer than a rule file may be, or is not UTF-8,
  /// which an editor in a browser would not write back as it was.
  explicit RuleFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  FileContent read() const;

  enum class Overwrite { No, Yes };
  struct Saved {
    bool isChanged = false;  ///< the file has another version, so that nothing was written
    std::string version;     ///< of the file now
  };
  /// Writes the file whole or not at all. Unless `overwrite` is Yes, it writes only if the file has
  /// still the version `basis`. Throws InputError if the file cannot be written.
  Saved save(const std::string& text, const std::string& basis, Overwrite overwrite) const;

 private:
  std::filesystem::path path_;
};

/// Lengths above this are refused, as the parser does.
std::size_t maxTextBytes();

}  // namespace af2::playground
