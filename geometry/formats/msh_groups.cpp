#include "geometry/formats/msh_groups.h"

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

Grouping groupingOf(GroupKind kind) {
  switch (kind) {
    case GroupKind::Part:
      return Grouping::Parts;
    case GroupKind::Solid:
      return Grouping::Solids;
    case GroupKind::Layer:
      return Grouping::Layers;
    case GroupKind::Color:
      return Grouping::Colors;
    case GroupKind::Interface:
      break;
  }
  return Grouping::Interfaces;
}

bool isNegative(const EdgeGroup& boundary) { return boundary.number < 0; }

}  // namespace

MshGroups::MshGroups(const ModelMesh& mesh, const Extras& extras,
                     const std::vector<MshVolume>& volumes)
    : mesh_(mesh), highestFace_(highestFace(mesh)) {
  for (const EdgeGroup& boundary : mesh.boundaries)
    highestBoundary_ = std::max(highestBoundary_, boundary.number);
  findThoseOfFaces(extras.groups);
  nameThoseOfFaces();
  nameThoseOfEdges(extras.lines);
  for (const MshVolume& volume : volumes)
    names_[{PhysicalGroup::kVolume, volume.number}] = unique(volume.name, "volume");
}

void MshGroups::findThoseOfFaces(std::span<const Grouping> order) {
  std::map<std::string, std::int32_t> byName;
  for (const FaceReport& face : mesh_.faces) {
    const bool isNamed = !face.name.empty();
    const std::int32_t own =
        isNamed ? byName.try_emplace(face.name, face.id).first->second : face.id;
    std::vector<std::int32_t>& groups = ofFace_[face.id];
    if (!order.empty()) {
      const std::int32_t only = onlyGroupOf(face, order);
      groups = {only == 0 ? own : only};
      continue;
    }
    groups = {own};
    std::int32_t number = highestFace_;
    for (const FaceGroup& group : mesh_.groups) {
      ++number;
      if (std::ranges::binary_search(group.faces, face.id)) groups.push_back(number);
    }
  }
}

/// 0: its own.
std::int32_t MshGroups::onlyGroupOf(const FaceReport& face, std::span<const Grouping> order) const {
  for (const Grouping kind : order) {
    if (kind == Grouping::Faces && !face.name.empty()) return 0;
    const FaceGroup* best = nullptr;
    for (const FaceGroup& group : mesh_.groups)
      if (groupingOf(group.kind) == kind && std::ranges::binary_search(group.faces, face.id) &&
          (!best || group.faces.size() < best->faces.size()))
        best = &group;
    if (best) return highestFace_ + 1 + static_cast<std::int32_t>(best - mesh_.groups.data());
  }
  return 0;
}

/// Only those that some face belongs to, so that others do not take their names.
void MshGroups::nameThoseOfFaces() {
  std::set<std::int32_t> used;
  for (const auto& [face, groups] : ofFace_) used.insert(groups.begin(), groups.end());
  for (const FaceReport& face : mesh_.faces) {
    if (!used.contains(face.id)) continue;
    const std::string plain = "face " + std::to_string(face.id);
    names_[{PhysicalGroup::kSurface, face.id}] =
        unique(face.name.empty() ? plain : face.name, plain);
  }
  std::int32_t number = highestFace_;
  for (const FaceGroup& group : mesh_.groups) {
    if (!used.contains(++number)) continue;
    const bool isNamed = group.kind == GroupKind::Part || group.kind == GroupKind::Layer ||
                         group.kind == GroupKind::Interface;
    const std::string kind = toString(group.kind);
    names_[{PhysicalGroup::kSurface, number}] =
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
  const auto found = ofFace_.find(face);
  return found == ofFace_.end() ? std::vector{face} : found->second;
}

std::string MshGroups::nameOf(std::int32_t face) const {
  const std::int32_t group = ofFace(face).front();
  const auto found = names_.find({PhysicalGroup::kSurface, group});
  return found == names_.end() ? "face " + std::to_string(group) : found->second;
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
