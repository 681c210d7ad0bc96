#include "cli/meshing/stuck_tests.h"

#include <fmt/core.h>

#include <set>

#include "cli/program/text_files.h"
#include "dsl/run/explain.h"
#include "dsl/run/piece_text.h"
#include "engine/base/place_text.h"

namespace af2::cli {
namespace {

using geometry::FaceReport;
using geometry::StuckPlace;

class TestFile {
 public:
  TestFile(const MeshRequest& request, const RuleSet& rules)
      : request_(request), rules_(rules), stepper_(rules) {}

  void add(const FaceReport& face, const StuckPlace& place) {
    if (place.around.vertices.empty()) return;
    const SingleStep step = stepper_.take(place.around);
    if (step.rule) {
      ++leftOut_;
      return;
    }
    std::string kind = std::to_string(place.level);
    for (const RuleRefusal& refusal : step.refusals)
      kind += fmt::format(" {}", static_cast<int>(refusal.reason));
    if (!kinds_.insert(kind).second) return;
    const auto names = dsl::vertexNamesOf(place.around);
    const auto explanation = dsl::explainStep(rules_, stepper_, place.around, names, false);
    dsl::PieceTest test;
    test.title = fmt::format("face {}: a rule is applied at {}", face.id, textOf(place.from));
    test.remark = toText(explanation);
    test.expectation = "not stuck";
    tests_ += "\n" + dsl::testTextOf(place.around, test);
  }

  std::string text() const {
    const auto rules = std::filesystem::absolute(request_.rules).lexically_normal();
    std::string text =
        dsl::testFileHead(rules.string(), rules_.name()) +
        fmt::format(
            "# Places where fronts got stuck on {} with size {}. Each test fails until a rule is\n"
            "# applied at its base edge; 'af2 test' says why none is.\n",
            request_.model.string(), request_.options.sizes.size);
    if (leftOut_ > 0)
      text += fmt::format(
          "# {} places were left out: in the plane, with a uniform size, a rule is applied "
          "there.\n",
          leftOut_);
    return text + tests_;
  }

 private:
  const MeshRequest& request_;
  const RuleSet& rules_;
  SingleStepper stepper_;
  std::set<std::string> kinds_;
  std::string tests_;
  std::size_t leftOut_ = 0;
};

}  // namespace

void writeStuckTests(const MeshRequest& request, const RuleSet& rules,
                     const geometry::ModelMesh& mesh) {
  TestFile file(request, rules);
  for (const FaceReport& face : mesh.faces)
    for (const StuckPlace& place : face.stuck) file.add(face, place);
  writeText(request.stuckTests.string(), file.text());
}

}  // namespace af2::cli
