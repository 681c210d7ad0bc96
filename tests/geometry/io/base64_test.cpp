#include "geometry/io/base64.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/base/words.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

std::string encoded(const auto& fill) {
  const testing::TestFile made("base64");
  {
    OutputFile file(made.path());
    Base64Stream stream(file);
    fill(stream);
    stream.finish();
    file.commit();
  }
  return contentOf(made.path());
}

std::string encodedBytes(std::string_view bytes) {
  return encoded([&](Base64Stream& stream) { stream.bytes(bytes); });
}

/// One bit after the other.
std::string decoded(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char digit : text.substr(0, text.find('='))) {
    const std::size_t value = kDigits.find(digit);
    EXPECT_NE(value, std::string_view::npos);
    bits = bits << 6 | static_cast<unsigned>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

/// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(encodedBytes(""), "");
  EXPECT_EQ(encodedBytes("f"), "Zg==");
  EXPECT_EQ(encodedBytes("fo"), "Zm8=");
  EXPECT_EQ(encodedBytes("foo"), "Zm9v");
  EXPECT_EQ(encodedBytes("foob"), "Zm9vYg==");
  EXPECT_EQ(encodedBytes("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encodedBytes("foobar"), "Zm9vYmFy");
}

TEST(Base64, EncodesMoreThanOneBlock) {
  for (std::size_t size = 12'286; size < 12'292; ++size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(i * i % 251);
    EXPECT_EQ(decoded(encodedBytes(bytes)), bytes) << size;
  }
}

TEST(Base64, EncodesValuesOfAnySize) {
  std::string bytes;
  const auto add = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return value;
  };
  const std::string text = encoded([&](Base64Stream& stream) {
    for (int i = 0; i < 5000; ++i) {
      stream.put(add(std::uint8_t(i)));
      stream.put(add(std::int32_t{-i}));
      stream.put(add(1.0 / (i + 1)));
    }
  });
  EXPECT_EQ(decoded(text), bytes);
}

}  // namespace
}  // namespace af2::geometry
