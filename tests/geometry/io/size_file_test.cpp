#include "geometry/io/size_file.h"

#include "geometry/meshing/part_sizes.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

SizeFile read(const std::string& text) {
  return readSizeFile(testing::TestFile("sizes.json", text).path());
}

std::string faultOf(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(SizeFile, HoldsPointsBoxesFieldsAndParts) {
  const SizeFile file = read(R"({
    "points": [{"at": [1, 2, 3], "size": 0.5}, {"at": [1, 2], "size": 1, "radius": 4}],
    "boxes": [{"from": [0, 0, 0], "to": [1, 1, 1], "size": 0.25}],
    "fields": [{"origin": [0, 0, 0], "spacing": [1, 1, 1], "counts": [2, 1, 1], "sizes": [1, 2]}],
    "parts": {"b*": 0.1, "a": 0.2}})");
  ASSERT_EQ(file.sources.points.size(), 2u);
  EXPECT_EQ(file.sources.points[0].position, (Point3{1, 2, 3}));
  EXPECT_EQ(file.sources.points[1].radius, 4);
  EXPECT_EQ(file.sources.boxes.at(0).size, 0.25);
  EXPECT_EQ(file.sources.grids.at(0).sizes, (std::vector<double>{1, 2}));
  ASSERT_EQ(file.parts.size(), 2u);
  EXPECT_EQ(file.parts[0].first, "b*") << "in the order of the file";
}

TEST(SizeFile, TellsMistakesWithTheirPlace) {
  EXPECT_NE(faultOf("{\n  \"points\": [,]}").find("line 2"), std::string::npos);
  EXPECT_NE(faultOf(R"({"point": []})").find("'point' is not known here; there are: points"),
            std::string::npos);
  EXPECT_NE(faultOf(R"({"points": [{"at": [0, 0], "size": 1}, {"at": [0, 0], "size": 0}]})")
                .find("points: 2: size: a size is a number greater than 0"),
            std::string::npos);
  EXPECT_NE(faultOf(R"({"boxes": [{"from": [0], "to": [1, 1, 1], "size": 1}]})")
                .find("boxes: 1: from: a point has two or three coordinates"),
            std::string::npos);
  EXPECT_NE(faultOf(R"({"fields": [{"origin": [0, 0, 0], "spacing": [1, 1, 1], "counts": [2, 2, 1],
                        "sizes": [1, 2]}]})")
                .find("fields: 1: sizes: there are 2 for 4 nodes"),
            std::string::npos);
  EXPECT_NE(faultOf("[]").find("should be an object"), std::string::npos);
  EXPECT_THROW(readSizeFile("/nowhere/sizes.json"), InputError);
}

TEST(SizeFile, NamesMayHavePatterns) {
  EXPECT_TRUE(fitsPattern("bolt 12", "bolt*"));
  EXPECT_TRUE(fitsPattern("bolt 1", "bolt ?"));
  EXPECT_FALSE(fitsPattern("bolt 12", "bolt"));
  EXPECT_TRUE(fitsPattern("", "*"));
  EXPECT_TRUE(fitsPattern("ab12ab34", "*ab*4**"));
  EXPECT_FALSE(fitsPattern("ab12ab34", "*ab*5"));
  EXPECT_FALSE(fitsPattern("a", "a?"));
  EXPECT_TRUE(fitsPattern("T\u00e4l", "T?l"));
  for (const char* name : {"bolt [M3]", "C:\\parts\\a", "*", "?"})
    EXPECT_TRUE(fitsPattern(name, name));
  EXPECT_FALSE(fitsPattern("bolt M", "bolt [M3]"));
}

TEST(PartSizes, FindSolidsAndColoursAsMeshFilesCallThem) {
  const std::vector<std::string> names{"inlet", "", ""};
  const std::vector<FaceGroup> groups{{"1", GroupKind::Solid, {1, 2}},
                                      {"2", GroupKind::Solid, {3}},
                                      {"#ff0000", GroupKind::Color, {2}},
                                      {"bolt", GroupKind::Part, {3}}};
  EXPECT_EQ(facesCalled("solid 2", names, groups), std::vector<int>{3});
  EXPECT_EQ(facesCalled("solid *", names, groups), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(facesCalled("color #ff0000", names, groups), std::vector<int>{2});
  EXPECT_EQ(facesCalled("inlet", names, groups), std::vector<int>{1});
  EXPECT_TRUE(facesCalled("s*", names, groups).empty()) << "no name begins with s";
  EXPECT_TRUE(facesCalled("part bolt", names, groups).empty());
  const std::vector<std::string> patterns{"bolt", "nobody"};
  EXPECT_THROW(withFacesCalled({1}, patterns, names, groups), InputError);
  EXPECT_EQ(withFacesCalled({1}, std::span(patterns).first(1), names, groups),
            (std::vector<int>{1, 3}));
}

}  // namespace
}  // namespace af2::geometry
