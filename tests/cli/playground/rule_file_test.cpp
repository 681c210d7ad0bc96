#include "cli/playground/rule_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/base/error.h"
#include "tests/support/test_folder.h"

namespace af2::playground {
namespace {

namespace fs = std::filesystem;

class RuleFileTest : public ::testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
  std::string text() const {
    std::ostringstream out;
    out << std::ifstream(path_, std::ios::binary).rdbuf();
    return out.str();
  }

  testing::TestFolder folder_;
  fs::path path_ = folder_ / "rules.af2";
};

TEST_F(RuleFileTest, SavesAVersionThatNobodyElseHasChanged) {
  write("one");
  const RuleFile file(path_);
  const auto saved = file.save("two", file.read().version, RuleFile::Overwrite::No);
  EXPECT_FALSE(saved.isChanged);
  EXPECT_EQ(text(), "two");
  EXPECT_EQ(saved.version, file.read().version);
  EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_F(RuleFileTest, OverwritesTheChangesOfOthersOnlyOnRequest) {
  write("one");
  const RuleFile file(path_);
  const std::string basis = file.read().version;
  write("of others");
  EXPECT_TRUE(file.save("two", basis, RuleFile::Overwrite::No).isChanged);
  EXPECT_EQ(text(), "of others");
  EXPECT_FALSE(file.save("two", basis, RuleFile::Overwrite::Yes).isChanged);
  EXPECT_EQ(text(), "two");
}

TEST_F(RuleFileTest, DoesNotBringBackAFileThatWasRemoved) {
  write("one");
  const RuleFile file(path_);
  const std::string basis = file.read().version;
  fs::remove(path_);
  EXPECT_NE(file.read().fault, "");
  EXPECT_TRUE(file.save("two", basis, RuleFile::Overwrite::No).isChanged);
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(RuleFileTest, RefusesWhatAnEditorWouldNotWriteBack) {
  EXPECT_THROW(RuleFile{path_}, InputError);
  write("\xe4");
  EXPECT_THROW(RuleFile{path_}, InputError);
  write(std::string(maxTextBytes() + 1, '#'));
  EXPECT_THROW(RuleFile{path_}, InputError);
  write("\xc3\xa4\r\n");
  EXPECT_EQ(RuleFile(path_).read().text, "\xc3\xa4\r\n");
}

}  // namespace
}  // namespace af2::playground
