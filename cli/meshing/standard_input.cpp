#include "cli/meshing/standard_input.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <vector>

#include "cli/meshing/model_formats.h"
#include "cli/program/usage_error.h"
#include "engine/base/error.h"
#include "geometry/base/words.h"

namespace af2::cli {

namespace {

/// The first lines that have words, without comments.
std::vector<std::string_view> firstLines(std::string_view text, std::size_t count) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < count) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = geometry::trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && !line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

std::string_view firstWord(std::string_view text) {
  const auto words = geometry::wordsIn(text.substr(0, 200));
  return words.empty() ? std::string_view() : words.front();
}

bool looksLikeCad(std::string_view text) {
  const std::string_view start = text.substr(0, 400);
  const std::size_t line = start.find_first_of("\r\n");
  const bool isIges = line != std::string_view::npos && line >= 73 && line <= 81 &&
                      std::string_view("SCB").find(start[72]) != std::string_view::npos;
  return has(start, "ISO-10303-21") || has(start, "CASCADE Topology V") ||
         has(start, "DBRep_DrawableShape") || isIges;
}

bool looksLikeStl(std::string_view text) {
  std::uint32_t count = 0;
  if (text.size() >= 84) std::memcpy(&count, text.data() + 80, sizeof count);
  return (text.size() >= 84 && text.size() == 84 + 50 * std::size_t{count}) ||
         (firstWord(text) == "solid" && (has(text, "facet") || has(text, "endsolid")));
}

/// Vertices, then faces.
bool looksLikeObj(std::string_view text) {
  const std::size_t vertex = text.starts_with("v ") ? 0 : text.find("\nv ");
  return vertex != std::string_view::npos && text.find("\nf ", vertex) != std::string_view::npos;
}

/// How many vertices there are, of dimension 2.
bool looksLikePoly(std::string_view text) {
  const auto lines = firstLines(text, 1);
  if (lines.empty()) return false;
  const auto words = geometry::wordsIn(lines.front().substr(0, lines.front().find('#')));
  return words.size() >= 2 && words.size() <= 4 && words[1] == "2" &&
         std::ranges::all_of(words, [](std::string_view word) {
           return geometry::numberIn<long>(word).has_value();
         });
}

struct Look {
  std::string_view extension;
  bool (*isOf)(std::string_view text);
};
/// In the order in which they are tried. The readers of CAD models tell their formats themselves.
constexpr std::array kLooks{
    Look{".cad", &looksLikeCad},
    Look{".msh", [](std::string_view text) { return firstWord(text) == "$MeshFormat"; }},
    Look{".vtu", [](std::string_view text) { return has(text.substr(0, 1000), "<VTKFile"); }},
    Look{".vtk", [](std::string_view text) { return text.starts_with("# vtk DataFile"); }},
    Look{".ply", [](std::string_view text) { return firstWord(text) == "ply"; }},
    Look{".off", [](std::string_view text) { return firstWord(text).ends_with("OFF"); }},
    Look{".stl", &looksLikeStl},
    Look{".in2d",
         [](std::string_view text) { return firstWord(text).starts_with("splinecurves2d"); }},
    Look{".obj", &looksLikeObj},
    Look{".poly", &looksLikePoly},
};

std::string readAll() {
  std::string content;
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t size = ::read(STDIN_FILENO, block.data(), block.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0)
      throw InputError(fmt::format("standard input cannot be read: {}", std::strerror(errno)));
    if (size == 0) return content;
    content.append(block.data(), static_cast<std::size_t>(size));
  }
}

std::string extensionOf(const std::string& content, const std::string& format) {
  if (!format.empty()) return "." + format;
  std::string extension = extensionByContent(content);
  if (extension.empty())
    throw InputError(fmt::format(
        "standard input: its content does not tell its format; give --format, one of {}",
        modelExtensions()));
  return extension;
}

}  // namespace

bool isStandardInput(const std::string& model) { return model == "-" || model == "/dev/stdin"; }

std::string extensionByContent(const std::string& content) {
  for (const Look& look : kLooks)
    if (look.isOf(content)) return std::string(look.extension);
  return "";
}

std::unique_ptr<TemporaryFile> takeStandardInput(const std::string& format) {
  checkModelFormat(format);
  const std::string content = readAll();
  if (content.empty()) throw InputError("standard input is empty; pipe a model into it");
  return std::make_unique<TemporaryFile>("standard_input" + extensionOf(content, format), content,
                                         "standard input");
}

}  // namespace af2::cli
