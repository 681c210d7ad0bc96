#include "geometry/io/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the writers rely on it");

[[noreturn]] void refuse(const fs::path& target, const std::string& reason) {
  throw InputError("cannot write '" + target.string() + "': " + reason);
}

/// The remedies for the most common errors.
std::string explained(int error, const fs::path& directory) {
  const std::string reason = std::generic_category().message(error);
  if (error == ENOENT) {
    return "the directory '" + directory.string() + "' does not exist; make it with 'mkdir -p'";
  }
  if (error == EACCES || error == EROFS || error == EPERM) {
    return "no permission to write in '" + directory.string() + "'; choose another directory";
  }
  if (error == ENOSPC || error == EDQUOT) return "the disk is full (" + reason + ")";
  return reason;
}

fs::path directoryOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Where a symbolic link points, so that the link stays one.
fs::path resolved(const fs::path& target) {
  std::error_code ignored;
  if (!fs::is_symlink(target, ignored)) return target;
  const fs::path real = fs::weakly_canonical(target, ignored);
  return ignored ? target : real;
}

void refuseOddTargets(const fs::path& target) {
  if (target.empty() || !target.has_filename()) refuse(target, "a file name is missing");
  std::error_code odd;
  const fs::file_status status = fs::status(target, odd);
  if (odd == std::errc::too_many_symbolic_link_levels) refuse(target, "it is a link to itself");
  if (fs::is_directory(status)) refuse(target, "it is a directory; give a file name");
  if (fs::exists(status) && !fs::is_regular_file(status))
    refuse(target, "it is not a regular file");
}

constexpr const char* kOpenFiles = "/proc/self/fd";

/// A file without a name, which vanishes even if the program is killed; -1 where there is no such.
int openNameless(const fs::path& directory) {
  if (::access(kOpenFiles, X_OK) != 0) return -1;  // it could not get a name later
  return ::open(directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

int openNamed(const fs::path& path) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

}  // namespace

OutputFile::OutputFile(const fs::path& target) : target_(resolved(target)) {
  refuseOddTargets(target_);
  temporary_ = target_;
  temporary_ += "." + std::to_string(::getpid()) + ".tmp";
  // A file gets its name when it is complete; that would be a bad time to find out.
  std::error_code odd;
  const fs::file_status status = fs::status(temporary_, odd);
  if (!fs::status_known(status) && odd == std::errc::filename_too_long)
    refuse(target_, "its name is too long");
  descriptor_ = openNameless(directoryOf(target_));
  named_ = descriptor_ < 0;
  if (named_) descriptor_ = openNamed(temporary_);
  if (descriptor_ < 0) refuse(target_, explained(errno, directoryOf(target_)));
  buffer_ = std::make_unique_for_overwrite<char[]>(kCapacity);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (named_) ::unlink(temporary_.c_str());
}

void OutputFile::number(double value) {
  if (kCapacity - used_ < kLongestNumber) flush();
  char* begin = buffer_.get() + used_;
  used_ +=
      static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr - begin);
}

void OutputFile::integer(long long value) {
  if (kCapacity - used_ < kLongestNumber) flush();
  char* begin = buffer_.get() + used_;
  used_ +=
      static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr - begin);
}

void OutputFile::bytesPastBuffer(const void* data, std::size_t size) {
  flush();
  if (size > kCapacity) return writeThrough(static_cast<const char*>(data), size);
  std::memcpy(buffer_.get(), data, size);
  used_ = size;
}

void OutputFile::flush() {
  writeThrough(buffer_.get(), used_);
  used_ = 0;
}

void OutputFile::writeThrough(const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("writing");
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

const fs::path& OutputFile::pathForOthers() {
  ::close(descriptor_);
  descriptor_ = -1;
  used_ = 0;
  ::unlink(temporary_.c_str());
  named_ = true;
  return temporary_;
}

void OutputFile::openWhatOthersWrote() {
  descriptor_ = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail("opening");
}

void OutputFile::commit() {
  if (descriptor_ < 0) openWhatOthersWrote();
  flush();
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("syncing");
  giveName();
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail("closing");
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("renaming");
  named_ = false;
}

/// A nameless file cannot take the place of another one, a named one can.
void OutputFile::giveName() {
  if (named_) return;
  const std::string self = std::string(kOpenFiles) + "/" + std::to_string(descriptor_);
  ::unlink(temporary_.c_str());  // left by a process of the same number
  if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0) {
    fail("naming");
  }
  named_ = true;
}

void OutputFile::fail(const char* doing) const {
  const int error = errno;
  refuse(target_, std::string(doing) + " failed: " + explained(error, directoryOf(target_)));
}

void checkWritable(const fs::path& target) { OutputFile probe(target); }

}  // namespace af2::geometry
