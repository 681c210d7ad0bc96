// Writes a file completely or not at all: to a temporary file, which is renamed at the end.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

namespace af2::geometry {

/// Buffered output to `target`. Until `commit` the target keeps its previous content; an OutputFile
/// that is destroyed without `commit` leaves nothing behind.
///
/// Every function throws InputError, naming the target, if the file system reports an error.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void text(std::string_view bytes) { this->bytes(bytes.data(), bytes.size()); }
  /// In the shortest form that reads back as the same number.
  void number(double value);
  void number(std::integral auto value) { integer(static_cast<long long>(value)); }

  void bytes(const void* data, std::size_t size) {
    if (size > kCapacity - used_) return bytesPastBuffer(data, size);
    std::memcpy(buffer_.get() + used_, data, size);
    used_ += size;
  }
  /// The bytes of `value`, lowest first as on every machine that AF2 is built for.
  template <class T>
  void binary(T value) {
    bytes(&value, sizeof value);
  }
  /// The bytes of `value`, highest first.
  template <class T>
  void bigEndian(T value) {
    char reversed[sizeof(T)];
    std::memcpy(reversed, &value, sizeof value);
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) {
      std::swap(reversed[i], reversed[sizeof(T) - 1 - i]);
    }
    bytes(reversed, sizeof reversed);
  }

  const std::filesystem::path& target() const { return target_; }

  /// For libraries that write files themselves: a path beside the target at which there is no file.
  /// What others write there takes the place of what was written here.
  const std::filesystem::path& pathForOthers();

  /// Replaces the target by what was written, safely on disk.
  void commit();

 private:
  static constexpr std::size_t kCapacity = 1 << 18;
  static constexpr std::size_t kLongestNumber = 32;

  void integer(long long value);
  void bytesPastBuffer(const void* data, std::size_t size);
  void writeThrough(const char* data, std::size_t size);
  void flush();
  void giveName();
  void openWhatOthersWrote();
  [[noreturn]] void fail(const char* doing) const;

  std::filesystem::path target_, temporary_;
  int descriptor_ = -1;
  bool named_ = false;  ///< whether there is a file `temporary_`
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
};

/// Throws InputError, with the reason and a remedy, if no file can be written at `target`. Call it
/// before the work begins.
void checkWritable(const std::filesystem::path& target);

}  // namespace af2::geometry
