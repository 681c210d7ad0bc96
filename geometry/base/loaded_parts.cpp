#include "geometry/base/loaded_parts.h"

#include <dlfcn.h>

#include <vector>

#include "engine/base/error.h"

namespace af2::geometry {

namespace {

namespace fs = std::filesystem;

fs::path folderOfProgram() {
  std::error_code failed;
  return fs::read_symlink("/proc/self/exe", failed).parent_path();
}

/// The same, except for a library that a program has loaded, such as a module for Python.
fs::path folderOfThisCode() {
  Dl_info info{};
  if (!::dladdr(reinterpret_cast<void*>(&placeOfPart), &info) || !info.dli_fname) return {};
  std::error_code failed;
  return fs::weakly_canonical(info.dli_fname, failed).parent_path();
}

/// Beside the program, or in the folder of its libraries. The same of a library that a program has
/// loaded; a module for Python lies several folders below what AF2 is installed in.
std::vector<fs::path> foldersOfParts() {
  std::vector<fs::path> folders;
  const auto add = [&](const fs::path& folder) {
    if (folder.empty()) return;
    folders.push_back(folder);
    folders.push_back((folder / AF2_LIBRARIES_FROM_PROGRAM).lexically_normal());
    folders.push_back(folder / "af2");
  };
  add(folderOfProgram());
  const fs::path own = folderOfThisCode();
  add(own);
  constexpr int kMostAbove = 4;
  fs::path above = own;
  for (int i = 0; i < kMostAbove && above.has_relative_path(); ++i) {
    above = above.parent_path();
    folders.push_back((above / "bin" / AF2_LIBRARIES_FROM_PROGRAM).lexically_normal());
  }
  return folders;
}

}  // namespace

fs::path placeOfPart(const std::string& library) {
  std::error_code failed;
  for (const fs::path& folder : foldersOfParts())
    if (fs::exists(folder / library, failed)) return folder / library;
  return {};
}

void* entryOfPart(const std::string& library, const char* entry) {
  const fs::path place = placeOfPart(library);
  if (place.empty())
    throw InputError("the library '" + library + "' that belongs to this program is not in '" +
                     folderOfProgram().string() + "'; copy or install it along with the program");
  // Functions are looked up when they are first called: for what a file needs, these are few.
  void* const loaded = ::dlopen(place.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!loaded) throw InputError("cannot load a part of this program: " + std::string(::dlerror()));
  return ::dlsym(loaded, entry);
}

void refusePart(const std::string& library) {
  throw InputError(placeOfPart(library).string() +
                   " belongs to another version of this program; build or install both together");
}

}  // namespace af2::geometry
