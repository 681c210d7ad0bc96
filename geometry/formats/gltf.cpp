// glTF 2.0, binary (.glb), for viewers: a node for each face, group of edges, and for the sides of
// elements, below one that turns the model upright. Positions have single precision, relative to
// the middle of the mesh.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "geometry/base/box_tree.h"
#include "geometry/formats/group_members.h"
#include "geometry/io/formats.h"
#include "geometry/mesh/triangles_of.h"

namespace af2::geometry {
namespace {

using GltfJson = nlohmann::ordered_json;

constexpr int kFloats = 5126, kUnsignedIntegers = 5125;     // types of components
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;  // targets of views
constexpr int kGltfLines = 1, kGltfTriangles = 4;           // modes of primitives

/// The format's unit is the metre.
double metresIn(const std::string& unit) {
  static const std::map<std::string, double> kMetres{
      {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"um", 1e-6}, {"inch", 0.0254}, {"ft", 0.3048}};
  const auto found = kMetres.find(unit);
  return found == kMetres.end() ? 1 : found->second;
}

/// A component of a colour as files of models have it, between 0 and 255, as the format wants it.
double linear(int component) {
  const double c = component / 255.;
  return c <= 0.04045 ? c / 12.92 : power((c + 0.055) / 1.055, 2.4);
}

GltfJson materialOf(const std::string& name, const std::array<int, 3>& color) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {linear(color[0]), linear(color[1]), linear(color[2]), 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", 0.7}}},
          {"doubleSided", true}};
}

/// "#rrggbb".
std::array<int, 3> colorOf(const std::string& name) {
  const auto at = [&](std::size_t i) { return std::stoi(name.substr(i, 2), nullptr, 16); };
  return {at(1), at(3), at(5)};
}

class GltfWriter {
 public:
  GltfWriter(const ModelMesh& mesh, const Extras& extras)
      : mesh_(mesh), extras_(extras), groups_(mesh, extras, {}) {
    for (const Point3& p : cornerVertices(mesh)) box_.add(p);
    if (!cornerVertices(mesh).empty()) middle_ = 0.5 * (box_.low + box_.high);
  }

  void write(OutputFile& file) {
    addFaces();
    addLines();
    addSides();
    const std::string json = head();
    const std::size_t positions = 3 * sizeof(float) * cornerVertices(mesh_).size();
    const std::size_t bytes = positions + sizeof(std::uint32_t) * indices_.size();
    const std::size_t size = 12 + 8 + json.size() + (bytes > 0 ? 8 + bytes : 0);
    if (size > std::numeric_limits<std::uint32_t>::max())
      throw InputError("cannot write a glTF file: it would have more than 4 GiB");
    file.text("glTF");
    for (const std::size_t number : {std::size_t{2}, size, json.size()})
      file.binary(static_cast<std::uint32_t>(number));
    file.text("JSON" + json);
    if (bytes == 0) return;
    file.binary(static_cast<std::uint32_t>(bytes));
    file.text(std::string_view("BIN\0", 4));
    for (const Point3& p : cornerVertices(mesh_))
      for (const double x : {p.x - middle_.x, p.y - middle_.y, p.z - middle_.z})
        file.binary(static_cast<float>(x));
    for (const std::uint32_t index : indices_) file.binary(index);
  }

 private:
  /// What is added to indices_ from `first` on becomes a node.
  void addNode(const std::string& name, std::size_t first, int mode, std::size_t material,
               GltfJson extras) {
    if (indices_.size() == first) return;
    accessors_.push_back({{"bufferView", 1},
                          {"byteOffset", sizeof(std::uint32_t) * first},
                          {"componentType", kUnsignedIntegers},
                          {"count", indices_.size() - first},
                          {"type", "SCALAR"}});
    const GltfJson primitive{{"attributes", {{"POSITION", 0}}},
                             {"indices", accessors_.size()},
                             {"mode", mode},
                             {"material", material}};
    meshes_.push_back({{"primitives", GltfJson::array({primitive})}});
    nodes_.push_back({{"name", name}, {"mesh", meshes_.size() - 1}});
    if (!extras.is_null()) nodes_.back()["extras"] = std::move(extras);
  }

  void addFaces() {
    std::map<std::int32_t, std::vector<std::size_t>> elements;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) elements[mesh_.face[e]].push_back(e);
    for (const auto& [face, own] : elements) {
      const std::size_t first = indices_.size();
      for (const std::size_t e : own)
        for (const auto& triangle : trianglesOf(mesh_, mesh_.elements[e]))
          for (const VertexId corner : triangle) indices_.push_back(corner.value);
      GltfJson names = GltfJson::array();
      for (const std::int32_t group : groups_.ofFace(face)) names.push_back(nameOf(group));
      addNode(groups_.nameOf(face), first, kGltfTriangles, materialOfFace(face),
              {{"face", face}, {"groups", names}});
    }
  }

  void addLines() {
    for (const GroupMembers& group : groupMembers(mesh_, extras_.lines, groups_)) {
      if (group.group.dimension != PhysicalGroup::kCurve) continue;
      const std::size_t first = indices_.size();
      for (const std::uint32_t i : group.members)
        for (const VertexId end : {extras_.lines[i].from, extras_.lines[i].to})
          indices_.push_back(end.value);
      addNode(group.name, first, kGltfLines, material("lines", {160, 0, 0}), nullptr);
    }
  }

  /// Each side once.
  void addSides() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const Element& element : mesh_.elements) {
      const auto corners = element.vertices();
      for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back(std::minmax(corners[i].value, corners[(i + 1) % corners.size()].value));
    }
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    const std::size_t first = indices_.size();
    for (const auto& [from, to] : sides) {
      indices_.push_back(from);
      indices_.push_back(to);
    }
    addNode("sides of elements", first, kGltfLines, material("sides", {40, 40, 40}), nullptr);
  }

  std::string nameOf(std::int32_t group) const {
    const auto found = groups_.names().find({PhysicalGroup::kSurface, group});
    return found == groups_.names().end() ? "face " + std::to_string(group) : found->second;
  }

  /// Of the colour that the model gives it.
  std::size_t materialOfFace(std::int32_t face) {
    for (const FaceGroup& group : mesh_.groups)
      if (group.kind == GroupKind::Color && std::ranges::binary_search(group.faces, face))
        return material(group.name, colorOf(group.name));
    return material("no colour", {190, 190, 190});
  }

  std::size_t material(const std::string& name, const std::array<int, 3>& color) {
    const auto [found, isNew] = materialOf_.try_emplace(name, materials_.size());
    if (isNew) materials_.push_back(materialOf(name, color));
    return found->second;
  }

  /// From x, y, z with z upwards to the format's axes with y upwards.
  GltfJson root() const {
    const double s = metresIn(mesh_.unit);
    GltfJson children = GltfJson::array();
    for (std::size_t node = 1; node <= nodes_.size(); ++node) children.push_back(node);
    GltfJson root{
        {"name", mesh_.name.empty() ? "mesh" : mesh_.name},
        {"matrix",
         {s, 0, 0, 0, 0, 0, -s, 0, 0, s, 0, 0, s * middle_.x, s * middle_.z, -s * middle_.y, 1}}};
    if (!children.empty()) root["children"] = children;
    return root;
  }

  static GltfJson view(std::size_t offset, std::size_t length, int target) {
    return {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}, {"target", target}};
  }

  std::string head() const {
    const std::size_t positions = 3 * sizeof(float) * cornerVertices(mesh_).size();
    const std::size_t indices = sizeof(std::uint32_t) * indices_.size();
    GltfJson nodes = GltfJson::array({root()});
    nodes.insert(nodes.end(), nodes_.begin(), nodes_.end());
    GltfJson json{{"asset", {{"version", "2.0"}, {"generator", "AF2"}}},
                  {"scene", 0},
                  {"scenes", GltfJson::array({{{"nodes", GltfJson::array({0})}}})},
                  {"nodes", nodes}};
    if (!nodes_.empty()) {
      GltfJson accessors = GltfJson::array({positionAccessor()});
      accessors.insert(accessors.end(), accessors_.begin(), accessors_.end());
      json["meshes"] = meshes_;
      json["materials"] = materials_;
      json["accessors"] = accessors;
      json["bufferViews"] = GltfJson::array(
          {view(0, positions, kVertexBuffer), view(positions, indices, kIndexBuffer)});
      json["buffers"] = GltfJson::array({{{"byteLength", positions + indices}}});
    }
    std::string text = json.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    return text;
  }

  /// The bounds are those of the rounded positions, as the format demands.
  GltfJson positionAccessor() const {
    const auto corner = [&](const Point3& p) {
      GltfJson rounded = GltfJson::array();
      for (const double x : {p.x - middle_.x, p.y - middle_.y, p.z - middle_.z})
        rounded.push_back(static_cast<float>(x));
      return rounded;
    };
    return {{"bufferView", 0}, {"componentType", kFloats}, {"count", cornerVertices(mesh_).size()},
            {"type", "VEC3"},  {"min", corner(box_.low)},  {"max", corner(box_.high)}};
  }

  const ModelMesh& mesh_;
  const Extras& extras_;
  MshGroups groups_;
  Box3 box_;
  Point3 middle_{};
  std::vector<std::uint32_t> indices_;
  std::map<std::string, std::size_t> materialOf_;
  GltfJson materials_ = GltfJson::array(), accessors_ = GltfJson::array(),
           meshes_ = GltfJson::array(), nodes_ = GltfJson::array();
};

}  // namespace

void writeGltf(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  GltfWriter(mesh, extras).write(file);
}

}  // namespace af2::geometry
