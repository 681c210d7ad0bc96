#include "engine/base/loaded_function.h"

#include <dlfcn.h>

#include <string>

#include "engine/base/error.h"

namespace af2 {

void* functionOf(const LoadedLibrary& library, const char* function) {
  void* const loaded = ::dlopen(library.name, RTLD_NOW | RTLD_LOCAL);  // of what is loaded: that
  void* const found = loaded ? ::dlsym(loaded, function) : nullptr;
  if (found) return found;
  throw InputError(std::string(library.purpose) + " need the library " + library.name +
                   ", which cannot be loaded (" + ::dlerror() +
                   "); install it (on Debian: apt install " + library.package + ")");
}

}  // namespace af2
