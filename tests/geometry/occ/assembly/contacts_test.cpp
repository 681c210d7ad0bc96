// Which parts touch, overlap or coincide.
#include "geometry/occ/assembly/contacts.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <numbers>

#include "tests/geometry/occ/assembly/assemblies.h"
#include "tests/geometry/occ/curves.h"

namespace af2::geometry {
namespace {

using testing::assemblyOf;
using testing::boxBetween;

/// The only pair of a model.
PartContact only(const Model& model) {
  const PartContacts contacts = findContacts(model);
  EXPECT_EQ(contacts.pairs.size(), 1u);
  return contacts.pairs.empty() ? PartContact{} : contacts.pairs.front();
}

TEST(Contacts, TellTheAreaInCommonAndItsPlace) {
  const PartContact contact = only(testing::touchingBoxes());
  EXPECT_EQ(contact.kind, ContactKind::Touch);
  EXPECT_EQ(contact.one, "left");
  EXPECT_EQ(contact.other, "right");
  EXPECT_NEAR(contact.area, 6, 1e-9);
  EXPECT_EQ(contact.volume, 0);
  EXPECT_EQ(contact.length, 0);
  EXPECT_NEAR(distance(contact.place, {4, 3, 2.5}), 0, 1e-9);
  EXPECT_TRUE(contact.twins.empty());
}

TEST(Contacts, TellThatACylinderStandsOnAPlate) {
  const PartContact contact = only(testing::boltOnPlate());
  EXPECT_EQ(contact.kind, ContactKind::Touch);
  EXPECT_NEAR(contact.area, std::numbers::pi, 1e-6);
}

TEST(Contacts, TellOfSheets) {
  const PartContact contact = only(testing::sheetOnBox());
  EXPECT_EQ(contact.other, "label");
  EXPECT_NEAR(contact.area, 4, 1e-9);
}

TEST(Contacts, TellOfCommonEdgesAndVertices) {
  const PartContacts three = findContacts(testing::threeBoxes());
  ASSERT_EQ(three.pairs.size(), 3u);
  EXPECT_NEAR(three.pairs[0].area, 6, 1e-9);
  EXPECT_EQ(three.pairs[1].area, 0);
  EXPECT_NEAR(three.pairs[1].length, 3, 1e-9) << "along the edge between a and c";
  const PartContact corner = only(assemblyOf(
      {{"a", boxBetween({0, 0, 0}, {1, 1, 1})}, {"b", boxBetween({1, 1, 1}, {2, 2, 2})}}));
  EXPECT_TRUE(corner.isAtPoint);
  EXPECT_NEAR(distance(corner.place, {1, 1, 1}), 0, 1e-9);
}

TEST(Contacts, TellTheVolumeOfAnOverlap) {
  const PartContact contact = only(testing::overlappingBoxes());
  EXPECT_EQ(contact.kind, ContactKind::Overlap);
  EXPECT_NEAR(contact.volume, 6, 1e-9);
}

TEST(Contacts, FindAPartInsideAnother) {
  const PartContact contact = only(assemblyOf(
      {{"core", boxBetween({1, 1, 1}, {2, 2, 2})}, {"block", boxBetween({0, 0, 0}, {4, 4, 4})}}));
  EXPECT_EQ(contact.kind, ContactKind::Overlap);
  EXPECT_NEAR(contact.volume, 1, 1e-9);
}

TEST(Contacts, TellOfPartsAndFacesThatAreThereTwice) {
  const TopoDS_Shape box = boxBetween({0, 0, 0}, {1, 2, 3});
  const PartContact same = only(assemblyOf({{"a", box}, {"b", BRepBuilderAPI_Copy(box).Shape()}}));
  EXPECT_EQ(same.kind, ContactKind::Coincide);
  EXPECT_NEAR(same.volume, 6, 1e-9);
  EXPECT_EQ(same.twins.size(), 6u);
  const PartContact wall = only(assemblyOf(
      {{"a", boxBetween({0, 0, 0}, {1, 1, 1})}, {"b", boxBetween({1, 0, 0}, {2, 1, 1})}}));
  ASSERT_EQ(wall.twins.size(), 1u);
  EXPECT_EQ(wall.twins.front(), std::pair(2, 7));
}

TEST(Contacts, AreNoneWhereFacesAreSharedOrPartsApart) {
  EXPECT_EQ(findContacts(testing::box(1, 1, 1)), (PartContacts{1, {}, 0}));
  const PartContacts apart = findContacts(assemblyOf(
      {{"a", boxBetween({0, 0, 0}, {1, 1, 1})}, {"b", boxBetween({1.001, 0, 0}, {2, 1, 1})}}));
  EXPECT_EQ(apart, (PartContacts{2, {}, 0}));
}

TEST(Contacts, UseTheToleranceThatIsAskedFor) {
  const Model apart = assemblyOf(
      {{"a", boxBetween({0, 0, 0}, {1, 1, 1})}, {"b", boxBetween({1.001, 0, 0}, {2, 1, 1})}});
  ContactOptions options;
  options.tolerance = 0.002;
  ASSERT_EQ(findContacts(apart, options).pairs.size(), 1u);
  EXPECT_NEAR(findContacts(apart, options).pairs.front().area, 1, 0.01);
}

TEST(Contacts, StopAtTheNumberOfFacesThatIsAskedFor) {
  ContactOptions options;
  options.maxFaces = 24;
  const PartContacts contacts = findContacts(testing::threeBoxes(), options);
  EXPECT_EQ(contacts.pairs.size(), 2u);
  EXPECT_EQ(contacts.notCompared, 1u);
}

/// The pair of plane faces is compared, though that of few free-form faces comes first.
TEST(Contacts, CountCurvedFacesForSeveral) {
  const auto wall = [](double x) {
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(testing::splineThrough(
                                     {{x, 0, 0}, {x + 0.2, 1, 0}, {x, 2, 0}})),
                                 gp_Vec(0, 0, 1))
        .Shape();
  };
  const Model model = assemblyOf({{"first", wall(5)},
                                  {"second", wall(5)},
                                  {"a", boxBetween({0, 0, 0}, {1, 1, 1})},
                                  {"b", boxBetween({1, 0, 0}, {2, 1, 1})}});
  ContactOptions options;
  options.maxFaces = 50;
  const PartContacts contacts = findContacts(model, options);
  ASSERT_EQ(contacts.pairs.size(), 1u);
  EXPECT_EQ(contacts.pairs.front().one, "a");
  EXPECT_EQ(contacts.notCompared, 1u);
  EXPECT_EQ(findContacts(model).pairs.size(), 2u);
}

TEST(Contacts, NumberPartsOfTheSameName) {
  const PartContact contact =
      only(assemblyOf({{"bolt", testing::compoundOf({boxBetween({0, 0, 0}, {1, 1, 1}),
                                                     boxBetween({1, 0, 0}, {2, 1, 1})})}}));
  EXPECT_EQ(contact.one, "bolt.1");
  EXPECT_EQ(contact.other, "bolt.2");
}

}  // namespace
}  // namespace af2::geometry
