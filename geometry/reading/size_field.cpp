#include "geometry/reading/size_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/base/words.h"
#include "geometry/reading/formats.h"

namespace af2::geometry {
namespace {

std::string namesOf(const FieldCells& field) {
  std::vector<std::string_view> names;
  for (const auto& [name, values] : field.arrays) names.push_back(name);
  std::string text = names.empty() ? "it has no array with one number for each vertex"
                                   : "there is " + listed(names, "and");
  if (!field.others.empty())
    text += "; " + listed({field.others.begin(), field.others.end()}, "and") + " cannot be used";
  return text;
}

FieldCells fieldIn(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file), content = contentOf(file);
  if (content.empty()) throw InputError(file.string() + ": is empty");
  FieldCells field;
  if (extension == ".pos") {
    readPos(file.string(), content, field);
    return field;
  }
  MeshBuilder mesh(file.string(), &field);
  if (extension == ".msh" || extension == ".msh2")
    readMsh(content, mesh);
  else if (extension == ".vtu")
    readVtu(content, mesh);
  else
    throw InputError(file.string() +
                     ": is not a field that AF2 reads; give an .msh, .pos or .vtu file");
  mesh.finishField();
  return field;
}

const std::vector<double>& chosenArray(const SizeFieldName& name, const FieldCells& field) {
  const auto& arrays = field.arrays;
  if (name.array.empty()) {
    if (arrays.size() == 1) return arrays.begin()->second;
    throw InputError(name.file.string() + ": " + namesOf(field) +
                     (arrays.empty() ? "" : "; name one of them, as FILE:ARRAY"));
  }
  const auto found = arrays.find(name.array);
  if (found == arrays.end())
    throw InputError(name.file.string() + ": has no array '" + name.array + "'; " + namesOf(field));
  return found->second;
}

/// One vertex for each place, with the smallest size there: cells of views do not share theirs.
class FieldVertices {
 public:
  FieldVertices(const FieldCells& field, const std::vector<double>& values) {
    std::vector<std::uint32_t> order(field.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t v) {
      const Point3& p = field.vertices[v];
      return std::tuple(p.x, p.y, p.z);
    };
    std::ranges::stable_sort(order, {}, key);
    number_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::uint32_t v = order[i];
      const double size = v < values.size() ? values[v] : FieldCells::kMissing;
      if (i == 0 || key(v) != key(order[i - 1])) {
        cells.vertices.push_back(field.vertices[v]);
        cells.sizes.push_back(size);
      } else if (!(size >= cells.sizes.back())) {
        cells.sizes.back() = std::isnan(size) ? cells.sizes.back() : size;
      }
      number_[v] = static_cast<std::uint32_t>(cells.vertices.size() - 1);
    }
  }

  /// Unless a vertex has no value.
  void add(const std::array<std::uint64_t, 4>& corners) {
    std::array<std::uint32_t, 4> cell;
    cell.fill(SizeCells::kNone);
    for (std::size_t i = 0; i < 4; ++i) {
      if (corners[i] == FieldCells::kNoCorner) continue;
      cell[i] = number_[corners[i]];
      if (std::isnan(cells.sizes[cell[i]])) return;
    }
    cells.cells.push_back(cell);
  }

  SizeCells cells;

 private:
  std::vector<std::uint32_t> number_;
};

/// Those that no cell has may have any value, or none.
void dropUnused(SizeCells& cells) {
  std::vector<std::uint32_t> number(cells.vertices.size(), SizeCells::kNone);
  SizeCells kept;
  for (auto& cell : cells.cells)
    for (std::uint32_t& v : cell) {
      if (v == SizeCells::kNone) continue;
      if (number[v] == SizeCells::kNone) {
        number[v] = static_cast<std::uint32_t>(kept.vertices.size());
        kept.vertices.push_back(cells.vertices[v]);
        kept.sizes.push_back(cells.sizes[v]);
      }
      v = number[v];
    }
  cells.vertices = std::move(kept.vertices);
  cells.sizes = std::move(kept.sizes);
}

}  // namespace

SizeFieldName sizeFieldName(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::error_code ignored;
  if (colon == std::string::npos || std::filesystem::exists(text, ignored)) return {text, ""};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

SizeCells readSizeField(const SizeFieldName& name) {
  const FieldCells field = fieldIn(name.file);
  FieldVertices merged(field, chosenArray(name, field));
  for (const auto& corners : field.cells) merged.add(corners);
  SizeCells cells = std::move(merged.cells);
  dropUnused(cells);
  if (cells.cells.empty())
    throw InputError(name.file.string() + ": the array has no value at the vertices of any cell");
  try {
    checkCells(cells);
  } catch (const InputError& error) {
    throw InputError(name.file.string() + ": " + error.what());
  }
  return cells;
}

}  // namespace af2::geometry
