#include "geometry/planar/poly_file.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>

#include "engine/error.h"

namespace af2::geometry {

namespace {

namespace fs = std::filesystem;

constexpr long kMostItems = 100'000'000;

/// The lines of a file that hold something, as words; `#` starts a comment.
class WordFile {
 public:
  explicit WordFile(const fs::path& path) : name_(path.string()), stream_(path) {
    if (fs::is_directory(path)) throw InputError(name_ + ": is a folder, not a file");
    if (!stream_) throw InputError(name_ + ": cannot be opened; check that it exists");
  }

  /// Goes to the next line with words; false at the end of the file.
  bool next() {
    while (std::getline(stream_, text_)) {
      ++line_;
      split();
      if (!words_.empty()) return true;
    }
    ++line_;
    words_.clear();
    return false;
  }
  void expectLine(const std::string& what) {
    if (!next()) fail("the file ends where " + what + " should follow");
  }

  std::size_t count() const { return words_.size(); }
  int line() const { return line_; }

  double number(std::size_t i, const std::string& what) const {
    double value = 0;
    const std::string_view word = at(i, what);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      fail("'" + std::string(word) + "' is no number; " + what + " should stand here");
    return value;
  }
  long whole(std::size_t i, const std::string& what) const {
    const double value = number(i, what);
    if (value != std::floor(value) || std::abs(value) > static_cast<double>(kMostItems))
      fail(std::to_string(value) + " is no " + what);
    return static_cast<long>(value);
  }
  long countAt(std::size_t i, const std::string& what) const {
    const long value = whole(i, what);
    if (value < 0) fail("the " + what + " is negative");
    return value;
  }

  [[noreturn]] void fail(const std::string& fault) const {
    throw InputError(name_ + ":" + std::to_string(line_) + ": " + fault);
  }

 private:
  std::string_view at(std::size_t i, const std::string& what) const {
    if (i >= words_.size()) fail("the line is too short; " + what + " is missing");
    std::string_view word = words_[i];
    if (word.starts_with('+')) word.remove_prefix(1);
    return word;
  }
  void split() {
    words_.clear();
    const std::string_view text = std::string_view(text_).substr(0, text_.find('#'));
    constexpr std::string_view kBlank = " \t\r\f\v,";
    for (std::size_t i = text.find_first_not_of(kBlank); i != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(kBlank, i), text.size());
      words_.push_back(text.substr(i, end - i));
      i = text.find_first_not_of(kBlank, end);
    }
  }

  std::string name_;
  std::ifstream stream_;
  std::string text_;
  std::vector<std::string_view> words_;
  int line_ = 0;
};

class PolyReader {
 public:
  explicit PolyReader(const fs::path& path) : path_(path) { domain_.name = path.string(); }

  PlanarDomain read() {
    WordFile file(path_);
    file.expectLine("the number of vertices");
    if (file.countAt(0, "number of vertices") == 0)
      readNodeFile();
    else
      readPoints(file);
    readSegments(file);
    readHoles(file);
    return std::move(domain_);
  }

 private:
  void readNodeFile() {
    fs::path nodes = path_;
    nodes.replace_extension(".node");
    if (!fs::exists(nodes))
      throw InputError(domain_.name + ": holds no vertices, and there is no file " +
                       nodes.string() + " beside it that does");
    WordFile file(nodes);
    file.expectLine("the number of vertices");
    readPoints(file);
    domain_.pointLines.clear();  // lines of another file
  }

  void readPoints(WordFile& file) {
    const long count = file.countAt(0, "number of vertices");
    if (file.count() > 1 && file.whole(1, "dimension") != 2)
      file.fail("the dimension is not 2; only planar domains can be read from this format");
    for (long i = 0; i < count; ++i) {
      file.expectLine("vertex " + std::to_string(i + 1) + " of " + std::to_string(count));
      const long id = file.whole(0, "vertex number");
      if (!index_.try_emplace(id, static_cast<int>(i)).second)
        file.fail("vertex " + std::to_string(id) + " stands here for the second time");
      domain_.points.push_back({file.number(1, "x"), file.number(2, "y")});
      domain_.pointLines.push_back(file.line());
    }
  }

  int pointAt(const WordFile& file, std::size_t word) const {
    const long id = file.whole(word, "vertex number");
    const auto found = index_.find(id);
    if (found != index_.end()) return found->second;
    file.fail("there is no vertex " + std::to_string(id) +
              (index_.empty() ? std::string()
                              : "; they are numbered " + std::to_string(index_.begin()->first) +
                                    " to " + std::to_string(index_.rbegin()->first)));
  }

  void readSegments(WordFile& file) {
    file.expectLine("the number of segments");
    const long count = file.countAt(0, "number of segments");
    const bool hasMarkers = file.count() > 1 && file.whole(1, "number of markers") > 0;
    for (long i = 0; i < count; ++i) {
      file.expectLine("segment " + std::to_string(i + 1) + " of " + std::to_string(count));
      PlanarDomain::Segment segment;
      segment.from = pointAt(file, 1);
      segment.to = pointAt(file, 2);
      if (hasMarkers && file.count() > 3)
        segment.marker = static_cast<int>(file.whole(3, "boundary marker"));
      segment.line = file.line();
      domain_.segments.push_back(segment);
    }
  }

  /// Regions, which may follow, only carry attributes and area limits.
  void readHoles(WordFile& file) {
    if (!file.next()) return;  // some programs leave out the line with the number of holes
    const long count = file.countAt(0, "number of holes");
    for (long i = 0; i < count; ++i) {
      file.expectLine("hole " + std::to_string(i + 1) + " of " + std::to_string(count));
      domain_.holes.push_back({file.number(1, "x"), file.number(2, "y")});
    }
  }

  fs::path path_;
  PlanarDomain domain_;
  std::map<long, int> index_;  // by vertex number, which may start at 0, at 1 or anywhere
};

}  // namespace

PlanarDomain readPoly(const fs::path& path) { return PolyReader(path).read(); }

}  // namespace af2::geometry
