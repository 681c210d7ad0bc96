#include "geometry/check/sounder_mesh.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

ModelMesh meshOf(const std::vector<FaceStatus>& faces) {
  ModelMesh mesh;
  for (const FaceStatus status : faces) {
    FaceReport& face = mesh.faces.emplace_back();
    face.id = static_cast<int>(mesh.faces.size());
    face.status = status;
    if (status == FaceStatus::Failed) face.reason = "no room";
  }
  mesh.elements.resize(1);
  return mesh;
}

ModelMesh healedOf(const std::vector<FaceStatus>& faces) {
  ModelMesh mesh = meshOf(faces);
  mesh.healing = Healing{0.1, {{"small edge removed", 1, {}}}, {"a step was not done"}};
  return mesh;
}

constexpr FaceStatus kGood = FaceStatus::Complete, kBad = FaceStatus::Failed;

TEST(SounderMesh, IsThatOfTheHealedModelIfItHasNoMoreFaults) {
  for (const FaceStatus asItWas : {kGood, kBad}) {
    const ModelMesh kept = sounderMesh(healedOf({asItWas, kGood}), meshOf({kBad, kGood, asItWas}));
    ASSERT_TRUE(kept.healing);
    EXPECT_EQ(kept.healing->changes.size(), 1u);
    EXPECT_EQ(kept.faces.size(), 2u);
  }
}

TEST(SounderMesh, IsThatOfTheModelAsItWasIfHealingMadeItWorseAndTellsWhy) {
  const ModelMesh kept = sounderMesh(healedOf({kGood, kBad}), meshOf({kGood, kGood, kGood}));
  EXPECT_EQ(kept.faces.size(), 3u);
  ASSERT_TRUE(kept.healing);
  EXPECT_EQ(kept.healing->tolerance, 0.1);
  EXPECT_TRUE(kept.healing->changes.empty());
  ASSERT_EQ(kept.healing->undone.size(), 2u);
  EXPECT_NE(kept.healing->undone[1].find("face 2: no room"), std::string::npos);
}

TEST(SounderMesh, CountsWhatIsOnNoFace) {
  ModelMesh healed = healedOf({kGood}), asItWas = meshOf({kGood});
  EXPECT_FALSE(hasFaults(healed));
  healed.findings.emplace_back("a face of the file could not be read");
  EXPECT_TRUE(hasFaults(healed));
  EXPECT_TRUE(sounderMesh(healed, asItWas).healing->changes.empty());
  asItWas.findings = healed.findings;
  EXPECT_FALSE(sounderMesh(healed, asItWas).healing->changes.empty());
}

TEST(SounderMesh, IsNoneThatIsEmpty) {
  ModelMesh nothing = meshOf({});
  nothing.elements.clear();
  EXPECT_EQ(sounderMesh(healedOf({kBad}), nothing).faces.size(), 1u);
}

}  // namespace
}  // namespace af2::geometry
