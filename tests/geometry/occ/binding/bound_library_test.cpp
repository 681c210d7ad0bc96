#include "geometry/occ/binding/bound_library.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

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
  explicit Loaded(const std::string& path, int mode = RTLD_LOCAL)
      : path_(path), library_(dlopen(path.c_str(), RTLD_NOW | mode)) {
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
  const Loaded first(GetParam(), RTLD_GLOBAL);
  const Loaded copy(copy_), bound(bound_);
  for (const char* function : {"placeOfData", "placeInTable"}) {
    EXPECT_FALSE(copy.leadsHere(function)) << function;  // as the dynamic linker finds them
    EXPECT_TRUE(bound.leadsHere(function)) << function;
  }
  EXPECT_FALSE(copy.leadsHere("placeCalled"));
  const bool isLazy = std::string(GetParam()).find("lazy") != std::string::npos;
  EXPECT_EQ(bound.leadsHere("placeCalled"), !isLazy);
}

TEST_P(BoundLibrary, SharesWhatAProcessHasOnce) {
  const Loaded first(GetParam(), RTLD_GLOBAL), bound(bound_);
  EXPECT_EQ(bound.call<const void*>("placeOfUnique"), first.call<const void*>("placeOfUnique"));
}

TEST_P(BoundLibrary, ComputesAsBefore) {
  for (const std::string& library : {std::string(GetParam()), bound_}) {
    const Loaded loaded(library);
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

INSTANTIATE_TEST_SUITE_P(Samples, BoundLibrary, ::testing::Values(AF2_SAMPLE_NOW, AF2_SAMPLE_LAZY),
                         [](const auto& sample) { return sample.index == 0 ? "Now" : "Lazy"; });

}  // namespace
}  // namespace af2::geometry
