// The readers of STEP and IGES files for the program af2: from libraries beside it that are loaded
// when the first such file is read.
#include <cstring>
#include <string>

#include "geometry/base/loaded_parts.h"
#include "geometry/occ/loading/reader_module.h"
#include "geometry/occ/read/readers.h"

namespace af2::geometry {

namespace {

namespace fs = std::filesystem;

const ReaderModule& load(const std::string& library) {
  const auto isSame = [](const ReaderModule& module) {
    return std::strcmp(module.version, AF2_VERSION) == 0 && module.shapeSize == sizeof(ReadShape);
  };
  return moduleOfPart<ReaderModule>(library, kReaderModuleEntry, isSame);
}

}  // namespace

ReadShape readStep(const fs::path& path) {
  static const ReaderModule& reader = load("af2-step.so");
  return reader.read(path);
}

ReadShape readIges(const fs::path& path) {
  static const ReaderModule& reader = load("af2-iges.so");
  return reader.read(path);
}

}  // namespace af2::geometry
