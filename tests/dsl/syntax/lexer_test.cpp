#include "dsl/syntax/lexer.h"

#include <gtest/gtest.h>

namespace af2::dsl {
namespace {

struct Read {
  TokenList words;
  std::vector<Diagnostic> diagnostics;
};

Read read(const std::string& text) {
  DiagnosticList list;
  const SourceText source("x.af2", text);
  TokenList words = readTokens(source, list);
  return {std::move(words), list.take()};
}

std::string spelt(const std::string& text) {
  std::string result;
  for (const Token& token : read(text).words.tokens)
    result += (token.kind == TokenKind::String ? "\"" + token.text + "\"" : token.text) + " ";
  return result;
}

std::string onlyMessage(const std::string& text) {
  const auto found = read(text).diagnostics;
  return found.size() == 1 ? found[0].message : std::to_string(found.size()) + " findings";
}

TEST(Lexer, TellsOnceThatAFileIsNoText) {
  std::string utf16 = "\xFF\xFE";
  for (const char c : std::string("af2 1;\nruleset \"x\" {}\n")) utf16 += std::string{c, '\0'};
  EXPECT_EQ(onlyMessage(utf16), "this file is written in UTF-16");
  EXPECT_EQ(onlyMessage(utf16.substr(2)), "this file is written in UTF-16");
  std::string binary;
  for (unsigned i = 0; i < 2000; ++i) binary += static_cast<char>(i * 7919 + i * i * 31);
  EXPECT_EQ(onlyMessage(binary), "this is not a text file");
  EXPECT_EQ(onlyMessage("af2 1;\r# all of it\r"),
            "the lines of this file end in a carriage return alone");
  EXPECT_FALSE(read(binary).words.isText);
}

TEST(Lexer, ReadsOnInAFileOfAnotherEncoding) {
  const Read words = read(
      "# gr\xF6\xDF"
      "er\nconst H\xF6 = 1;\n");
  ASSERT_EQ(words.diagnostics.size(), 1u);
  EXPECT_EQ(words.diagnostics[0].message, "this file is not UTF-8");
  EXPECT_EQ(words.diagnostics[0].place.line, 1);
  EXPECT_EQ(words.words.tokens.size(), 6u);
}

TEST(Lexer, TakesNoCharacterThatUnicodeForbids) {
  const std::string tooLong3 = "\xE0\x80\xAF", tooLong4 = "\xF0\x8F\xBF\xBF";
  const std::string halfPair = "\xED\xA0\x80", beyond = "\xF4\x90\x80\x80";
  for (const std::string& bytes : {tooLong3, tooLong4, halfPair, beyond})
    EXPECT_EQ(onlyMessage("# a" + bytes + "\nconst h = 1;"), "this file is not UTF-8");
  for (const std::string bytes : {"\u0800", "\uD7FF", "\uE000", "\U00010000", "\U0010FFFF"})
    EXPECT_TRUE(read("# a" + bytes + "\nconst h = 1;").diagnostics.empty());
}

TEST(Lexer, TakesLookAlikesForWhatTheyMean) {
  EXPECT_EQ(spelt("a\u2212b \u2265 60\u00B0 \u2192 c\u00A0;"), "a - b >= 60 deg -> c ;  ");
  EXPECT_EQ(spelt("\u201Ca title\u201D {"), "\"a title\" {  ");
  EXPECT_EQ(spelt("'a title' ["), "\"a title\" (  ");
  EXPECT_EQ(spelt("1...30"), "1 .. 30  ");
}

TEST(Lexer, TellsEachLookAlikeOnceOnItsLine) {
  EXPECT_EQ(read("a \u2192 b \u2192 c\nd \u2192 e\n").diagnostics.size(), 2u);
  EXPECT_EQ(read("h\u00F6he = h\u00F6he\nh\u00F6he").diagnostics.size(), 1u);
  EXPECT_EQ(read("[1, [2, 3]]").diagnostics.size(), 2u);
}

TEST(Lexer, KnowsTheCommentsOfOtherLanguages) {
  EXPECT_EQ(spelt("a // b\nc /* d\n e */ f\n-- g\nh - -1"), "a c f h - - 1  ");
  EXPECT_EQ(read("a // b\nc /* d\n e */ f\n-- g").diagnostics.size(), 3u);
  EXPECT_EQ(spelt("a /* never closed\nb"), "a b  ");
}

TEST(Lexer, TellsAConflictOfVersionsOnce) {
  EXPECT_EQ(spelt("<<<<<<< a\nx\n=======\ny\n>>>>>>> b\n"), "x y  ");
  EXPECT_EQ(read("<<<<<<< a\nx\n=======\ny\n>>>>>>> b\n").diagnostics.size(), 1u);
}

TEST(Lexer, GivesBackWhatAStringWithoutEndHasSwallowed) {
  EXPECT_EQ(spelt("rule \"free quality 1 {\n}"), "rule \"free quality 1\" { }  ");
  EXPECT_EQ(spelt("import \"lib;\r\nx"), "import \"lib\" ; x  ");
  EXPECT_EQ(spelt("\"to the end"), "\"to the end\"  ");
  EXPECT_EQ(spelt("\""), "\"\"  ");
}

}  // namespace
}  // namespace af2::dsl
