// bind-libraries FOLDER LIBRARY...: puts bound copies of shared libraries into the folder, under
// the names that are given. Copies of libraries that cannot be bound are removed: programs that
// look into the folder first go on with the original then. Ends with 1 if there are such libraries.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/base/error.h"
#include "geometry/occ/binding/bound_library.h"

namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in) throw af2::InputError("it cannot be read");
  return content;
}

/// Programs that use the file go on with the old one.
void replace(const fs::path& path, const std::string& content) {
  const fs::path written = path.string() + ".new";
  std::ofstream out(written, std::ios::binary);
  out << content;
  out.close();
  if (!out) {
    fs::remove(written);
    throw af2::InputError("'" + written.string() + "' cannot be written");
  }
  fs::rename(written, path);
}

bool bind(const fs::path& library, const fs::path& folder) {
  const fs::path copy = folder / library.filename();
  try {
    replace(copy, af2::geometry::boundLibrary(contentOf(library)));
    return true;
  } catch (const std::exception& error) {
    std::error_code failed;
    fs::remove(copy, failed);
    std::fprintf(stderr, "bind-libraries: '%s': %s\n", library.c_str(), error.what());
    return false;
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: bind-libraries FOLDER LIBRARY...\n");
    return 2;
  }
  const fs::path folder = arguments[1];
  std::error_code failed;
  fs::create_directories(folder, failed);
  int code = 0;
  for (int i = 2; i < count; ++i)
    if (!bind(arguments[i], folder)) code = 1;
  return code;
}
