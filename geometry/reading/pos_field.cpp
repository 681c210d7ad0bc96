// Gmsh's views as text: View "NAME" { ST(x, y, z, ...){a, b, c}; ... };
#include <algorithm>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/reading/field_cells.h"

namespace af2::geometry {
namespace {

/// The second letter of an entry: a kind of cell.
struct PosKind {
  char letter;
  std::size_t corners;
  int dimension;
};
constexpr PosKind kPosKinds[] = {{'P', 1, 0}, {'L', 2, 1}, {'T', 3, 2}, {'Q', 4, 2},
                                 {'S', 4, 3}, {'H', 8, 3}, {'I', 6, 3}, {'Y', 5, 3}};

class PosReader {
 public:
  PosReader(const std::string& name, std::string_view text, FieldCells& field)
      : name_(name), text_(text), field_(field) {}

  void read() {
    for (skipBlanks(); at_ < text_.size(); skipBlanks()) {
      if (word() != "View") fail("expected View \"NAME\" { ... };");
      readView();
    }
    if (field_.arrays.empty() && field_.others.empty())
      throw InputError(name_ + ": has no view; give a file of Gmsh's views in text form");
  }

 private:
  void readView() {
    const std::string view = quoted();
    expect('{');
    for (skipBlanks(); !isAt('}'); skipBlanks()) {
      if (at_ == text_.size()) fail("the file ends within the view '" + view + "'");
      readEntry(view);
    }
    expect('}');
    if (isAt(';')) ++at_;
  }

  void readEntry(const std::string& view) {
    const std::string kind(word());
    const auto* const found = kind.size() == 2 && kind[0] == 'S'
                                  ? std::ranges::find(kPosKinds, kind[1], &PosKind::letter)
                                  : std::end(kPosKinds);
    if (found == std::end(kPosKinds)) {
      noteOther(view, kind);
      return skipEntry();
    }
    const std::vector<double> x = numbers('(', ')'), values = numbers('{', '}');
    expect(';');
    if (x.size() != 3 * found->corners)
      fail(kind + " needs " + std::to_string(3 * found->corners) + " coordinates");
    if (values.size() < found->corners)
      fail(kind + " needs " + std::to_string(found->corners) + " values");
    const std::size_t first = field_.vertices.size();
    std::vector<std::uint64_t> corners;
    for (std::size_t i = 0; i < found->corners; ++i) {
      corners.push_back(first + i);
      field_.vertices.push_back({x[3 * i], x[3 * i + 1], x[3 * i + 2]});
    }
    field_.add(corners, found->dimension);
    field_.addValues(
        view, first,
        {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(found->corners)});
  }

  /// Vectors, tensors, texts, and what else views may have.
  void noteOther(const std::string& view, const std::string& kind) {
    const std::string other = view + " (" + kind + ")";
    if (std::ranges::find(field_.others, other) == field_.others.end())
      field_.others.push_back(other);
  }
  void skipEntry() {
    at_ = std::min(text_.find(';', at_), text_.size());
    if (at_ == text_.size()) fail("the file ends within an entry");
    ++at_;
  }

  void skipBlanks() {
    for (;;) {
      at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
      const std::string_view rest = text_.substr(at_);
      if (!rest.starts_with("//") && !rest.starts_with("/*")) return;
      const bool isLine = rest[1] == '/';
      const std::size_t end = text_.find(isLine ? "\n" : "*/", at_ + 2);
      at_ = end == std::string_view::npos ? text_.size() : end + (isLine ? 1 : 2);
    }
  }
  bool isAt(char c) {
    skipBlanks();
    return at_ < text_.size() && text_[at_] == c;
  }
  void expect(char c) {
    if (!isAt(c)) fail(std::string("expected '") + c + "'");
    ++at_;
  }
  std::string_view word() {
    skipBlanks();
    const std::size_t end =
        std::min(text_.find_first_not_of(
                     "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_", at_),
                 text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    if (found.empty()) fail("expected a word");
    at_ = end;
    return found;
  }
  std::string quoted() {
    expect('"');
    const std::size_t end = text_.find('"', at_);
    if (end == std::string_view::npos) fail("a name has no end");
    const std::string found(text_.substr(at_, end - at_));
    at_ = end + 1;
    return found;
  }
  std::vector<double> numbers(char open, char close) {
    expect(open);
    const std::size_t end = text_.find(close, at_);
    if (end == std::string_view::npos) fail("a list of numbers has no end");
    std::vector<double> values;
    for (const std::string_view each : wordsIn(text_.substr(at_, end - at_), " \t\r\n\f\v,")) {
      const auto value = numberIn<double>(each);
      if (!value) fail("'" + std::string(each.substr(0, 40)) + "' is not a number");
      values.push_back(*value);
    }
    at_ = end + 1;
    return values;
  }

  [[noreturn]] void fail(const std::string& fault) const {
    const auto line =
        1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    throw InputError(name_ + ":" + std::to_string(line) + ": " + fault);
  }

  const std::string& name_;
  std::string_view text_;
  FieldCells& field_;
  std::size_t at_ = 0;
};

}  // namespace

void readPos(const std::string& name, const std::string& content, FieldCells& field) {
  if (content.starts_with("$PostFormat"))
    throw InputError(name + ": is a view in Gmsh's old or binary form; write it as text (.pos)");
  PosReader(name, content, field).read();
}

}  // namespace af2::geometry
