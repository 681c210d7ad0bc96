#include "engine/base/loaded_function.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <string>

#include "engine/base/error.h"

namespace af2 {
namespace {

constexpr LoadedLibrary kC{"libc.so.6", "numbers", "libc6"};
AF2_LOADED_FUNCTION(kC, labs);

TEST(LoadedFunction, IsThatOfTheLibrary) {
  EXPECT_EQ(labs(-27L), 27);
  EXPECT_EQ(labs(-8), 8) << "arguments are converted";
}

std::string messageOf(const LoadedLibrary& library, const char* function) {
  try {
    functionOf(library, function);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LoadedFunction, TellsWhatIsMissingForWhat) {
  const std::string noLibrary = messageOf({"libnone.so.1", "pictures", "libnone1"}, "draw");
  EXPECT_EQ(noLibrary.find("pictures need the library libnone.so.1, which cannot be loaded ("), 0u)
      << noLibrary;
  EXPECT_NE(noLibrary.find("); install it (on Debian: apt install libnone1)"), std::string::npos)
      << noLibrary;
  const std::string noFunction = messageOf(kC, "af2_none");
  EXPECT_NE(noFunction.find("af2_none"), std::string::npos) << noFunction;
}

}  // namespace
}  // namespace af2
