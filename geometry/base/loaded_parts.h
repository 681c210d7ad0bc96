// Parts of AF2 that are libraries of their own, loaded when they are needed. Not installed.
#pragma once

#include <filesystem>
#include <string>

namespace af2::geometry {

/// Where the library lies: beside the program or library that has this code, or in the folder of
/// its libraries. Empty: nowhere there.
std::filesystem::path placeOfPart(const std::string& library);

/// The function `entry` of the library, which is loaded and stays so.
///
/// Throws InputError, naming the library, if it is not there or cannot be loaded; null if it has no
/// such function.
void* entryOfPart(const std::string& library, const char* entry);

/// For a library that has been compiled from other sources than its caller.
[[noreturn]] void refusePart(const std::string& library);

/// What a library offers: the result of its function `const Module* ()`.
///
/// isSame  whether a module was compiled from the same sources as the caller, as far as can be told
///
/// Throws InputError as entryOfPart, and if it was not.
template <class Module, class IsSame>
const Module& moduleOfPart(const std::string& library, const char* entry, const IsSame& isSame) {
  void* const found = entryOfPart(library, entry);
  const Module* const module = found ? reinterpret_cast<const Module* (*)()>(found)() : nullptr;
  if (!module || !isSame(*module)) refusePart(library);
  return *module;
}

}  // namespace af2::geometry
