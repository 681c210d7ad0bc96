#include "geometry/mpi/partition/part_files.h"

#include <string>

#include "engine/base/error.h"
#include "geometry/base/file_extension.h"

namespace af2::mpi {

namespace fs = std::filesystem;

namespace {

bool isPvtu(const fs::path& file) { return file.extension() == ".pvtu"; }

}  // namespace

void checkPartsFile(const fs::path& file) {
  if (!isPvtu(file) && file.extension() != ".msh")
    throw InputError("'" + file.string() + "': meshes in parts are .pvtu or .msh files");
  geometry::checkWritable(partFileOf(file, 0));
}

fs::path partFileOf(const fs::path& file, int process) {
  fs::path part = file;
  part.replace_extension();
  part += isPvtu(file) ? "_" + std::to_string(process) + ".vtu"
                       : "_" + std::to_string(process + 1) + ".msh";
  return part;
}

PartFiles writePart(const OwnedPart& part, const fs::path& file) {
  PartFiles files;
  const auto open = [&](const fs::path& path) -> geometry::OutputFile& {
    return *files.emplace_back(std::make_unique<geometry::OutputFile>(path));
  };
  (isPvtu(file) ? writePartVtu : writePartMsh)(part, open(partFileOf(file, part.process)));
  if (isPvtu(file) && part.process == 0) writePvtu(part, file, open(file));
  return files;
}

}  // namespace af2::mpi
