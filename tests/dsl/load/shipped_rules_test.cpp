#include "dsl/load/shipped_rules.h"

#include <gtest/gtest.h>

#include "dsl/load/rule_file.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

TEST(ShippedRules, AreThoseOfTheFiles) {
  EXPECT_GE(shippedFiles().size(), 5u);
  for (const ShippedFile& file : shippedFiles()) {
    const LoadedRules loaded = loadRules(AF2_SOURCE_DIR "/rules/" + std::string(file.name));
    ASSERT_TRUE(loaded.rules) << file.name;
    const auto shipped = shippedRules(file.name);
    EXPECT_EQ(shipped->name(), loaded.rules->name());
    EXPECT_EQ(shipped->rules().size(), loaded.rules->rules().size());
  }
}

TEST(ShippedRules, AreTheDefaultOnesUnlessNamed) {
  EXPECT_EQ(defaultRules()->name(), "even triangles");
  EXPECT_EQ(shippedRules("quad/paving.af2")->name(), "paving");
}

TEST(ShippedRules, NameWhatThereIsInstead) {
  try {
    shippedRules("tri/evn.af2");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("tri/even.af2"), std::string::npos) << error.what();
  }
  EXPECT_THROW(shippedRules("../tri/even"), InputError);
}

}  // namespace
}  // namespace af2::dsl
