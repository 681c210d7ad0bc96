#include "geometry/io/msh_groups.h"

#include <algorithm>

namespace af2::geometry {
namespace {

std::int32_t highestFace(const ModelMesh& mesh) {
  std::int32_t highest = 0;
  for (const FaceReport& face : mesh.faces) highest = std::max(highest, face.id);
  for (const FaceGroup& group : mesh.groups)
    for (const int face : group.faces) highest = std::max(highest, face);
  return highest;
}

bool isNegative(const EdgeGroup& boundary) { return boundary.number < 0; }

}  // namespace

MshGroups::MshGroups(const ModelMesh& mesh, Lines lines, const std::vector<MshVolume>& volumes)
    : mesh_(mesh), highestFace_(highestFace(mesh)) {
  for (const EdgeGroup& boundary : mesh.boundaries)
    highestBoundary_ = std::max(highestBoundary_, boundary.number);
  nameThoseOfFaces();
  nameThoseOfEdges(lines);
  for (const MshVolume& volume : volumes)
    names_[{PhysicalGroup::kVolume, volume.number}] = unique(volume.name, "volume");
}

void MshGroups::nameThoseOfFaces() {
  for (const FaceReport& face : mesh_.faces) {
    const std::string plain = "face " + std::to_string(face.id);
    names_[{PhysicalGroup::kSurface, face.id}] =
        unique(face.name.empty() ? plain : face.name, plain);
  }
  std::int32_t number = highestFace_;
  for (const FaceGroup& group : mesh_.groups) {
    const bool isNamed = group.kind == GroupKind::Part || group.kind == GroupKind::Layer ||
                         group.kind == GroupKind::Interface;
    const std::string kind = toString(group.kind);
    names_[{PhysicalGroup::kSurface, ++number}] =
        unique(isNamed ? group.name : kind + " " + group.name, kind);
  }
}

void MshGroups::nameThoseOfEdges(Lines lines) {
  for (const EdgeGroup& boundary : mesh_.boundaries)
    names_[{PhysicalGroup::kCurve, groupOf(boundary)}] = unique(
        boundary.name.empty() ? "boundary " + shownName(boundary) : boundary.name, "boundary");
  int last = 0;
  for (const LineElement& line : lines) {
    if (line.boundary != 0 || line.edge == last) continue;
    last = line.edge;
    names_[{PhysicalGroup::kCurve, groupOfEdge(line.edge)}] =
        unique("edge " + std::to_string(line.edge), "edge");
  }
}

std::string MshGroups::unique(std::string name, const std::string& what) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < ' ' || c == '"'; }, '_');
  constexpr std::size_t kLongest = 100;  // the format allows 127, with what follows
  if (name.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
    name.resize(end);  // between characters of UTF-8
  }
  const std::string plain = name;
  for (int count = 1; !taken_.insert(name).second; ++count)
    name = plain + " (" + what + (count > 1 ? " " + std::to_string(count) : "") + ")";
  return name;
}

std::vector<std::int32_t> MshGroups::ofFace(std::int32_t face) const {
  std::vector<std::int32_t> groups{face};
  std::int32_t number = highestFace_;
  for (const FaceGroup& group : mesh_.groups) {
    ++number;
    if (std::ranges::binary_search(group.faces, face)) groups.push_back(number);
  }
  return groups;
}

std::int32_t MshGroups::of(const LineElement& line) const {
  if (line.boundary == 0) return groupOfEdge(line.edge);
  return groupOf(*std::ranges::find(mesh_.boundaries, line.boundary, &EdgeGroup::number));
}

/// Negative numbers mean something else in the format.
std::int32_t MshGroups::groupOf(const EdgeGroup& boundary) const {
  if (!isNegative(boundary)) return boundary.number;
  const auto index = &boundary - mesh_.boundaries.data();  // they come first
  return highestBoundary_ + 1 + static_cast<std::int32_t>(index);
}

std::int32_t MshGroups::groupOfEdge(int edge) const {
  const auto negative = std::ranges::count_if(mesh_.boundaries, isNegative);
  return highestBoundary_ + static_cast<std::int32_t>(negative) + edge;
}

}  // namespace af2::geometry
