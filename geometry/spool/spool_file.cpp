#include "geometry/spool/spool_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;

/// Only whole blocks can be given back.
constexpr std::uint64_t kBlock = 4096;

/// Where the file system has no files without a name, a file that loses it at once.
int openSpool(const fs::path& folder) {
  const int nameless = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC | O_EXCL, 0600);
  if (nameless >= 0) return nameless;
  std::string pattern = (folder / "af2-spool-XXXXXX").string();  // mkstemp replaces the letters
  const int named = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(pattern.c_str());
  return named;
}

std::string spoolReason(int error) {
  const std::string reason = std::generic_category().message(error);
  if (error == ENOSPC || error == EDQUOT)
    return "the disk is full (" + reason + "); write the mesh to a folder on a larger disk";
  return reason;
}

}  // namespace

SpoolFile::SpoolFile(fs::path folder)
    : folder_(folder.empty() ? fs::path(".") : std::move(folder)), descriptor_(openSpool(folder_)) {
  if (descriptor_ < 0) fail("opening a file");
}

SpoolFile::SpoolFile() : folder_("memory"), descriptor_(::memfd_create("af2-spool", MFD_CLOEXEC)) {
  if (descriptor_ < 0) fail("opening a file");
}

SpoolFile::~SpoolFile() { ::close(descriptor_); }

SpoolFile::Place SpoolFile::reserve(std::uint64_t size) {
  const std::uint64_t blocks = (size + kBlock - 1) / kBlock;
  return {end_.fetch_add(blocks * kBlock), size};
}

void SpoolFile::write(std::uint64_t at, const void* data, std::uint64_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::pwrite(descriptor_, next, size, static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("writing");
    next += written;
    at += static_cast<std::uint64_t>(written);
    size -= static_cast<std::uint64_t>(written);
  }
}

void SpoolFile::read(std::uint64_t at, void* data, std::uint64_t size) const {
  char* next = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = ::pread(descriptor_, next, size, static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = EIO;  // the file is shorter than what was written to it
    if (got <= 0) fail("reading");
    next += got;
    at += static_cast<std::uint64_t>(got);
    size -= static_cast<std::uint64_t>(got);
  }
}

void SpoolFile::release(const Place& place) noexcept {
  const std::uint64_t blocks = (place.size + kBlock - 1) / kBlock;
  if (blocks == 0) return;
  // A file system that cannot do it keeps the room until the end of the run.
  (void)::fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                    static_cast<off_t>(place.begin), static_cast<off_t>(blocks * kBlock));
}

void SpoolFile::fail(const char* doing) const {
  const int error = errno;
  throw InputError("cannot keep the mesh in '" + folder_.string() + "': " + doing +
                   " failed: " + spoolReason(error));
}

}  // namespace af2::geometry
