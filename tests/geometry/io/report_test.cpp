#include "geometry/io/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geometry/base/words.h"
#include "geometry/fill/stuck_front.h"
#include "geometry/io/output_file.h"
#include "tests/support/small_meshes.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

nlohmann::json written(const RunReport& report, const ModelMesh& mesh) {
  const testing::TestFile made("report.json");
  OutputFile file(made.path());
  writeReport(report, mesh, file);
  file.commit();
  return nlohmann::json::parse(contentOf(made.path()));
}

RunReport complete() {
  RunReport report;
  report.status = RunStatus::Complete;
  return report;
}

TEST(Report, CountsVerticesTrianglesAndQuads) {
  const nlohmann::json json = written(complete(), cubeMesh());
  EXPECT_EQ(json["status"], "complete");
  EXPECT_EQ(json["vertices"], 8);
  EXPECT_EQ(json["triangles"], 10);
  EXPECT_EQ(json["quads"], 1);
  EXPECT_EQ(json["fingerprint"].get<std::string>().size(), 16u);
  EXPECT_FALSE(json.contains("reason"));
}

TEST(Report, TellsTheUnitOfLengthsAndThatOfTheFile) {
  ModelMesh mesh = cubeMesh();
  EXPECT_FALSE(written(complete(), mesh).contains("unit"));
  mesh.unit = "mm";
  mesh.fileUnit = "INCH";
  EXPECT_EQ(written(complete(), mesh)["unit"], "mm");
  EXPECT_EQ(written(complete(), mesh)["file_unit"], "INCH");
}

TEST(Report, TellsOfEachFace) {
  ModelMesh mesh = cubeMesh();
  mesh.faces[1].status = FaceStatus::Failed;
  mesh.faces[1].reason = "stuck";
  const nlohmann::json json = written(complete(), mesh);
  ASSERT_EQ(json["faces"].size(), 6u);
  EXPECT_EQ(json["faces"][1]["id"], 2);
  EXPECT_EQ(json["faces"][1]["surface_type"], "plane");
  EXPECT_EQ(json["faces"][1]["status"], "failed");
  EXPECT_EQ(json["faces"][1]["reason"], "stuck");
  EXPECT_FALSE(json["faces"][1].contains("cause"));
  mesh.faces[1].cause = FailureCause::Model;
  EXPECT_EQ(written(complete(), mesh)["faces"][1]["cause"], "model");
  EXPECT_EQ(json["faces"][5]["name"], "lid");
}

TEST(Report, CountsActsOfTheFront) {
  ModelMesh mesh = cubeMesh();
  mesh.faces[1].acts.welds = 3;
  mesh.faces[1].acts.columns = 2;
  const nlohmann::json faces = written(complete(), mesh)["faces"];
  EXPECT_FALSE(faces[0].contains("acts"));
  EXPECT_EQ(
      faces[1]["acts"],
      nlohmann::json::parse(R"({"welds": 3, "rows": 0, "moves": 0, "columns": 2, "paths": 0})"));
}

TEST(Report, TellsWhereAFrontGotStuckAndWhyEachRuleWasRefused) {
  ModelMesh mesh = cubeMesh();
  MeshingResult result;
  result.outcome = Outcome::Stuck;
  result.mesh.vertices = {{{0, 0, 0}, {0, 0, 1}, 0.25, 0.5}, {{1, 0, 0}, {0, 0, 1}, 0.75, 0.5}};
  result.stuck.assign(
      30, {VertexId(std::size_t{0}), VertexId(std::size_t{1}), 7, {{1, Refusal::Surface, {}, {}}}});
  mesh.faces[1].stuck = stuckPlaces(result);
  const nlohmann::json faces = written(complete(), mesh)["faces"];
  EXPECT_FALSE(faces[0].contains("stuck"));
  ASSERT_EQ(faces[1]["stuck"].size(), 10u) << "the first ones say enough";
  const nlohmann::json& edge = faces[1]["stuck"][0];
  EXPECT_EQ(edge["to"], nlohmann::json({1.0, 0.0, 0.0}));
  EXPECT_EQ(edge["uv"], nlohmann::json({0.25, 0.5}));
  EXPECT_EQ(edge["level"], 7);
  EXPECT_EQ(edge["refused"], nlohmann::json({{mesh.ruleNames[1], "surface"}}));
}

TEST(Report, HasTheSecondsOfEachStageAndTheQuality) {
  ModelMesh mesh = cubeMesh();
  mesh.seconds.surface = 1.5;
  RunReport report = complete();
  report.quality.p1 = 0.75;
  report.quality.edges.p95 = 1.25;
  const nlohmann::json json = written(report, mesh);
  EXPECT_EQ(json["seconds"]["surface"], 1.5);
  for (const char* stage : {"read", "contacts", "edges", "optimize", "write"})
    EXPECT_EQ(json["seconds"][stage], 0);
  EXPECT_EQ(json["quality"]["p1"], 0.75);
  EXPECT_EQ(json["quality"]["edge_ratio"]["p95"], 1.25);
}

TEST(Report, SurvivesNamesThatAreNoUtf8) {
  ModelMesh mesh = cubeMesh();
  mesh.faces[0].name = "caf\xe9";
  EXPECT_EQ(written(complete(), mesh)["faces"][0]["name"], "caf\xef\xbf\xbd");
}

TEST(StatusOf, FollowsFromTheFaces) {
  ModelMesh mesh = cubeMesh();
  EXPECT_EQ(statusOf(mesh), RunStatus::Complete);
  mesh.faces[0].status = FaceStatus::Skipped;
  EXPECT_EQ(statusOf(mesh), RunStatus::Complete);
  mesh.faces[1].status = FaceStatus::Failed;
  EXPECT_EQ(statusOf(mesh), RunStatus::Partial);
  mesh.faces[2].status = FaceStatus::Cancelled;
  EXPECT_EQ(statusOf(mesh), RunStatus::Cancelled);
  EXPECT_EQ(statusOf({}), RunStatus::Failed);
}

}  // namespace
}  // namespace af2::geometry
