#include "geometry/occ/step/step_records.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace af2::geometry {
namespace {

const std::string kBefore = "ISO-10303-21;\nHEADER;\nFILE_NAME('a',('b'));\nENDSEC;\nDATA;\n";
const std::string kAfter = "\nENDSEC;\nEND-ISO-10303-21;\n";

using Lines = std::vector<std::string>;

/// Label, type and values of the records after those of the head.
Lines recordsOf(const std::string& data) {
  std::string text = kBefore + data + kAfter;
  StepRecords records(text);
  if (!records.arePlain()) return {"none"};
  Lines lines;
  std::size_t values = 0;
  records.forEach([&](const StepRecord& record) {
    std::string& line = lines.emplace_back(record.label.data());  // up to the zero
    line.append(" ").append(record.type.data());
    for (const StepValue& value : record.values) line.append(" ").append(value.word.data());
    values += record.values.size();
  });
  EXPECT_EQ(lines.size(), records.count());
  EXPECT_EQ(values, records.valueCount());
  lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(records.headCount()));
  return lines;
}

bool isPlain(std::string text) {
  const std::string before = text;
  const bool isRead = StepRecords(text).arePlain();
  EXPECT_EQ(text, before);
  return isRead;
}

TEST(StepRecords, AreThoseOfTheHeadFirst) {
  std::string text = kBefore + "#1=A();" + kAfter;
  StepRecords records(text);
  EXPECT_EQ(records.headCount(), 2u);
  std::vector<std::string_view> labels;
  records.forEach([&](const StepRecord& record) { labels.push_back(record.label); });
  EXPECT_EQ(labels, (std::vector<std::string_view>{"$1", "#0", "#1"}));
}

TEST(StepRecords, HaveListsBeforeWhatTheyAreIn) {
  EXPECT_EQ(recordsOf("#12 = A('x', (#1, (2., -3), ()), B(4.E-1), $, *, .T.);"),
            (Lines{"$2 /* (SUB) */ 2. -3", "$3 /* (SUB) */", "$1 /* (SUB) */ #1 $2 $3",
                   "$4 B 4.E-1", "#12 A 'x' $1 $4 $ * .T."}));
}

TEST(StepRecords, HavePartsOfComplexEntities) {
  EXPECT_EQ(recordsOf("#1=(A(#2)B((1))C());#2=D(.5);"),
            (Lines{"#1 A #2", "$1 /* (SUB) */ 1", "#0 B $1", "#0 C", "#2 D .5"}));
}

TEST(StepRecords, TellWhatValuesAre) {
  std::string text = kBefore + "#1=A(#2,1,+1.,.A_1.,'',$,*,(1));" + kAfter;
  std::vector<StepKind> kinds;
  StepRecords(text).forEach([&](const StepRecord& record) {
    kinds.clear();
    for (const StepValue& value : record.values) kinds.push_back(value.kind);
  });
  EXPECT_EQ(kinds,
            (std::vector{StepKind::Label, StepKind::Integer, StepKind::Real, StepKind::Enumeration,
                         StepKind::Text, StepKind::Omitted, StepKind::Derived, StepKind::List}));
}

TEST(StepRecords, SkipBlanksAndComments) {
  EXPECT_EQ(recordsOf("/* #3=C(); **/#1\t= A /*'*/(\r\n 1 /***/, 'a/*b' );#2=B();"),
            (Lines{"#1 A 1 'a/*b'", "#2 B"}));
  EXPECT_EQ(recordsOf("#1\n=\nA(\n);"), (Lines{"#1 A"}));
}

TEST(StepRecords, HaveTextsUpToAQuoteBeforeACommaOrABracket) {
  EXPECT_EQ(recordsOf("#1=A('it''s', 'it's', 'a\nb' ,'(');"),
            (Lines{"#1 A 'it''s' 'it's' 'a\nb' '('"}));
}

TEST(StepRecords, MayHaveListsInListsToAnyDepth) {
  constexpr std::size_t kDepth = 200'000;
  const Lines found =
      recordsOf("#1=A(" + std::string(kDepth, '(') + std::string(kDepth, ')') + ");");
  ASSERT_EQ(found.size(), kDepth + 1);
  EXPECT_EQ(found.back(), "#1 A $1");
}

TEST(StepRecords, AreNotMadeOfWhatIsNotPlain) {
  for (const std::string data : {"",
                                 "#1=A()",
                                 "#1=A(1,);",
                                 "#1=A(,1);",
                                 "#1=A(1 2);",
                                 "#1=A(1;",
                                 "#1=A);",
                                 "#=A();",
                                 "1=A();",
                                 "#1=();",
                                 "#1=(A()",
                                 "#1=A(\"0F\");",
                                 "#1=A(1E5);",
                                 "#1=A(1.E);",
                                 "#1=A(1e-7);",
                                 "#1=A(.T);",
                                 "#1=A(.);",
                                 "#1=A(-);",
                                 "#1=A(#);",
                                 "#1=A(#2=B());",
                                 "#1=A(B);",
                                 "#1=A(B'');",
                                 "#1=A(B#2);",
                                 "#1=A(B 3);",
                                 "#1=A(B.T.);",
                                 "#1=A('x);",
                                 "#1=A();;",
                                 "#1=&SCOPE #2=B(); ENDSCOPE A();",
                                 "#1=ENDSCOPE();",
                                 "#1=(A()EndScope());",
                                 "#1=!A();",
                                 "#1=A(1.5.2);",
                                 "#1=A(1.#IND);",
                                 "/* #1=A();"})
    EXPECT_FALSE(isPlain(kBefore + data + kAfter)) << data;
  EXPECT_FALSE(isPlain(kBefore + "#1=A('" + std::string(1, '\0') + "');" + kAfter));
  EXPECT_FALSE(isPlain(kBefore + "#1=A();"));
  EXPECT_FALSE(isPlain("\xef\xbb\xbf" + kBefore + "#1=A();" + kAfter));
  EXPECT_FALSE(isPlain("ISO-10303-21;HEADER;ENDSEC;DATA;#1=A();" + kAfter));
  EXPECT_FALSE(isPlain(""));
}

}  // namespace
}  // namespace af2::geometry
