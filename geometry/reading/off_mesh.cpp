// Geomview's OFF files, text: vertices, then the corners of polygons.
#include "geometry/base/words.h"
#include "geometry/reading/formats.h"

namespace af2::geometry {
namespace {

/// The lines with words; `#` starts a comment.
class OffLines {
 public:
  OffLines(const MeshBuilder& mesh, std::string_view text) : mesh_(mesh), text_(text) {}

  /// what  is expected there, for messages
  std::vector<std::string_view> next(const char* what) {
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      const std::string_view line = text_.substr(at_, end - at_);
      at_ = end + 1;
      ++number_;
      const auto words = wordsIn(line.substr(0, line.find('#')));
      if (!words.empty()) return words;
    }
    mesh_.fail(std::string("is truncated: ") + what + " is missing");
  }

  double number(const std::vector<std::string_view>& words, std::size_t i) const {
    if (i >= words.size()) fail("the line is too short");
    const auto value = numberIn<double>(words[i]);
    if (!value) fail("'" + std::string(words[i]) + "' is not a number");
    return *value;
  }
  /// As many things have at least one byte each in the rest of the file.
  std::size_t count(const std::vector<std::string_view>& words, std::size_t i) const {
    const double value = number(words, i);
    if (!(value >= 0)) fail("a count is negative");
    if (value > static_cast<double>(text_.size()))
      mesh_.fail("is truncated: it is too short for " + std::string(words[i]) + " things");
    return static_cast<std::size_t>(value);
  }

  [[noreturn]] void fail(const std::string& fault) const {
    mesh_.fail("line " + std::to_string(number_) + ": " + fault);
  }

 private:
  const MeshBuilder& mesh_;
  std::string_view text_;
  std::size_t at_ = 0;
  int number_ = 0;
};

}  // namespace

void readOff(const std::string& content, MeshBuilder& mesh) {
  OffLines lines(mesh, content);
  std::vector<std::string_view> words = lines.next("the head");
  if (!words[0].ends_with("OFF")) mesh.fail("is not an OFF file: it does not begin with OFF");
  if (words[0].find_first_of("n4") != std::string_view::npos ||
      (words.size() > 1 && words[1] == "BINARY"))
    mesh.fail("is an OFF file of another dimension or without text; write it as plain OFF");
  words.erase(words.begin());
  if (words.empty()) words = lines.next("the counts");
  const std::size_t vertices = lines.count(words, 0), faces = lines.count(words, 1);
  for (std::size_t i = 0; i < vertices; ++i) {
    words = lines.next("a vertex");
    mesh.addVertex({lines.number(words, 0), lines.number(words, 1), lines.number(words, 2)});
  }
  for (std::size_t i = 0; i < faces; ++i) {
    words = lines.next("a polygon");
    std::vector<std::uint64_t> corners;
    const std::size_t count = lines.count(words, 0);
    for (std::size_t k = 1; k <= count; ++k)
      corners.push_back(vertexNumber(lines.number(words, k)));
    mesh.addElement(corners, 1);
  }
}

}  // namespace af2::geometry
