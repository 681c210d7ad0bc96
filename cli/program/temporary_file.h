// A file in a folder of its own, for readers that need a file.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <span>
#include <string>

namespace af2::cli {

/// Goes away with its folder when this does, in the process that made it: a supervised process that
/// ends leaves the file to the others.
class TemporaryFile {
 public:
  /// name  of the file, without folders
  /// what  it has, for messages: "standard input"
  ///
  /// Throws InputError, with a way out, if there is no room.
  TemporaryFile(const std::string& name, std::span<const char> content, const std::string& what);
  ~TemporaryFile() { remove(); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void remove() const;

 private:
  std::filesystem::path folder_, path_;
  pid_t owner_;
};

}  // namespace af2::cli
