#include "geometry/io/output_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public ::testing::Test {
 protected:
  fs::path path(const std::string& name) const { return directory_ / name; }
  static std::string refusal(const fs::path& file) {
    try {
      checkWritable(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  testing::TestFolder directory_;
};

TEST_F(OutputFileTest, HoldsWhatWasWrittenOnceCommitted) {
  OutputFile file(path("a.txt"));
  file.text("x ");
  file.number(0.1);
  file.text(" ");
  file.number(-7);
  file.commit();
  EXPECT_EQ(contentOf(path("a.txt")), "x 0.1 -7");
  EXPECT_EQ(directory_.fileCount(), 1u);
}

TEST_F(OutputFileTest, LeavesTheOldContentAndNoTraceWithoutCommit) {
  std::ofstream(path("a.txt")) << "old";
  { OutputFile(path("a.txt")).text("new"); }
  EXPECT_EQ(contentOf(path("a.txt")), "old");
  EXPECT_EQ(directory_.fileCount(), 1u);
}

TEST_F(OutputFileTest, KeepsEveryByteOfMoreThanItsBufferHolds) {
  std::string expected;
  OutputFile file(path("big.txt"));
  for (int i = 0; i < 100000; ++i) {
    file.number(i);
    file.text("\n");
    expected += std::to_string(i) + "\n";
  }
  const std::string large(1 << 20, 'x');
  file.text(large);
  file.commit();
  EXPECT_EQ(contentOf(path("big.txt")), expected + large);
}

TEST_F(OutputFileTest, WritesNumbersInBothByteOrders) {
  OutputFile file(path("a.bin"));
  file.binary(std::uint32_t{0x01020304});
  file.bigEndian(std::uint32_t{0x01020304});
  file.commit();
  EXPECT_EQ(contentOf(path("a.bin")), std::string("\4\3\2\1\1\2\3\4"));
}

TEST_F(OutputFileTest, FollowsASymbolicLink) {
  std::ofstream(path("real.txt")) << "old";
  fs::create_symlink("real.txt", path("link.txt"));
  OutputFile file(path("link.txt"));
  file.text("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(path("link.txt")));
  EXPECT_EQ(contentOf(path("real.txt")), "new");
}

TEST_F(OutputFileTest, SaysThatTheDirectoryDoesNotExist) {
  EXPECT_EQ(refusal(path("nowhere/a.vtu")), "cannot write '" + path("nowhere/a.vtu").string() +
                                                "': the directory '" + path("nowhere").string() +
                                                "' does not exist; make it with 'mkdir -p'");
}

TEST_F(OutputFileTest, RefusesADirectoryAndADevice) {
  EXPECT_NE(refusal(directory_.path()).find("it is a directory"), std::string::npos);
  EXPECT_NE(refusal("/dev/null").find("not a regular file"), std::string::npos);
}

TEST_F(OutputFileTest, ProbingLeavesNoFile) {
  checkWritable(path("a.vtu"));
  EXPECT_EQ(directory_.fileCount(), 0u);
}

}  // namespace
}  // namespace af2::geometry
