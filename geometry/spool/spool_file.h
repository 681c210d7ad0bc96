// A file for parts of a mesh in their packed form. It has no name, so that it vanishes with the
// program.
// Not installed.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace af2::geometry {

/// All functions may be called from several threads at once. They throw InputError, naming the
/// folder, if the file system reports an error.
class SpoolFile {
 public:
  /// On the disk of the folder.
  explicit SpoolFile(std::filesystem::path folder);
  /// In memory.
  SpoolFile();
  ~SpoolFile();
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;

  /// Some bytes of the file.
  struct Place {
    std::uint64_t begin = 0, size = 0;
  };

  /// Room for so many bytes, which are written piece by piece.
  Place reserve(std::uint64_t size);
  void write(std::uint64_t at, const void* data, std::uint64_t size);
  void read(std::uint64_t at, void* data, std::uint64_t size) const;
  /// Gives the room back to the file system, where this can do that.
  void release(const Place& place) noexcept;

  template <class T>
  void write(std::uint64_t at, std::span<const T> values) {
    write(at, values.data(), values.size_bytes());
  }
  template <class T>
  void read(std::uint64_t at, std::span<T> values) const {
    read(at, values.data(), values.size_bytes());
  }

 private:
  [[noreturn]] void fail(const char* doing) const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::atomic<std::uint64_t> end_ = 0;
};

}  // namespace af2::geometry
