// There are no files for parts of meshes, which the playground does not ask for.
#include "engine/base/error.h"
#include "geometry/spool/spool_file.h"

namespace af2::geometry {

SpoolFile::SpoolFile(std::filesystem::path folder) : folder_(std::move(folder)) { fail("made"); }
SpoolFile::SpoolFile() { fail("made"); }
SpoolFile::~SpoolFile() = default;

SpoolFile::Place SpoolFile::reserve(std::uint64_t) { fail("enlarged"); }
void SpoolFile::write(std::uint64_t, const void*, std::uint64_t) { fail("written"); }
void SpoolFile::read(std::uint64_t, void*, std::uint64_t) const { fail("read"); }
void SpoolFile::release(const Place&) noexcept {}

void SpoolFile::fail(const char* doing) const {
  throw InputError(std::string("a file for faces cannot be ") + doing + " here");
}

}  // namespace af2::geometry
