#include "geometry/check/element_checker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>

#include "engine/base/parallel.h"
#include "engine/mesh/vertex_stars.h"
#include "geometry/mesh/vertex_blocks.h"

namespace af2::geometry {

namespace {

struct FacesArea {
  double area = 0;
  std::size_t elements = 0;
};

/// Complete faces of known area, by id; those that were meshed together are one.
std::map<int, FacesArea> areasOfFaces(const ModelMesh& mesh) {
  const MergedPatches patches(mesh);
  std::map<int, FacesArea> all;
  for (const FaceReport& face : mesh.faces) {
    if (face.status != FaceStatus::Complete || !(face.area > 0)) continue;
    FacesArea& some = all[patches.of(face.id)];
    some.area += face.area;
    some.elements += face.elements;
  }
  return all;
}

}  // namespace

std::uint32_t firstInside(const ModelMesh& mesh) {
  std::uint32_t first = 0;
  for (const EdgeSegment& segment : mesh.segments)
    first = std::max({first, segment.from.value + 1, segment.to.value + 1});
  return first;
}

void ElementChecker::checkElements(int threads) {
  constexpr std::size_t kAtOnce = 1 << 15;
  const Ranges ranges(mesh_.elements.size(), kAtOnce);
  takeInOrder(
      ranges.count(), threads, [&](std::size_t i) { return checked(ranges[i]); },
      [&](Part part) { take(std::move(part)); });
}

ElementChecker::Part ElementChecker::checked(
    std::ranges::iota_view<std::size_t, std::size_t> elements) const {
  Part part{findings_.none(), {}, {}, {}};
  for (const std::size_t i : elements) {
    if (part.runs.empty() || mesh_.face[i] != part.runs.back().face)
      part.runs.push_back({mesh_.face[i], 0, {}});
    if (!hasProperCorners(mesh_.elements[i], mesh_.vertices.size())) {
      addUnsound(i, part);
      continue;
    }
    part.runs.back().area += checkedArea(i, part.findings);
    noteInside(i, part);
  }
  return part;
}

void ElementChecker::take(Part part) {
  findings_.take(std::move(part.findings));
  std::ranges::copy(part.unsound, std::back_inserter(unsound_));
  std::ranges::copy(part.atSegments, std::back_inserter(atSegments_));
  for (const Run& run : part.runs) {
    areas_[patches_.of(run.face)] += run.area;
    if (runs_.empty() || runs_.back().face != run.face) {
      runs_.push_back(run);
      continue;
    }
    Range& inside = runs_.back().inside;
    inside.low = std::min(inside.low, run.inside.low);
    inside.high = std::max(inside.high, run.inside.high);
  }
}

std::optional<std::uint32_t> ElementChecker::firstInside() const {
  if (!unsound_.empty()) return std::nullopt;
  std::vector<Range> insides;
  for (const Run& run : runs_)
    if (run.inside.low <= run.inside.high) insides.push_back(run.inside);
  std::ranges::sort(insides, {}, &Range::low);
  const auto meet = [](const Range& a, const Range& b) { return a.high >= b.low; };
  if (std::ranges::adjacent_find(insides, meet) != insides.end()) return std::nullopt;
  return firstInside_;
}

std::vector<std::size_t> ElementChecker::sound() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < mesh_.elements.size(); ++i)
    if (!std::ranges::binary_search(unsound_, i)) all.push_back(i);
  return all;
}

bool ElementChecker::areSurrounded(std::uint32_t first, int threads) const {
  const VertexBlocks blocks(mesh_.vertices.size(), mesh_.elements, threads);
  std::atomic<bool> areAll = true;
  forEachInParallel(blocks.count(), threads, [&](std::size_t block) {
    const std::size_t end = blocks[block].end,
                      begin = std::max<std::size_t>(first, blocks[block].begin);
    if (begin >= end || !areAll) return;
    VertexStars stars(begin, end);
    blocks.forEachElementAt(block, [&](std::size_t i) { stars.add(mesh_.elements[i]); });
    stars.finish();
    for (std::size_t v = begin; v < end; ++v)
      if (!stars.isEmpty(v) && !stars.areAround(v)) areAll = false;
  });
  return areAll;
}

void ElementChecker::addUnsound(std::size_t i, Part& part) const {
  part.unsound.push_back(i);
  for (const VertexId v : mesh_.elements[i].vertices())
    if (v.value >= mesh_.vertices.size())
      return part.findings.add({mesh_.face[i], "an element has a corner that is not a vertex", {}});
  std::array<VertexId, 4> corners = mesh_.elements[i].corners;
  std::ranges::sort(corners);
  const VertexId twice = *std::ranges::adjacent_find(corners);
  part.findings.add({mesh_.face[i], "an element has a corner twice", position(twice)});
}

double ElementChecker::checkedArea(std::size_t i, Findings& findings) const {
  const auto& [a, b, c, d] = mesh_.elements[i].corners;
  const Point3& origin = position(a);
  const Point3 diagonal = position(c) - origin;
  Point3 sum = cross(position(b) - origin, diagonal);
  if (!d.isNone()) sum = sum + cross(diagonal, position(d) - origin);
  const double area = length(sum) / 2;
  if (!(area > 0)) findings.add({mesh_.face[i], "an element has no area", origin});
  return area;
}

void ElementChecker::noteInside(std::size_t i, Part& part) const {
  int others = 0;
  for (const VertexId v : mesh_.elements[i].vertices()) {
    if (v.value < firstInside_) {
      ++others;
      continue;
    }
    Range& inside = part.runs.back().inside;
    inside.low = std::min(inside.low, v.value);
    inside.high = std::max(inside.high, v.value);
  }
  if (others > 1) part.atSegments.push_back(i);
}

void checkAreas(const ModelMesh& mesh, std::map<int, double> areas, Findings& findings) {
  for (const auto& [id, face] : areasOfFaces(mesh)) {
    const double ratio = areas[id] / face.area;
    if (!isWrongArea(ratio, face.elements)) continue;
    findings.add(
        {id, "the elements have " + std::to_string(ratio) + " times the area of the face", {}});
  }
}

}  // namespace af2::geometry
