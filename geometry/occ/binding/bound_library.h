// Shared libraries that need not be searched for their own symbols. Not installed.
#pragma once

#include <string>

namespace af2::geometry {

/// A shared library, as the content of a file, in which every reference to a symbol that the
/// library defines itself is bound to that definition: to its place relative to the library. When
/// the library is loaded, the dynamic linker then adds an address, where it would have looked for a
/// name, which takes a hundred times as long. Functions of other libraries are looked up when they
/// are first called, also in a library that was linked to have them looked up at once, except
/// where its slots of calls do not allow it. The table of these slots stays writable, then. Code
/// stays as it is.
///
/// Differs from the original only for programs that define symbols of the library themselves: these
/// do not replace those of the library. Symbols that must be unique in a process, or that the
/// library chooses while it is loaded, are left to the dynamic linker; so are all functions where
/// the process asks for everything at once (LD_BIND_NOW, RTLD_NOW).
///
/// Throws InputError if it is not an ELF library for x86-64.
std::string boundLibrary(std::string library);

}  // namespace af2::geometry
