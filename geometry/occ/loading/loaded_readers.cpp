// The readers of STEP and IGES files for the program af2: from libraries beside it that are loaded
// when the first such file is read.
#include <cstring>
#include <string>

#include "engine/base/error.h"
#include "geometry/base/loaded_parts.h"
#include "geometry/occ/loading/reader_module.h"
#include "geometry/occ/read/readers.h"

namespace af2::geometry {

namespace {

namespace fs = std::filesystem;

const ReaderModule& load(const std::string& library, const char* needed) {
  void* const entry = entryOfPart(library, kReaderModuleEntry, needed);
  const ReaderModule* const found =
      entry ? reinterpret_cast<const ReaderModule* (*)()>(entry)() : nullptr;
  if (!found || std::strcmp(found->version, AF2_VERSION) != 0 ||
      found->shapeSize != sizeof(ReadShape))
    throw InputError(placeOfPart(library).string() +
                     " belongs to another version of this program; build or install both together");
  return *found;
}

}  // namespace

ReadShape readStep(const fs::path& path) {
  static const ReaderModule& reader = load("af2-step.so", AF2_NEEDED_BY_STEP);
  return reader.read(path);
}

ReadShape readIges(const fs::path& path) {
  static const ReaderModule& reader = load("af2-iges.so", AF2_NEEDED_BY_IGES);
  return reader.read(path);
}

}  // namespace af2::geometry
