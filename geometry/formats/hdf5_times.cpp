// HDF5 keeps four times in the header of each object, under a checksum; the libraries that write
// the files offer no way to leave them out. Headers are found by their signature. One is changed
// only if its checksum is right, so that what looks like a header in the data stays as it is.
#include "geometry/formats/hdf5_times.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace af2::geometry {
namespace {

using Bytes = std::span<std::uint8_t>;

constexpr std::string_view kSignature = "OHDR";
constexpr std::size_t kTimes = 16, kChecksum = 4;

std::uint64_t lowFirst(Bytes bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
  return value;
}

/// The checksum of HDF5: Bob Jenkins's "lookup3", of twelve bytes at a time.
class Lookup3 {
 public:
  static std::uint32_t of(Bytes bytes) {
    Lookup3 sum(bytes.size());
    if (bytes.empty()) return sum.c_;
    for (; bytes.size() > 12; bytes = bytes.subspan(12)) {
      sum.add(bytes.first(12));
      sum.mix();
    }
    sum.add(bytes);
    return sum.last();
  }

 private:
  explicit Lookup3(std::size_t size)
      : a_(0xdeadbeefu + static_cast<std::uint32_t>(size)), b_(a_), c_(a_) {}

  void add(Bytes bytes) {
    std::uint32_t* const words[] = {&a_, &b_, &c_};
    for (std::size_t i = 0; i < bytes.size(); ++i)
      *words[i / 4] += std::uint32_t{bytes[i]} << (8 * (i % 4));
  }

  /// x takes y in, turned by some bits, and y the third.
  static void stir(std::uint32_t& x, std::uint32_t& y, std::uint32_t z, int bits) {
    x -= y;
    x ^= std::rotl(y, bits);
    y += z;
  }
  void mix() {
    stir(a_, c_, b_, 4);
    stir(b_, a_, c_, 6);
    stir(c_, b_, a_, 8);
    stir(a_, c_, b_, 16);
    stir(b_, a_, c_, 19);
    stir(c_, b_, a_, 4);
  }

  static void close(std::uint32_t& x, std::uint32_t y, int bits) {
    x ^= y;
    x -= std::rotl(y, bits);
  }
  std::uint32_t last() {
    close(c_, b_, 14);
    close(a_, c_, 11);
    close(b_, a_, 25);
    close(c_, b_, 16);
    close(a_, c_, 4);
    close(b_, a_, 14);
    close(c_, b_, 24);
    return c_;
  }

  std::uint32_t a_, b_, c_;
};

/// file  from the signature on
void clearTimesOf(Bytes file) {
  constexpr std::size_t kHead = 6;  // signature, version, flags
  constexpr std::uint8_t kHasTimes = 0x20, kHasLimits = 0x10, kWidth = 0x03;
  if (file.size() < kHead + kTimes || file[4] != 2 || !(file[5] & kHasTimes)) return;
  const std::size_t width = std::size_t{1} << (file[5] & kWidth);
  const std::size_t sizeAt = kHead + kTimes + (file[5] & kHasLimits ? 4 : 0);
  if (file.size() < sizeAt + width) return;
  const std::uint64_t size = lowFirst(file.subspan(sizeAt, width));
  const std::size_t before = sizeAt + width + kChecksum;
  if (file.size() < before || size > file.size() - before) return;
  const Bytes header = file.first(sizeAt + width + static_cast<std::size_t>(size));
  const Bytes checksum = file.subspan(header.size(), kChecksum);
  if (Lookup3::of(header) != lowFirst(checksum)) return;
  std::memset(header.data() + kHead, 0, kTimes);
  const std::uint32_t sum = Lookup3::of(header);
  std::memcpy(checksum.data(), &sum, kChecksum);
}

}  // namespace

void clearHdf5Times(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return;
  struct ::stat status {};
  const bool isKnown = ::fstat(descriptor, &status) == 0 && status.st_size > 0;
  const auto size = static_cast<std::size_t>(isKnown ? status.st_size : 0);
  void* const content =
      isKnown ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0)
              : MAP_FAILED;
  ::close(descriptor);
  if (content == MAP_FAILED) return;
  const Bytes bytes(static_cast<std::uint8_t*>(content), size);
  const std::string_view text(static_cast<const char*>(content), size);
  if (text.starts_with("\x89HDF\r\n\x1a\n"))
    for (std::size_t at = text.find(kSignature); at != std::string_view::npos;
         at = text.find(kSignature, at + 1))
      clearTimesOf(bytes.subspan(at));
  ::munmap(content, size);
}

}  // namespace af2::geometry
