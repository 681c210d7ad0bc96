// Writes the page that plays a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/trace_view/face_record.h"
#include "engine/rule/rule_set.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// What the page is about, besides the records.
struct ViewSubject {
  const RuleSet& rules;
  const std::vector<geometry::RuleText>& ruleTexts;
  const geometry::ModelMesh& mesh;  ///< of the run
  std::vector<std::string> notes;
  std::size_t firstStep = 1, lastStep = 0;  ///< that the page plays, in each face; 0: to the end
};

/// Faces follow each other in the order of the list. Throws InputError if the file cannot be
/// written.
void writeViewPage(const ViewSubject& subject, const std::vector<FaceRecord*>& faces,
                   const std::filesystem::path& file);

}  // namespace af2::cli
