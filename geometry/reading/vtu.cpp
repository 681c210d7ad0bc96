// VTK's XML format.
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <sstream>

#include "geometry/base/words.h"
#include "geometry/base/zlib_bytes.h"
#include "geometry/reading/formats.h"
#include "geometry/reading/number_stream.h"
#include "geometry/reading/vtk_cell.h"

namespace af2::geometry {
namespace {

using Tree = boost::property_tree::ptree;

/// The bytes that a base64 text stands for; stops at what is no digit.
std::string decoded(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> values;
  values.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const int value = values[static_cast<unsigned char>(c)];
    if (value < 0) break;
    group = group << 6 | static_cast<std::uint32_t>(value);
    if ((bits += 6) >= 8) bytes.push_back(static_cast<char>(group >> (bits -= 8) & 255));
  }
  return bytes;
}

class VtuReader {
 public:
  VtuReader(const Tree& file, MeshBuilder& mesh)
      : mesh_(mesh),
        coding_(file.get("<xmlattr>.byte_order", "LittleEndian") == "BigEndian" ? Coding::HighFirst
                                                                                : Coding::LowFirst),
        hasLongHeads_(file.get("<xmlattr>.header_type", "UInt32") == "UInt64") {
    const auto compressor = file.get_optional<std::string>("<xmlattr>.compressor");
    isCompressed_ = compressor.has_value();
    if (isCompressed_ && *compressor != "vtkZLibDataCompressor")
      mesh.fail("its arrays are compressed by '" + *compressor +
                "'; write it again with zlib or without compression");
  }

  /// AF2's arrays "face: NAME" have the ids of the faces with this name.
  void readFaceNames(const Tree& fields) {
    constexpr std::string_view kBefore = "face: ";
    for (const auto& [tag, array] : fields) {
      const std::string name = tag == "DataArray" ? array.get("<xmlattr>.Name", "") : "";
      if (!name.starts_with(kBefore)) continue;
      for (const double face : numbers(array, name))
        mesh_.setFaceName(idNumber(face), name.substr(kBefore.size()));
    }
  }

  void readPiece(const Tree& piece) {
    const std::size_t first = mesh_.vertexCount();
    readPoints(piece);
    const std::vector<double> corners = array(piece, "Cells", "connectivity");
    const std::vector<double> ends = array(piece, "Cells", "offsets");
    const std::vector<double> types = array(piece, "Cells", "types");
    const std::vector<double> faces = optionalArray(piece, "CellData", "face", ends.size());
    const std::vector<double> edges = optionalArray(piece, "CellData", "edge", ends.size());
    if (types.size() != ends.size()) mesh_.fail("offsets and types have different lengths");
    if (!faces.empty()) mesh_.setHasFaces();
    std::size_t begin = 0;
    std::vector<std::uint64_t> cell;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto end = static_cast<std::size_t>(vertexNumber(ends[i]));
      if (end < begin || end > corners.size())
        mesh_.fail("offset " + std::to_string(i) + " is not within the connectivity");
      cell.clear();
      for (std::size_t k = begin; k < end; ++k) cell.push_back(first + vertexNumber(corners[k]));
      addVtkCell(mesh_, idNumber(types[i]), cell, faces.empty() ? 1 : idNumber(faces[i]),
                 edges.empty() ? 0 : idNumber(edges[i]));
      begin = end;
    }
    std::vector<double> sizes =
        optionalArray(piece, "PointData", "wanted_size", mesh_.vertexCount() - first);
    if (!sizes.empty() && first == 0) mesh_.setWantedSizes(std::move(sizes));
    if (mesh_.hasField()) readPointArrays(piece, first);
  }

 private:
  void readPointArrays(const Tree& piece, std::size_t first) {
    const auto arrays = piece.get_child_optional("PointData");
    if (!arrays) return;
    for (const auto& [tag, array] : *arrays) {
      if (tag != "DataArray") continue;
      const std::string name = array.get("<xmlattr>.Name", "");
      const std::vector<double> values = numbers(array, name);
      if (values.size() == mesh_.vertexCount() - first)
        mesh_.addValues(name, first, values);
      else if (first == 0)
        mesh_.noteOtherArray(name);
    }
  }

  void readPoints(const Tree& piece) {
    const auto points = piece.get_child_optional("Points.DataArray");
    if (!points) mesh_.fail("has no array of points");
    const std::vector<double> x = numbers(*points, "Points");
    if (x.size() % 3 != 0) mesh_.fail("the points do not have three coordinates each");
    for (std::size_t i = 0; i < x.size(); i += 3) mesh_.addVertex({x[i], x[i + 1], x[i + 2]});
  }

  const Tree* find(const Tree& piece, const char* section, const std::string& name) const {
    const auto parent = piece.get_child_optional(section);
    if (!parent) return nullptr;
    for (const auto& [tag, child] : *parent)
      if (tag == "DataArray" && child.get("<xmlattr>.Name", "") == name) return &child;
    return nullptr;
  }
  std::vector<double> array(const Tree& piece, const char* section, const std::string& name) const {
    const Tree* const found = find(piece, section, name);
    if (!found) mesh_.fail("has no array '" + name + "'");
    return numbers(*found, name);
  }
  /// Empty if there is none with a value for each of `count` things.
  std::vector<double> optionalArray(const Tree& piece, const char* section, const std::string& name,
                                    std::size_t count) const {
    const Tree* const found = find(piece, section, name);
    std::vector<double> values = found ? numbers(*found, name) : std::vector<double>();
    if (values.size() != count) values.clear();
    return values;
  }

  std::vector<double> numbers(const Tree& array, const std::string& name) const {
    const std::string format = array.get("<xmlattr>.format", "ascii");
    if (format == "ascii") return textNumbers(array.data(), name);
    if (format != "binary")
      mesh_.fail("array '" + name + "' has the format '" + format +
                 "'; write the file with inline arrays, text or base64");
    const std::string type = array.get("<xmlattr>.type", "");
    const std::string bytes = isCompressed_ ? uncompressedBytes(trimmed(array.data()), name)
                                            : plainBytes(trimmed(array.data()), name);
    NumberStream stream(mesh_.name(), bytes);
    const std::uint64_t size = bytes.size();
    if (type == "Float64") return taken<double>(stream, size);
    if (type == "Float32") return taken<float>(stream, size);
    if (type == "Int64") return taken<std::int64_t>(stream, size);
    if (type == "UInt64") return taken<std::uint64_t>(stream, size);
    if (type == "Int32") return taken<std::int32_t>(stream, size);
    if (type == "UInt32") return taken<std::uint32_t>(stream, size);
    if (type == "Int16") return taken<std::int16_t>(stream, size);
    if (type == "UInt16") return taken<std::uint16_t>(stream, size);
    if (type == "Int8") return taken<std::int8_t>(stream, size);
    if (type == "UInt8") return taken<std::uint8_t>(stream, size);
    mesh_.fail("array '" + name + "' has the unknown type '" + type + "'");
  }
  std::size_t headSize() const { return hasLongHeads_ ? 8 : 4; }
  std::uint64_t headNumber(NumberStream& stream) const {
    return hasLongHeads_ ? stream.number<std::uint64_t>(coding_)
                         : stream.number<std::uint32_t>(coding_);
  }

  std::string plainBytes(std::string_view text, const std::string& name) const {
    std::string bytes = decoded(text);
    NumberStream stream(mesh_.name(), bytes);
    const std::uint64_t size = headNumber(stream);
    if (size != bytes.size() - headSize())
      mesh_.fail("array '" + name + "' is truncated or damaged: it has " +
                 std::to_string(bytes.size() - headSize()) + " bytes, and should have " +
                 std::to_string(size) + "; write the file again");
    return bytes.substr(headSize());
  }

  /// The head is encoded by itself: the number of blocks, the size of all of them but the last,
  /// that of the last one unless it is 0, and their compressed sizes.
  std::string uncompressedBytes(std::string_view text, const std::string& name) const {
    const auto damaged = [&] {
      mesh_.fail("array '" + name + "' is truncated or damaged; write the file again");
    };
    const auto digitsOf = [](std::uint64_t bytes) { return (bytes + 2) / 3 * 4; };
    const std::string first = decoded(text.substr(0, digitsOf(headSize())));
    NumberStream start(mesh_.name(), first);
    const std::uint64_t blocks = headNumber(start);
    if (blocks > text.size()) damaged();
    const std::uint64_t digits = digitsOf((3 + blocks) * headSize());
    if (digits > text.size()) damaged();
    const std::string head = decoded(text.substr(0, digits)), data = decoded(text.substr(digits));
    NumberStream stream(mesh_.name(), head);
    headNumber(stream);
    const std::uint64_t full = headNumber(stream), last = headNumber(stream);
    std::string bytes;
    std::uint64_t at = 0;
    for (std::uint64_t i = 0; i < blocks; ++i) {
      const std::uint64_t size = headNumber(stream);
      if (size > data.size() - at) damaged();
      const auto block = uncompressed(std::string_view(data).substr(at, size),
                                      i + 1 == blocks && last > 0 ? last : full);
      if (!block) damaged();
      bytes += *block;
      at += size;
    }
    return bytes;
  }

  template <class Number>
  std::vector<double> taken(NumberStream& stream, std::uint64_t bytes) const {
    std::vector<double> values;
    values.reserve(bytes / sizeof(Number));
    for (std::uint64_t i = 0; i < bytes / sizeof(Number); ++i)
      values.push_back(static_cast<double>(stream.number<Number>(coding_)));
    return values;
  }
  std::vector<double> textNumbers(const std::string& text, const std::string& name) const {
    std::vector<double> values;
    for (const std::string_view word : wordsIn(text)) {
      const auto value = numberIn<double>(word);
      if (!value) mesh_.fail("array '" + name + "': '" + std::string(word) + "' is not a number");
      values.push_back(*value);
    }
    return values;
  }

  MeshBuilder& mesh_;
  Coding coding_;
  bool hasLongHeads_;
  bool isCompressed_ = false;
};

}  // namespace

void readVtu(const std::string& content, MeshBuilder& mesh) {
  Tree tree;
  try {
    std::istringstream stream(content);
    boost::property_tree::read_xml(stream, tree);
  } catch (const boost::property_tree::xml_parser_error& error) {
    mesh.fail("is truncated, or no XML file: " + error.message() + " (line " +
              std::to_string(error.line()) + "); write the file again");
  }
  const auto file = tree.get_child_optional("VTKFile");
  const auto grid = tree.get_child_optional("VTKFile.UnstructuredGrid");
  if (!file || !grid) mesh.fail("is not an unstructured grid of VTK");
  VtuReader reader(*file, mesh);
  for (const auto& [tag, piece] : *grid)
    if (tag == "Piece")
      reader.readPiece(piece);
    else if (tag == "FieldData")
      reader.readFaceNames(piece);
}

}  // namespace af2::geometry
