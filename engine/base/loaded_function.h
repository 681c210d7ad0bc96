// Functions of libraries that are loaded when they are first called, because most runs of a program
// do without them and loading takes longer than meshing a small model. Not installed.
#pragma once

namespace af2 {

/// A library of C functions, by the name that the system finds it by.
struct LoadedLibrary {
  const char* name;     ///< such as "libm.so.6"
  const char* purpose;  ///< of which the message tells: "pictures"
  const char* package;  ///< of Debian
};

/// A function of a library, which stays loaded. May be called from several threads at once.
///
/// Throws InputError, saying what is missing for what, if it is not there.
void* functionOf(const LoadedLibrary& library, const char* function);

}  // namespace af2

/// Declares a callable that stands for the C function of the same name, whose header has been
/// included. For unnamed namespaces in source files.
#define AF2_LOADED_FUNCTION(library, function)                                          \
  constexpr auto function = [](auto... arguments) {                                     \
    static const auto loaded =                                                          \
        reinterpret_cast<decltype(&::function)>(::af2::functionOf(library, #function)); \
    return loaded(arguments...);                                                        \
  }
