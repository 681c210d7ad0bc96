// The readers of STEP and IGES files for the program af2: from libraries beside it that are loaded
// when the first such file is read.
#include <dlfcn.h>

#include <cstring>
#include <sstream>
#include <string>

#include "engine/base/error.h"
#include "geometry/occ/loading/reader_module.h"
#include "geometry/occ/read/readers.h"

namespace af2::geometry {

namespace {

namespace fs = std::filesystem;

/// Looking up a name in its own library first, and only then in those of the program, saves a third
/// of the time of loading. Where something replaces the functions of the C library that reserve
/// memory, all libraries have to get the same ones, so this is left out.
int bindingMode() {
#if defined(RTLD_DEEPBIND) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  for (const char* name : {"malloc", "free"}) {
    Dl_info info{};
    void* const function = ::dlsym(RTLD_DEFAULT, name);
    if (!function || !::dladdr(function, &info) || !info.dli_fname ||
        !fs::path(info.dli_fname).filename().string().starts_with("libc.so"))
      return 0;
  }
  return RTLD_DEEPBIND;
#else
  return 0;
#endif
}

/// Beside the program when it was built, in the folder of its libraries when it was installed.
fs::path placeOf(const std::string& library) {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const fs::path& place : {program / library, program / AF2_LIBRARIES_FROM_PROGRAM / library})
    if (fs::exists(place, failed)) return place;
  throw InputError("the library '" + library + "' that belongs to this program is not in '" +
                   program.string() + "'; copy or install it along with the program");
}

/// Libraries that others need come first, so that each looks for names in few of them. One that is
/// not there under this name is found when the module is loaded, or that tells what is missing.
void loadFirst(const char* names, int mode) {
  std::istringstream list(names);
  for (std::string name; list >> name;) ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | mode);
}

const ReaderModule& load(const std::string& library, const char* needed) {
  const fs::path place = placeOf(library);
  const int mode = bindingMode();
  loadFirst(needed, mode);
  void* const module = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL | mode);
  if (!module) throw InputError("cannot load a part of this program: " + std::string(::dlerror()));
  void* const entry = ::dlsym(module, kReaderModuleEntry);
  const ReaderModule* const found =
      entry ? reinterpret_cast<const ReaderModule* (*)()>(entry)() : nullptr;
  if (!found || std::strcmp(found->version, AF2_VERSION) != 0 ||
      found->shapeSize != sizeof(ReadShape))
    throw InputError(place.string() +
                     " belongs to another version of this program; build or install both together");
  return *found;
}

}  // namespace

ReadShape readStep(const fs::path& path) {
  static const ReaderModule& reader = load("af2-step.so", AF2_NEEDED_BY_STEP);
  return reader.read(path);
}

ReadShape readIges(const fs::path& path) {
  static const ReaderModule& reader = load("af2-iges.so", AF2_NEEDED_BY_IGES);
  return reader.read(path);
}

}  // namespace af2::geometry
