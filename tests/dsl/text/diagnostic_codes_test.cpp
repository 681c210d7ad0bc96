// The table of codes, and the pages that follow from it. Where a page differs, the test prints what
// belongs there.
#include "dsl/text/diagnostic_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "dsl/checks/checks.h"

namespace af2::dsl {
namespace {

std::string page(const std::string& name) {
  std::ifstream file(AF2_SOURCE_DIR "/docs/" + name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What hosts call a heading in addresses: small letters, '-' for blanks, no other signs.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ' || c == '-')
      anchor += '-';
    else if (std::isalnum(byte) != 0)
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

std::set<std::string> anchorsOf(const std::string& text) {
  std::set<std::string> anchors;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blank = line.find_first_not_of('#');
    if (blank != 0 && blank != line.npos && line[blank] == ' ')
      anchors.insert(anchorOf(line.substr(blank + 1)));
  }
  return anchors;
}

std::string evidenceOf(const CodeInfo& info) {
  return info.evidence == Evidence::Text             ? "the text"
         : info.evidence == Evidence::Samples        ? "samples"
         : info.evidence == Evidence::TextAndSamples ? "the text; samples"
         : info.evidence == Evidence::TextAndProof   ? "the text; samples, then a proof"
                                                     : "samples, then a proof";
}

std::string rowOf(const CodeInfo& info) {
  const std::string address(info.page);
  const bool isError = info.severity == Severity::Error;
  return "| " + std::string(info.id) + " | " + std::string(info.title) + " | " +
         (isError ? "error" : "warning") + " | " +
         (info.allowance == Allowance::AsError || !isError ? "yes" : "") + " | " +
         evidenceOf(info) + " | [" + address.substr(address.find('#') + 1) + "](" + address +
         ") |\n";
}

std::string tableOfCodes() {
  std::string table =
      "| code | meaning | reported as | can be allowed | found by | see "
      "|\n|---|---|---|---|---|---|\n";
  for (const CodeInfo& info : diagnosticCodes()) table += rowOf(info);
  return table;
}

std::string tableOfChecks() {
  std::string table = "| codes | question |\n|---|---|\n";
  for (const Check& check : checks()) {
    table += "|";
    for (const auto& code : check.codes)
      if (code) table += " " + idOf(*code);
    table += " | " + std::string(check.question) + " |\n";
  }
  return table;
}

TEST(DiagnosticCodes, AreSortedAndFoundInEitherForm) {
  const auto all = diagnosticCodes();
  const auto key = [](const CodeInfo& info) {
    return std::pair(info.id[0], std::stoi(std::string(info.id.substr(1))));
  };
  EXPECT_TRUE(std::ranges::is_sorted(all, {}, key));
  for (const CodeInfo& info : all) EXPECT_EQ(&infoOf(info.code), &info) << info.id;
  EXPECT_EQ(findCode("af2-a1"), Code::PointWeights);
  EXPECT_EQ(findCode("A1"), Code::PointWeights);
  EXPECT_EQ(findCode("X9"), std::nullopt);
  EXPECT_EQ(fullIdOf(Code::UnknownName), "AF2-R1");
}

TEST(DiagnosticCodes, AreExplained) {
  for (const CodeInfo& info : diagnosticCodes()) {
    EXPECT_FALSE(info.title.empty() || info.title.ends_with('.')) << info.id;
    EXPECT_EQ(info.title.find('\n'), std::string_view::npos) << info.id;
    EXPECT_FALSE(info.explanation.empty() || info.explanation.ends_with('\n')) << info.id;
  }
}

TEST(DiagnosticCodes, LeadToASectionOfTheDocumentation) {
  for (const CodeInfo& info : diagnosticCodes()) {
    const std::string address(info.page);
    const std::size_t hash = address.find('#');
    ASSERT_NE(hash, address.npos) << info.id;
    EXPECT_TRUE(anchorsOf(page(address.substr(0, hash))).contains(address.substr(hash + 1)))
        << info.id << ": no " << address;
  }
}

TEST(DiagnosticCodes, AreListedInTheDocumentation) {
  const std::string text = page("rule-checks.md");
  EXPECT_NE(text.find(tableOfCodes()), text.npos) << tableOfCodes();
  EXPECT_NE(text.find(tableOfChecks()), text.npos) << tableOfChecks();
}

}  // namespace
}  // namespace af2::dsl
