#include "cli/program/temporary_file.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>

#include "engine/base/error.h"

namespace af2::cli {

namespace fs = std::filesystem;

TemporaryFile::TemporaryFile(const std::string& name, std::span<const char> content,
                             const std::string& what)
    : owner_(::getpid()) {
  std::error_code missing;
  const fs::path parent = fs::temp_directory_path(missing);
  const auto refuse = [&] [[noreturn]] (int error) {
    throw InputError(fmt::format("{} cannot be kept in '{}': {}; set TMPDIR to another folder",
                                 what, parent.string(), std::strerror(error)));
  };
  if (missing)
    throw InputError(fmt::format("{} cannot be kept: {}; set TMPDIR to a folder that exists", what,
                                 missing.message()));
  constexpr const char* kAnyName = "af2-XXXXXX";  // mkdtemp replaces the last six letters
  std::string pattern = (parent / kAnyName).string();
  if (!::mkdtemp(pattern.data())) refuse(errno);
  folder_ = pattern;
  path_ = folder_ / name;
  std::ofstream file(path_, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  if (file.flush()) return;
  const int error = errno;
  remove();
  refuse(error);
}

void TemporaryFile::remove() const {
  std::error_code ignored;
  if (::getpid() == owner_) fs::remove_all(folder_, ignored);
}

}  // namespace af2::cli
