// af2 inspect
#include <fmt/core.h>

#include <map>
#include <memory>

#include "cli/exit_code.h"
#include "cli/verbs.h"
#include "engine/error.h"
#if AF2_HAVE_OCC
#include "geometry/occ/model.h"
#endif

namespace af2::cli {
#if AF2_HAVE_OCC
namespace {

void printOverview(const geometry::Model& model) {
  const std::string unit = model.unit().empty() ? "" : " " + model.unit();
  fmt::print("{} faces, {} edges, {} vertices; diagonal {:.6g}{}\n", model.faceCount(),
             model.edgeCount(), model.vertexCount(), model.diagonal(), unit);
  for (const std::string& note : model.notes()) fmt::print("note: {}\n", note);
}

void printSurfaceTypes(const geometry::Model& model) {
  std::map<std::string, int> counts;
  for (int face = 1; face <= model.faceCount(); ++face) ++counts[model.surfaceType(face)];
  for (const auto& [type, count] : counts) fmt::print("{:>8}  {}\n", count, type);
}

void printFaces(const geometry::Model& model) {
  fmt::print("{:>8}  {:<12}  {}\n", "face", "surface", "name");
  for (int face = 1; face <= model.faceCount(); ++face) {
    fmt::print("{:>8}  {:<12}  {}\n", face, model.surfaceType(face), model.faceName(face));
  }
}

void printGroups(const geometry::Model& model) {
  if (model.groups().empty()) return;
  fmt::print("{:>8}  {:<12}  {}\n", "faces", "group", "name");
  for (const geometry::FaceGroup& group : model.groups())
    fmt::print("{:>8}  {:<12}  {}\n", group.faces.size(), geometry::toString(group.kind),
               group.name);
}

}  // namespace
#endif

Action declareInspect(CLI::App& command) {
  const auto path = std::make_shared<std::string>();
  const auto brief = std::make_shared<bool>(false);
  command.add_option("model", *path, "STEP, IGES or BREP file")->required();
  command.add_flag("--brief", *brief, "count the faces of each kind instead of listing them");
  return [path, brief]() -> int {
#if AF2_HAVE_OCC
    const geometry::Model model = geometry::readModel(*path);
    printOverview(model);
    *brief ? printSurfaceTypes(model) : printFaces(model);
    printGroups(model);
    return kComplete;
#else
    throw InputError("this af2 was built without OpenCASCADE; build it with -DAF2_BUILD_OCC=ON");
#endif
  };
}

}  // namespace af2::cli
