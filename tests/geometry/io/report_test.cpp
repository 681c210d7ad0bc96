#include "geometry/report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "geometry/io/output_file.h"
#include "small_meshes.h"

namespace af2::geometry {
namespace {

nlohmann::json written(const RunReport& report, const ModelMesh& mesh) {
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto path = std::filesystem::path(::testing::TempDir()) / ("af2_report_" + test + ".json");
  OutputFile file(path);
  writeReport(report, mesh, file);
  file.commit();
  std::ifstream stream(path);
  nlohmann::json json = nlohmann::json::parse(stream);
  std::filesystem::remove(path);
  return json;
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
  EXPECT_EQ(json["faces"][5]["name"], "lid");
}

TEST(Report, HasTheSecondsOfEachStageAndTheQuality) {
  ModelMesh mesh = cubeMesh();
  mesh.seconds.surface = 1.5;
  RunReport report = complete();
  report.quality.p1 = 0.75;
  report.quality.edges.p95 = 1.25;
  const nlohmann::json json = written(report, mesh);
  EXPECT_EQ(json["seconds"]["surface"], 1.5);
  for (const char* stage : {"read", "edges", "optimize", "write"})
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
