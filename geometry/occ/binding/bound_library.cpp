#include "geometry/occ/binding/bound_library.h"

#include <elf.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

/// The content of an ELF file. Nothing is read or written outside of it, whatever its tables say.
class ElfFile {
 public:
  explicit ElfFile(std::string bytes) : bytes_(std::move(bytes)) {
    const auto header = read<Elf64_Ehdr>(0);
    if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
        header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_ident[EI_DATA] != ELFDATA2LSB ||
        header.e_machine != EM_X86_64 || header.e_type != ET_DYN)
      fail();
    for (int i = 0; i < header.e_phnum; ++i)
      segments_.push_back(read<Elf64_Phdr>(header.e_phoff + sizeof(Elf64_Phdr) * unsigned(i)));
  }

  const std::vector<Elf64_Phdr>& segments() const { return segments_; }

  /// Where in the file lies what is at `address` when the library is loaded.
  std::size_t placeOf(Elf64_Addr address) const {
    for (const Elf64_Phdr& segment : segments_)
      if (segment.p_type == PT_LOAD && address >= segment.p_vaddr &&
          address - segment.p_vaddr < segment.p_filesz)
        return segment.p_offset + (address - segment.p_vaddr);
    fail();
  }

  template <class T>
  T read(std::size_t place) const {
    check(place, sizeof(T));
    T value;
    std::memcpy(&value, bytes_.data() + place, sizeof(T));
    return value;
  }
  template <class T>
  void write(std::size_t place, const T& value) {
    check(place, sizeof(T));
    std::memcpy(bytes_.data() + place, &value, sizeof(T));
  }

  std::string take() { return std::move(bytes_); }
  [[noreturn]] static void fail() {
    throw InputError("this is not a shared library for x86-64, or it is damaged");
  }

 private:
  void check(std::size_t place, std::size_t size) const {
    if (place > bytes_.size() || size > bytes_.size() - place) fail();
  }
  std::string bytes_;
  std::vector<Elf64_Phdr> segments_;
};

/// The table of what the dynamic linker needs to know.
class DynamicTable {
 public:
  explicit DynamicTable(const ElfFile& file) {
    for (const Elf64_Phdr& segment : file.segments()) {
      if (segment.p_type != PT_DYNAMIC) continue;
      for (std::size_t at = 0; at < segment.p_filesz; at += sizeof(Elf64_Dyn)) {
        const std::size_t place = segment.p_offset + at;
        const auto entry = file.read<Elf64_Dyn>(place);
        if (entry.d_tag == DT_NULL) break;
        entries_[entry.d_tag] = {place, entry.d_un.d_val};
      }
    }
  }

  bool has(Elf64_Sxword tag) const { return entries_.contains(tag); }
  Elf64_Xword operator[](Elf64_Sxword tag) const {
    const auto found = entries_.find(tag);
    return found == entries_.end() ? 0 : found->second.value;
  }
  void set(ElfFile& file, Elf64_Sxword tag, Elf64_Xword value) const {
    Elf64_Dyn entry{};
    entry.d_tag = tag;
    entry.d_un.d_val = value;
    file.write(entries_.at(tag).place, entry);
  }

  /// All symbols are looked up when the library is loaded, none when it is first used.
  bool bindsNow() const {
    return has(DT_BIND_NOW) || ((*this)[DT_FLAGS] & DF_BIND_NOW) != 0 ||
           ((*this)[DT_FLAGS_1] & DF_1_NOW) != 0;
  }

 private:
  struct Entry {
    std::size_t place = 0;
    Elf64_Xword value = 0;
  };
  std::map<Elf64_Sxword, Entry> entries_;
};

bool isRelative(const Elf64_Rela& r) { return ELF64_R_TYPE(r.r_info) == R_X86_64_RELATIVE; }

bool namesSymbol(const Elf64_Rela& r) {
  const auto type = ELF64_R_TYPE(r.r_info);
  return type == R_X86_64_64 || type == R_X86_64_GLOB_DAT || type == R_X86_64_JUMP_SLOT;
}

/// The same one wherever the library is loaded, and in every library of the process.
bool isBoundHere(const Elf64_Sym& symbol) {
  return symbol.st_shndx != SHN_UNDEF && symbol.st_shndx < SHN_LORESERVE &&
         ELF64_ST_TYPE(symbol.st_info) != STT_GNU_IFUNC &&
         ELF64_ST_BIND(symbol.st_info) != STB_GNU_UNIQUE;
}

class Binder {
 public:
  explicit Binder(std::string library) : file_(std::move(library)), dynamic_(file_) {}

  std::string run() {
    if (!dynamic_.has(DT_SYMTAB) || !dynamic_.has(DT_RELA)) return file_.take();
    symbols_ = file_.placeOf(dynamic_[DT_SYMTAB]);
    std::vector<Elf64_Rela> bound = boundTable(DT_RELA, DT_RELASZ);
    // The dynamic linker takes those without symbols from the front of the table, all at once.
    const auto others = std::stable_partition(bound.begin(), bound.end(), isRelative);
    write(DT_RELA, bound);
    if (dynamic_.has(DT_RELACOUNT))
      dynamic_.set(file_, DT_RELACOUNT, Elf64_Xword(others - bound.begin()));
    // Where functions are looked up at their first call, the table of calls has to stay as it is.
    if (dynamic_.has(DT_JMPREL) && dynamic_.bindsNow())
      write(DT_JMPREL, boundTable(DT_JMPREL, DT_PLTRELSZ));
    return file_.take();
  }

 private:
  std::vector<Elf64_Rela> boundTable(Elf64_Sxword table, Elf64_Sxword size) const {
    std::vector<Elf64_Rela> relocations;
    const std::size_t begin = file_.placeOf(dynamic_[table]);
    for (std::size_t at = 0; at + sizeof(Elf64_Rela) <= dynamic_[size]; at += sizeof(Elf64_Rela))
      relocations.push_back(boundOne(file_.read<Elf64_Rela>(begin + at)));
    return relocations;
  }

  Elf64_Rela boundOne(Elf64_Rela r) const {
    if (!namesSymbol(r)) return r;
    const auto symbol = file_.read<Elf64_Sym>(symbols_ + sizeof(Elf64_Sym) * ELF64_R_SYM(r.r_info));
    if (!isBoundHere(symbol)) return r;
    const bool isAdded = ELF64_R_TYPE(r.r_info) == R_X86_64_64;
    r.r_addend = static_cast<Elf64_Sxword>(symbol.st_value) + (isAdded ? r.r_addend : 0);
    r.r_info = ELF64_R_INFO(0, R_X86_64_RELATIVE);
    return r;
  }

  void write(Elf64_Sxword table, const std::vector<Elf64_Rela>& relocations) {
    std::size_t place = file_.placeOf(dynamic_[table]);
    for (const Elf64_Rela& relocation : relocations) {
      file_.write(place, relocation);
      place += sizeof(Elf64_Rela);
    }
  }

  ElfFile file_;
  DynamicTable dynamic_;
  std::size_t symbols_ = 0;
};

}  // namespace

std::string boundLibrary(std::string library) { return Binder(std::move(library)).run(); }

}  // namespace af2::geometry
