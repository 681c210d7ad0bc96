#include "cli/playground/sample_domains.h"

#include <gtest/gtest.h>

#include "cli/playground/sample_mesh.h"
#include "dsl/compile/library.h"

namespace af2::playground {
namespace {

TEST(SampleDomains, AreFilledByTheRulesOfAF2) {
  std::string fault;
  const std::string path = AF2_SOURCE_DIR "/rules/tri/even.af2";
  const std::string text = dsl::readFile(path, fault).value();
  dsl::LoadOptions loading;
  loading.searchPaths = {AF2_SOURCE_DIR "/rules"};
  for (const SampleDomain& domain : sampleDomains())
    for (const SampleSize& size : sampleSizes().first(3)) {
      const auto mesh = sampleMesh(path, text, loading, {&domain, &size}, {});
      EXPECT_EQ(mesh["fault"], "") << domain.name << " " << size.name;
      EXPECT_EQ(mesh["notes"].size(), 0U) << domain.name << " " << size.name << mesh["notes"];
      EXPECT_LT(mesh["elements"], 6000) << domain.name << " " << size.name;
    }
}

}  // namespace
}  // namespace af2::playground
