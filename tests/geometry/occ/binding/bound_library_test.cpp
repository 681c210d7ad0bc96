#include "geometry/occ/binding/bound_library.h"

#include <dlfcn.h>
#include <elf.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <vector>

#include "engine/base/error.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A library that is loaded for as long as this lives.
class Loaded {
 public:
  explicit Loaded(const std::string& path, int mode = RTLD_LAZY)
      : path_(path), library_(dlopen(path.c_str(), mode)) {
    if (!library_) throw std::runtime_error(dlerror());
  }
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;
  ~Loaded() { dlclose(library_); }

  template <class Result>
  Result call(const char* function) const {
    return reinterpret_cast<Result (*)()>(dlsym(library_, function))();
  }
  /// The place that the function tells is in this library, not in another one with the same
  /// symbols.
  bool leadsHere(const char* function) const {
    Dl_info info{};
    return dladdr(call<const void*>(function), &info) != 0 && info.dli_fname == path_;
  }

 private:
  std::string path_;
  void* library_;
};

class BoundLibrary : public ::testing::TestWithParam<const char*> {
 protected:
  BoundLibrary()
      : original_(contentOf(GetParam())),
        copy_(folder_.write("copy.so", original_).string()),
        bound_(folder_.write("bound.so", boundLibrary(original_)).string()) {}

  af2::testing::TestFolder folder_;
  std::string original_, copy_, bound_;
};

TEST_P(BoundLibrary, UsesItsOwnSymbolsWhateverElseIsLoaded) {
  const Loaded first(GetParam(), RTLD_LAZY | RTLD_GLOBAL);
  const Loaded copy(copy_), bound(bound_);
  for (const char* function : {"placeOfData", "placeInTable", "placeCalled"}) {
    EXPECT_FALSE(copy.leadsHere(function)) << function;  // as the dynamic linker finds them
    EXPECT_TRUE(bound.leadsHere(function)) << function;
  }
}

TEST_P(BoundLibrary, SharesWhatAProcessHasOnce) {
  const Loaded first(GetParam(), RTLD_LAZY | RTLD_GLOBAL), bound(bound_);
  EXPECT_EQ(bound.call<const void*>("placeOfUnique"), first.call<const void*>("placeOfUnique"));
}

TEST_P(BoundLibrary, ComputesAsBefore) {
  for (const auto& [library, mode] : {std::pair(std::string(GetParam()), RTLD_NOW),
                                      std::pair(bound_, RTLD_LAZY), std::pair(bound_, RTLD_NOW)}) {
    const Loaded loaded(library, mode);
    EXPECT_EQ(loaded.call<int>("valueInside"), 30);
    EXPECT_EQ(loaded.call<int>("valueChosen"), 22);
    EXPECT_EQ(loaded.call<int>("valueOfOtherLibrary"), 4);
    EXPECT_EQ(loaded.call<int>("countedInThread"), 1);
    EXPECT_EQ(loaded.call<int>("countedInThread"), 2);
  }
}

TEST_P(BoundLibrary, IsNotChangedAgain) {
  const std::string once = boundLibrary(original_);
  EXPECT_NE(once, original_);
  EXPECT_EQ(once.size(), original_.size());
  EXPECT_EQ(boundLibrary(once), once);
}

/// As linkers may leave them that have all functions looked up at once.
void emptySlotsOfCalls(std::string& library) {
  const auto at = [&]<class T>(std::size_t place, T*) {
    T value;
    std::memcpy(&value, library.data() + place, sizeof(T));
    return value;
  };
  const auto header = at(0, static_cast<Elf64_Ehdr*>(nullptr));
  std::vector<Elf64_Phdr> segments;
  for (std::size_t i = 0; i < header.e_phnum; ++i)
    segments.push_back(
        at(header.e_phoff + i * sizeof(Elf64_Phdr), static_cast<Elf64_Phdr*>(nullptr)));
  const auto placeOf = [&](Elf64_Addr address) {
    for (const Elf64_Phdr& segment : segments)
      if (segment.p_type == PT_LOAD && address - segment.p_vaddr < segment.p_filesz)
        return segment.p_offset + (address - segment.p_vaddr);
    throw std::runtime_error("no segment");
  };
  std::map<Elf64_Sxword, Elf64_Xword> dynamic;
  for (const Elf64_Phdr& segment : segments)
    for (std::size_t i = 0;
         segment.p_type == PT_DYNAMIC && i < segment.p_filesz / sizeof(Elf64_Dyn); ++i) {
      const auto entry =
          at(segment.p_offset + i * sizeof(Elf64_Dyn), static_cast<Elf64_Dyn*>(nullptr));
      dynamic[entry.d_tag] = entry.d_un.d_val;
    }
  for (std::size_t i = 0; i < dynamic[DT_PLTRELSZ] / sizeof(Elf64_Rela); ++i) {
    const auto call =
        at(placeOf(dynamic[DT_JMPREL]) + i * sizeof(Elf64_Rela), static_cast<Elf64_Rela*>(nullptr));
    std::memset(library.data() + placeOf(call.r_offset), 0, sizeof(Elf64_Addr));
  }
}

/// Whatever its tables say: an error, or some other library, but no crash.
void tryToBind(std::string damaged) {
  try {
    boundLibrary(std::move(damaged));
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("shared library"), std::string::npos);
  }
}

TEST_P(BoundLibrary, RefusesDamagedLibraries) {
  for (const char* text : {"", "no library", "\177ELF"})
    EXPECT_THROW(boundLibrary(text), InputError) << text;
  for (std::size_t size = 0; size < original_.size(); size += 61)
    tryToBind(original_.substr(0, size));
  std::mt19937 random(5);
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = original_;
    for (int byte = 0; byte < 4; ++byte)
      damaged[random() % (i % 2 == 0 ? 1024 : damaged.size())] = static_cast<char>(random());
    tryToBind(std::move(damaged));
  }
}

TEST(BoundCalls, LookUpOtherFunctionsWhenTheyAreFirstCalled) {
  const af2::testing::TestFolder folder;
  const std::string original = contentOf(AF2_SAMPLE_UNRESOLVED);
  EXPECT_THROW(Loaded(folder.write("copy.so", original).string()), std::runtime_error);
  const std::string bound = boundLibrary(original);
  EXPECT_THROW(Loaded(folder.write("now.so", bound).string(), RTLD_NOW), std::runtime_error);
  EXPECT_EQ(Loaded(folder.write("bound.so", bound).string()).call<int>("valueOfOtherLibrary"), 4);
}

/// Tables of calls that the dynamic linker cannot use later: all functions are looked up at once.
TEST(BoundCalls, StayAsTheyAreWhereTheirSlotsAreUnusual) {
  const af2::testing::TestFolder folder;
  std::string original = contentOf(AF2_SAMPLE_UNRESOLVED);
  emptySlotsOfCalls(original);
  const std::string bound = folder.write("bound.so", boundLibrary(original)).string();
  EXPECT_THROW(Loaded{bound}, std::runtime_error);
  std::string other = contentOf(AF2_SAMPLE_NOW);
  emptySlotsOfCalls(other);
  const Loaded first(AF2_SAMPLE_NOW, RTLD_LAZY | RTLD_GLOBAL);
  const Loaded loaded(folder.write("other.so", boundLibrary(other)).string());
  EXPECT_TRUE(loaded.leadsHere("placeCalled"));
  EXPECT_EQ(loaded.call<int>("valueOfOtherLibrary"), 4);
}

INSTANTIATE_TEST_SUITE_P(Samples, BoundLibrary, ::testing::Values(AF2_SAMPLE_NOW, AF2_SAMPLE_LAZY),
                         [](const auto& sample) { return sample.index == 0 ? "Now" : "Lazy"; });

}  // namespace
}  // namespace af2::geometry
