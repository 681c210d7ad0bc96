// Every row of the table of keywords is true: its form can be read, and is what the printer writes.
#include "dsl/text/keywords.h"

#include <gtest/gtest.h>

#include <string>

#include "dsl/format/printer.h"

namespace af2::dsl {
namespace {

void replaceAll(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

/// A form with something short where it shows dots.
std::string whole(std::string_view form) {
  std::string text(form);
  replaceAll(text, "expect ...;", "expect a.x < 1;");
  replaceAll(text, "{ ... }", "{ }");
  return text;
}

/// A file in which a clause stands in its block.
std::string fileWith(BlockKind block, const std::string& clause) {
  const std::string head = "af2 1;\n";
  switch (block) {
    case BlockKind::File:
      return head + clause + "\n";
    case BlockKind::Rule:
      return head + "rule \"r\" quality 1 { " + clause + " }\n";
    case BlockKind::RuleSet:
      return head + "ruleset \"s\" { " + clause + " }\n";
    case BlockKind::Test:
      return head + "test \"t\" { " + clause + " }\n";
    case BlockKind::Property:
      return head + "property \"p\" forall match of \"r\" { " + clause + " }\n";
    case BlockKind::Mirror:
      return head + "rule \"r\" quality 1 { mirror \"m\" { " + clause + " } }\n";
    case BlockKind::Meta:
      break;
  }
  return head;
}

std::string withoutBlanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

TEST(Keywords, EveryFormCanBeReadAndIsWhatThePrinterWrites) {
  for (const Keyword& keyword : keywords())
    for (const std::string_view form : {keyword.form, keyword.otherForm}) {
      if (form.empty()) continue;
      const std::string text = fileWith(keyword.block, whole(form));
      const Formatted formatted = format("form.af2", text);
      ASSERT_TRUE(formatted.diagnostics.empty()) << text << formatted.diagnostics[0].message;
      EXPECT_EQ(withoutBlanks(formatted.text), withoutBlanks(text));
      EXPECT_TRUE(form.starts_with(keyword.word)) << form;
    }
}

TEST(Keywords, AWordHasOneRowInABlock) {
  for (const Keyword& keyword : keywords())
    EXPECT_EQ(findKeyword(keyword.block, keyword.word), &keyword) << keyword.word;
}

TEST(Keywords, AWordIsReservedInAllBlocksOrInNone) {
  for (const Keyword& keyword : keywords())
    EXPECT_EQ(keyword.isReserved, isReserved(keyword.word)) << keyword.word;
}

}  // namespace
}  // namespace af2::dsl
