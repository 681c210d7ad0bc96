// Writers that are libraries of their own.
#include <cstring>

#include "engine/base/error.h"
#include "geometry/base/loaded_parts.h"
#include "geometry/formats/hdf5_times.h"
#include "geometry/formats/writer_module.h"
#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

const WriterModule& loadedWriter(const char* library) {
  const auto isSame = [](const WriterModule& module) {
    return std::strcmp(module.version, AF2_VERSION) == 0 && module.meshSize == kWriterMeshSize;
  };
  return moduleOfPart<WriterModule>(library, kWriterModuleEntry, isSame);
}

void writeByModule(const char* library, const ModelMesh& mesh, const Extras& extras,
                   OutputFile& file) {
  const MshGroups groups(mesh, extras, {});
  const GroupedMesh grouped{mesh, extras.lines, groupMembers(mesh, extras.lines, groups),
                            elementBlocks(mesh, groups), sidesOnLines(mesh, extras.lines)};
  const std::filesystem::path path = file.pathForOthers();
  const WriterModule& writer = loadedWriter(library);
  try {
    writer.write(grouped, path.c_str());
  } catch (const InputError& error) {
    throw InputError("cannot write '" + file.target().string() + "': " + error.what() +
                     "; the disk may be full");
  }
  clearHdf5Times(path);
}

}  // namespace

void writeMed(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  writeByModule(kMedWriter, mesh, extras, file);
}

void writeExodus(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  writeByModule(kExodusWriter, mesh, extras, file);
}

void writeCgns(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  writeByModule(kCgnsWriter, mesh, extras, file);
}

}  // namespace af2::geometry
