#include "dsl/run/piece_text.h"

#include <fmt/format.h>

namespace af2::dsl {
namespace {

/// With the fewest digits from which the number can be restored exactly.
std::string place(const std::string& name, Point2 at) {
  return fmt::format("{} ({}, {})", name, at.x == 0 ? 0.0 : at.x, at.y == 0 ? 0.0 : at.y);
}

class Writer {
 public:
  explicit Writer(const FrontPiece& piece)
      : piece_(piece), names_(vertexNamesOf(piece)), isPlaced_(piece.vertices.size()) {}

  std::string chains() {
    std::string text;
    for (const std::vector<std::size_t>& chain : piece_.chains) {
      if (!text.empty()) text += ",\n         ";
      for (std::size_t i = 0; i < chain.size(); ++i)
        text += (i == 0 ? "" : " -> ") + vertex(chain[i]);
    }
    return text;
  }

  std::string isolated() {
    std::string text;
    for (const std::size_t v : piece_.isolated) text += (text.empty() ? "" : ", ") + vertex(v);
    return text;
  }

  std::string colours() {
    std::string text;
    for (const auto& [v, colour] : piece_.colours)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names_[v], colour ? 1 : 0);
    return text;
  }

 private:
  std::string vertex(std::size_t v) {
    if (isPlaced_[v]) return names_[v];
    isPlaced_[v] = true;
    return place(names_[v], piece_.vertices[v]);
  }

  const FrontPiece& piece_;
  std::vector<std::string> names_;
  std::vector<bool> isPlaced_;
};

std::string comment(const std::string& remark) {
  std::string text;
  for (std::size_t begin = 0; begin < remark.size();) {
    const std::size_t end = std::min(remark.find('\n', begin), remark.size());
    text += "# " + remark.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return text;
}

/// Titles come from models and rules, which may contain anything.
std::string escaped(const std::string& title) {
  std::string text;
  for (const char c : title) {
    if (c == '"' || c == '\\') text += '\\';
    text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text;
}

}  // namespace

std::vector<std::string> vertexNamesOf(const FrontPiece& piece) {
  std::vector<std::string> names(piece.vertices.size());
  names[piece.base.first] = "a";
  names[piece.base.second] = "b";
  int number = 0;
  const auto name = [&](std::size_t v) {
    if (names[v].empty()) names[v] = "p" + std::to_string(++number);
  };
  for (const std::vector<std::size_t>& chain : piece.chains)
    for (const std::size_t v : chain) name(v);
  for (const std::size_t v : piece.isolated) name(v);
  return names;
}

std::string testFileHead(const std::string& ruleFile, const std::string& ruleSet) {
  return fmt::format(
      "af2 1;\nimport \"{}\" as run;\nuse run.*;\nruleset \"extracted tests\" extends \"{}\" "
      "{{}}\n",
      escaped(ruleFile), escaped(ruleSet));
}

std::string testTextOf(const FrontPiece& piece, const PieceTest& test) {
  Writer writer(piece);
  std::string text = comment(test.remark) + "test \"" + escaped(test.title) + "\" {\n";
  text += "  front  " + writer.chains() + ";\n";
  if (const std::string points = writer.isolated(); !points.empty())
    text += "  point  " + points + ";\n";
  if (const std::string colours = writer.colours(); !colours.empty())
    text += "  colours " + colours + ";\n";
  text += "  base   a -> b;\n";
  if (piece.level != 1) text += fmt::format("  class  {};\n", piece.level);
  if (piece.size != 1) text += fmt::format("  size   {};\n", piece.size);
  return text + "  expect " + test.expectation + ";\n}\n";
}

}  // namespace af2::dsl
