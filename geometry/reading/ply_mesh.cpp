// PLY files, text or binary. Of the properties, coordinates and corners are read.
#include "geometry/reading/formats.h"
#include "geometry/reading/number_stream.h"

namespace af2::geometry {
namespace {

struct PlyProperty {
  std::string type, countType, name;  ///< countType: of a list, else empty
};
struct PlyGroup {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

class PlyReader {
 public:
  PlyReader(const std::string& content, MeshBuilder& mesh)
      : in_(mesh.name(), content), mesh_(mesh) {}

  void read() {
    if (trimmed(in_.line()) != "ply") mesh_.fail("is not a PLY file");
    for (const PlyGroup& group : head())
      for (std::size_t i = 0; i < group.count; ++i) readOne(group);
  }

 private:
  std::vector<PlyGroup> head() {
    std::vector<PlyGroup> groups;
    for (;;) {
      const std::string_view word = in_.word("end_header");
      if (word == "end_header") break;
      if (word == "format") {
        coding_ = codingOf(in_.word("a format"));
      } else if (word == "element") {
        groups.push_back({std::string(in_.word("a name")), 0, {}});
        groups.back().count = in_.count<std::uint64_t>(Coding::Text);
      } else if (word == "property") {
        if (groups.empty()) in_.fail("a property must follow an element");
        groups.back().properties.push_back(property());
      }
      in_.line();
    }
    in_.line();
    return groups;
  }

  Coding codingOf(std::string_view format) const {
    if (format == "ascii") return Coding::Text;
    if (format == "binary_little_endian") return Coding::LowFirst;
    if (format == "binary_big_endian") return Coding::HighFirst;
    in_.fail("the format '" + std::string(format) + "' is not known");
  }

  PlyProperty property() {
    PlyProperty result;
    result.type = in_.word("a type");
    if (result.type == "list") {
      result.countType = in_.word("a type");
      result.type = in_.word("a type");
    }
    result.name = in_.word("a name");
    return result;
  }

  double scalar(const std::string& type) {
    if (coding_ == Coding::Text) return in_.number<double>(coding_);
    if (type == "double" || type == "float64") return in_.number<double>(coding_);
    if (type == "float" || type == "float32")
      return static_cast<double>(in_.number<float>(coding_));
    if (type == "int" || type == "int32") return in_.number<std::int32_t>(coding_);
    if (type == "uint" || type == "uint32") return in_.number<std::uint32_t>(coding_);
    if (type == "short" || type == "int16") return in_.number<std::int16_t>(coding_);
    if (type == "ushort" || type == "uint16") return in_.number<std::uint16_t>(coding_);
    if (type == "char" || type == "int8") return in_.number<std::int8_t>(coding_);
    if (type == "uchar" || type == "uint8") return in_.number<std::uint8_t>(coding_);
    in_.fail("numbers of type '" + type + "' are not known");
  }

  void readOne(const PlyGroup& group) {
    Point3 place;
    for (const PlyProperty& property : group.properties) {
      if (!property.countType.empty()) {
        readList(group, property);
        continue;
      }
      const double value = scalar(property.type);
      if (property.name == "x") place.x = value;
      if (property.name == "y") place.y = value;
      if (property.name == "z") place.z = value;
    }
    if (group.name == "vertex") mesh_.addVertex(place);
  }

  void readList(const PlyGroup& group, const PlyProperty& property) {
    const double count = scalar(property.countType);
    std::vector<std::uint64_t> values;
    for (double i = 0; i < count; ++i) values.push_back(vertexNumber(scalar(property.type)));
    const bool isCorners = property.name == "vertex_indices" || property.name == "vertex_index";
    if (group.name == "face" && isCorners) mesh_.addElement(values, 1);
  }

  NumberStream in_;
  MeshBuilder& mesh_;
  Coding coding_ = Coding::Text;
};

}  // namespace

void readPly(const std::string& content, MeshBuilder& mesh) { PlyReader(content, mesh).read(); }

}  // namespace af2::geometry
