// What verbs say about parts that touch.
#include "cli/meshing/contact_texts.h"

#include <gtest/gtest.h>

namespace af2::cli {
namespace {

using geometry::ContactKind;
using geometry::PartContact;
using geometry::PartContacts;

PartContacts someContacts() {
  PartContact touch, overlap, unknown;
  touch.one = "plate";
  touch.other = "bolt";
  touch.area = 6;
  touch.place = {1, 2, 3};
  touch.twins = {{2, 7}};
  overlap.kind = ContactKind::Overlap;
  overlap.one = "a";
  overlap.other = "b";
  overlap.volume = 12.5;
  unknown.kind = ContactKind::Unknown;
  unknown.one = "c";
  unknown.other = "d";
  return {6, {touch, overlap, unknown}, 4};
}

TEST(ContactTexts, WarnOfEachKindWithAnExample) {
  EXPECT_EQ(contactWarning(someContacts()),
            "note: 1 pair of parts touches, e.g. 'plate' and 'bolt' at (1, 2, 3); 1 pair of parts "
            "overlaps, e.g. 'a' and 'b' at (0, 0, 0): their meshes do not match there without "
            "--imprint; 1 pair of "
            "parts could not be compared; 4 more pairs of parts are close to each other and were "
            "not compared (af2 inspect lists all)\n");
}

TEST(ContactTexts, SayNothingOfPartsThatAreApart) {
  EXPECT_EQ(contactWarning({}), "");
  EXPECT_EQ(contactWarning({2, {}, 0}), "");
  EXPECT_EQ(contactTable({1, {}, 0}, false), "");
}

TEST(ContactTexts, TellOfPairsThatWereNotComparedAlone) {
  EXPECT_EQ(contactWarning({2, {}, 1}),
            "note: 1 pair of parts is close to each other and was not compared (af2 inspect lists "
            "all)\n");
  EXPECT_EQ(contactWarning({3, {}, 2}),
            "note: 2 pairs of parts are close to each other and were not compared (af2 inspect "
            "lists all)\n");
}

TEST(ContactTexts, ListHowMuchTheyHaveInCommon) {
  EXPECT_EQ(
      contactTable(someContacts(), false),
      "6 parts; 3 pairs touch or overlap without sharing faces, edges or vertices there\n"
      "touch       area 6                    'plate' and 'bolt' at (1, 2, 3); equal faces 2 = "
      "7\n"
      "overlap     volume 12.5               'a' and 'b' at (0, 0, 0)\n"
      "unknown     could not be compared     'c' and 'd'\n"
      "4 more pairs of parts are close to each other and were not compared\n");
}

TEST(ContactTexts, ListTenOfAKindUnlessAllAreAskedFor) {
  const PartContacts many{13, std::vector<PartContact>(12, someContacts().pairs[0]), 0};
  EXPECT_NE(contactTable(many, false).find("and 2 more of the kind 'touch'"), std::string::npos);
  EXPECT_EQ(contactTable(many, true).find("more of the kind"), std::string::npos);
}

}  // namespace
}  // namespace af2::cli
