#include "geometry/occ/step/block_lexer.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <Interface_Static.hxx>
#include <cstddef>
#include <cstdint>
#include <span>

namespace af2::geometry {

namespace {

#ifdef __GLIBC__
/// Puts at most so many characters into a buffer; returns their number, 0 at the end, or less than
/// 0 after an error.
using Input = int (*)(void* lexer, char* buffer, int most);

/// stepFlexLexer::LexerInput, a virtual function, and the virtual functions of the class whose
/// objects read files: step::scanner.
constexpr const char kInput[] = "_ZN13stepFlexLexer10LexerInputEPci";
constexpr const char kFunctions[] = "_ZTVN4step7scannerE";

Input oneCharacter = nullptr;

int manyCharacters(void* lexer, char* buffer, int most) {
  int count = 0;
  while (count < most) {
    const int got = oneCharacter(lexer, buffer + count, 1);
    if (got <= 0) return count > 0 ? count : got;
    ++count;
  }
  return count;
}

/// Of the library that has the lexer, wherever it has been loaded from; null: there is none.
void* handleOfLibrary() {
  Dl_info info{};
  if (!::dladdr(reinterpret_cast<void*>(&Interface_Static::IVal), &info)) return nullptr;
  return ::dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
}

std::span<void*> virtualFunctions(void* library) {
  void* const table = ::dlsym(library, kFunctions);
  Dl_info info{};
  void* extra = nullptr;
  if (!table || !::dladdr1(table, &info, &extra, RTLD_DL_SYMENT) || !extra) return {};
  const auto* const symbol = static_cast<const ElfW(Sym)*>(extra);
  return {static_cast<void**>(table), symbol->st_size / sizeof(void*)};
}

/// The dynamic linker has made these tables read-only. The page stays writable: other variables
/// that have to be may lie on it.
bool replace(void** entry, void* function) {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto first = reinterpret_cast<std::uintptr_t>(entry) & ~(page - 1);
  if (::mprotect(reinterpret_cast<void*>(first), page, PROT_READ | PROT_WRITE) != 0) return false;
  *entry = function;
  return true;
}

bool giveBlocks() {
  void* const library = handleOfLibrary();
  if (!library) return false;
  void* const given = ::dlsym(library, kInput);
  if (!given) return false;
  for (void*& entry : virtualFunctions(library)) {
    if (entry != given) continue;
    oneCharacter = reinterpret_cast<Input>(given);
    return replace(&entry, reinterpret_cast<void*>(&manyCharacters));
  }
  return false;
}
#else
bool giveBlocks() { return false; }
#endif

}  // namespace

bool giveLexerBlocks() {
  static const bool isDone = giveBlocks();
  return isDone;
}

}  // namespace af2::geometry
