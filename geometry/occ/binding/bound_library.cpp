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
    firstSegment_ = header.e_phoff;
    for (std::size_t i = 0; i < header.e_phnum; ++i)
      segments_.push_back(read<Elf64_Phdr>(placeOfSegment(i)));
  }

  const std::vector<Elf64_Phdr>& segments() const { return segments_; }
  void setSegment(std::size_t i, const Elf64_Phdr& segment) {
    segments_[i] = segment;
    write(placeOfSegment(i), segment);
  }

  /// Where in the file lies what is at `address` when the library is loaded.
  std::size_t placeOf(Elf64_Addr address) const {
    for (const Elf64_Phdr& segment : segments_)
      if (segment.p_type == PT_LOAD && address >= segment.p_vaddr &&
          address - segment.p_vaddr < segment.p_filesz)
        return segment.p_offset + (address - segment.p_vaddr);
    fail();
  }
  /// Whether code lies there when the library is loaded.
  bool isCode(Elf64_Addr address) const {
    return std::ranges::any_of(segments_, [&](const Elf64_Phdr& segment) {
      return segment.p_type == PT_LOAD && (segment.p_flags & PF_X) != 0 &&
             address >= segment.p_vaddr && address - segment.p_vaddr < segment.p_filesz;
    });
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
  std::size_t placeOfSegment(std::size_t i) const { return firstSegment_ + sizeof(Elf64_Phdr) * i; }
  void check(std::size_t place, std::size_t size) const {
    if (place > bytes_.size() || size > bytes_.size() - place) fail();
  }
  std::string bytes_;
  std::size_t firstSegment_ = 0;
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

  /// Whether functions are looked up when the library is loaded, not when they are first called.
  bool bindsNow() const {
    return has(DT_BIND_NOW) || ((*this)[DT_FLAGS] & DF_BIND_NOW) != 0 ||
           ((*this)[DT_FLAGS_1] & DF_1_NOW) != 0;
  }
  /// Without DT_BIND_NOW, which linkers no longer write.
  void bindLate(ElfFile& file) const {
    if (has(DT_FLAGS)) set(file, DT_FLAGS, (*this)[DT_FLAGS] & ~Elf64_Xword{DF_BIND_NOW});
    if (has(DT_FLAGS_1)) set(file, DT_FLAGS_1, (*this)[DT_FLAGS_1] & ~Elf64_Xword{DF_1_NOW});
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
    bindData();
    if (dynamic_.has(DT_JMPREL)) bindCalls();
    return file_.take();
  }

 private:
  void bindData() {
    std::vector<Elf64_Rela> all = table(DT_RELA, DT_RELASZ);
    for (Elf64_Rela& r : all) r = bound(r);
    // The dynamic linker takes those without symbols from the front of the table, all at once.
    const auto others = std::stable_partition(all.begin(), all.end(), isRelative);
    write(DT_RELA, all);
    if (dynamic_.has(DT_RELACOUNT))
      dynamic_.set(file_, DT_RELACOUNT, Elf64_Xword(others - all.begin()));
  }

  void bindCalls() {
    std::vector<Elf64_Rela> calls = table(DT_JMPREL, DT_PLTRELSZ);
    if (canBeLookedUpLate(calls)) {
      // To a slot of a function that is looked up later, the dynamic linker only adds where the
      // library has been loaded: at first the slots lead to the code that looks up.
      for (const Elf64_Rela& call : calls)
        if (const auto symbol = symbolOf(call); isBoundHere(symbol))
          file_.write(file_.placeOf(call.r_offset), symbol.st_value);
      dynamic_.bindLate(file_);
      keepWritable(dynamic_[DT_PLTGOT]);
    } else if (dynamic_.bindsNow()) {
      for (Elf64_Rela& call : calls) call = bound(call);
      write(DT_JMPREL, calls);
    }
  }

  /// Whether all slots of calls lead to code, and the entries before them are for the dynamic
  /// linker to fill: as linkers leave them even in libraries that are to be bound at once.
  bool canBeLookedUpLate(const std::vector<Elf64_Rela>& calls) const {
    if (!dynamic_.has(DT_PLTGOT) || dynamic_.has(DT_BIND_NOW)) return false;
    for (const std::size_t entry : {1, 2})
      if (wordAt(dynamic_[DT_PLTGOT] + entry * sizeof(Elf64_Xword)) != 0) return false;
    return std::ranges::all_of(calls, [&](const Elf64_Rela& call) {
      return ELF64_R_TYPE(call.r_info) == R_X86_64_JUMP_SLOT && file_.isCode(wordAt(call.r_offset));
    });
  }

  /// What the dynamic linker makes read-only ends before this address.
  void keepWritable(Elf64_Addr address) {
    for (std::size_t i = 0; i < file_.segments().size(); ++i) {
      Elf64_Phdr segment = file_.segments()[i];
      if (segment.p_type != PT_GNU_RELRO || address < segment.p_vaddr ||
          address - segment.p_vaddr >= segment.p_memsz)
        continue;
      segment.p_memsz = address - segment.p_vaddr;
      segment.p_filesz = std::min(segment.p_filesz, segment.p_memsz);
      file_.setSegment(i, segment);
    }
  }

  std::vector<Elf64_Rela> table(Elf64_Sxword table, Elf64_Sxword size) const {
    std::vector<Elf64_Rela> relocations;
    const std::size_t begin = file_.placeOf(dynamic_[table]);
    for (std::size_t at = 0; at + sizeof(Elf64_Rela) <= dynamic_[size]; at += sizeof(Elf64_Rela))
      relocations.push_back(file_.read<Elf64_Rela>(begin + at));
    return relocations;
  }

  Elf64_Xword wordAt(Elf64_Addr address) const {
    return file_.read<Elf64_Xword>(file_.placeOf(address));
  }

  Elf64_Sym symbolOf(const Elf64_Rela& r) const {
    return file_.read<Elf64_Sym>(symbols_ + sizeof(Elf64_Sym) * ELF64_R_SYM(r.r_info));
  }

  Elf64_Rela bound(Elf64_Rela r) const {
    if (!namesSymbol(r)) return r;
    const Elf64_Sym symbol = symbolOf(r);
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
