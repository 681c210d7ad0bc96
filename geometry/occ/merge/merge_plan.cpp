#include "geometry/occ/merge/merge_plan.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <limits>

#include "engine/base/error.h"
#include "geometry/base/constants.h"
#include "geometry/meshing/part_sizes.h"
#include "geometry/occ/merge/background.h"
#include "geometry/occ/merge/face_grouping.h"
#include "geometry/occ/merge/straight_chains.h"

namespace af2::geometry {

namespace {

/// How far background triangles may be from their face, as a share of the wanted size.
constexpr double kDeflection = 4e-3;
/// A front cannot start from a boundary that is shorter than this, squared, compared with the area.
constexpr double kLeastBoundary = 1.5;

class Planner {
 public:
  explicit Planner(PlanInput input)
      : in_(std::move(input)),
        grouping_{*in_.model,
                  in_.joints,
                  in_.areas,
                  in_.lengths,
                  {},
                  {},
                  {},
                  in_.mayMerge,
                  {},
                  {},
                  in_.request.angle * kDegree} {
    const auto faces = in_.areas.size();
    for (std::size_t f = 0; f < faces; ++f) {
      const int face = static_cast<int>(f) + 1;
      const double size = wantedOnFace(in_.sizes, face), chord = chordOnFace(in_.sizes, face);
      grouping_.sizes.push_back(size);
      grouping_.chords.push_back(chord);
      grouping_.narrow.push_back(std::min(in_.request.narrow * size, 2 * chord));
    }
    grouping_.part.assign(faces, 0);
    for (const auto& [face, part] : in_.part) {
      grouping_.part[static_cast<std::size_t>(face) - 1] = part;
      parts_ = std::max(parts_, part);
    }
    for (std::size_t e = 0; e < in_.joints.size(); ++e) {
      const int id = static_cast<int>(e) + 1;
      grouping_.isKept.push_back(in_.keptEdges.contains(id) || in_.request.keptEdges.contains(id));
    }
    for (const auto& [face, why] : in_.givenUp) giveUp(face, why);
  }

  MergePlan plan() {
    // Each round gives up a face at least, or cuts a group.
    const std::size_t most = 4 * in_.areas.size() + 4;
    for (std::size_t round = 0; round < most && !in_.stop.stop_requested(); ++round)
      if (tryToPlan()) return std::move(plan_);
    return {};
  }

 private:
  void giveUp(int face, const std::string& why) {
    grouping_.mayMerge[static_cast<std::size_t>(face) - 1] = false;
    kept_[face] = why;
  }

  /// Returns false if something has changed, so that the plan is to be made anew.
  bool tryToPlan() {
    plan_ = {};
    const FaceGrouping groups = groupFaces(grouping_);
    plan_.edges.chains = straightChains(grouping_, groups);
    const std::map<std::uint32_t, std::vector<int>> members = membersOf(groups);
    findRemoved(groups, members);
    if (!findBackground(members)) return false;
    std::map<int, std::vector<std::uint32_t>> triangles;
    for (std::uint32_t t = 0; t < background_.face.size(); ++t)
      triangles[background_.face[t]].push_back(t);
    for (const auto& [group, faces] : members)
      if (!addQuilt(groups, faces, triangles)) return false;
    findVertices();
    plan_.kept = kept_;
    return true;
  }

  /// The groups that are meshed as quilts, by their first face.
  std::map<std::uint32_t, std::vector<int>> membersOf(const FaceGrouping& groups) const {
    std::map<std::uint32_t, std::vector<int>> members;
    for (std::size_t f = 0; f < groups.group.size(); ++f)
      members[groups.group[f]].push_back(static_cast<int>(f) + 1);
    std::set<std::uint32_t> atChains;
    for (const EdgeChain& chain : plan_.edges.chains)
      for (const ChainLink& link : chain.links)
        for (const int face : in_.model->facesOfEdges[static_cast<std::size_t>(link.edge) - 1])
          atChains.insert(groups.group[static_cast<std::size_t>(face) - 1]);
    std::erase_if(members, [&](const auto& group) {
      return group.second.size() == 1 && !atChains.contains(group.first);
    });
    return members;
  }

  void findRemoved(const FaceGrouping& groups,
                   const std::map<std::uint32_t, std::vector<int>>& members) {
    plan_.edges.isRemoved.assign(in_.joints.size(), false);
    for (std::size_t e = 0; e < in_.joints.size(); ++e) {
      if (!groups.isInner[e]) continue;
      const auto face = static_cast<std::size_t>(in_.joints[e].one) - 1;
      if (!members.contains(groups.group[face])) continue;
      plan_.edges.isRemoved[e] = true;
      if (groups.isBesideNarrow[e]) plan_.besideNarrow.push_back(static_cast<int>(e) + 1);
    }
    for (const auto& [group, faces] : members)
      for (const int face : faces)
        if (faces.size() > 1 && isNarrow(face)) plan_.edges.narrowFaces.insert(face);
  }

  bool isNarrow(int face) const {
    const auto f = static_cast<std::size_t>(face) - 1;
    double around = 0;
    for (const EdgeUse& use : in_.model->edgesOfFaces[f])
      around += in_.lengths[static_cast<std::size_t>(use.id) - 1];
    return 2 * in_.areas[f] < grouping_.narrow[f] * around;
  }

  bool findBackground(const std::map<std::uint32_t, std::vector<int>>& members) {
    std::vector<int> faces;
    for (const auto& [group, own] : members) faces.insert(faces.end(), own.begin(), own.end());
    std::ranges::sort(faces);
    if (!std::ranges::includes(triangulated_, faces)) {
      double size = std::numeric_limits<double>::infinity();
      for (const int face : faces)
        size = std::min(size, grouping_.sizes[static_cast<std::size_t>(face) - 1]);
      background_ = backgroundOf(*in_.model, faces, kDeflection * size);
      triangulated_ = faces;
    }
    bool isComplete = true;
    for (const int face : faces) {
      if (!background_.failed.contains(face)) continue;
      giveUp(face, "OpenCASCADE could not triangulate it");
      isComplete = false;
    }
    return isComplete;
  }

  bool addQuilt(const FaceGrouping& groups, const std::vector<int>& faces,
                const std::map<int, std::vector<std::uint32_t>>& byFace) {
    Quilt quilt;
    std::vector<std::uint32_t> triangles;
    for (const int face : faces) {
      const std::vector<std::uint32_t>& own = byFace.at(face);
      triangles.insert(triangles.end(), own.begin(), own.end());
      quilt.area += in_.areas[static_cast<std::size_t>(face) - 1];
    }
    try {
      quilt.boundary =
          loopsAround(background_, triangles, plan_.edges.isRemoved, plan_.edges.chains);
    } catch (const GeometryError& fault) {
      for (const int face : faces) giveUp(face, fault.what());
      return false;
    }
    const auto loops = static_cast<int>(quilt.boundary.loops.size());
    const double square = quilt.boundary.length * quilt.boundary.length;
    if (loops == 0 || quilt.boundary.euler != 2 - loops || square < kLeastBoundary * quilt.area) {
      cut(groups, faces);
      return false;
    }
    number(triangles, quilt.boundary);
    quilt.parts = std::make_shared<const QuiltParts>(
        quiltPartsOf(in_.model, background_, triangles, faces, groups));
    for (const int face : faces) plan_.quiltOf[face] = plan_.quilts.size();
    plan_.quilts.push_back(std::move(quilt));
    return true;
  }

  /// From triangles of the background to those of the quilt.
  static void number(const std::vector<std::uint32_t>& triangles, QuiltLoops& boundary) {
    std::map<std::uint32_t, std::uint32_t> ids;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) ids[triangles[i]] = i;
    for (std::vector<QuiltUse>& loop : boundary.loops)
      for (QuiltUse& use : loop)
        for (std::uint32_t& t : use.triangles) t = ids.at(t);
  }

  /// Cuts a group without enough of a boundary into two parts of about the same area.
  void cut(const FaceGrouping& groups, const std::vector<int>& faces) {
    if (faces.size() == 1) {
      giveUp(faces.front(), "it has no boundary from which it could be meshed");
      return;
    }
    const std::vector<int> half = halfOf(faces, in_.areas, in_.joints, groups.isInner);
    ++parts_;
    for (const int face : half) grouping_.part[static_cast<std::size_t>(face) - 1] = parts_;
  }

  /// Those at which no followed edge ends, and those inside chains.
  void findVertices() {
    std::map<int, bool> isFollowed;
    const auto note = [&](const TopoDS_Vertex& vertex, bool followed) {
      if (!vertex.IsNull()) isFollowed[in_.model->vertices.FindIndex(vertex)] |= followed;
    };
    std::set<int> inChains;
    for (const EdgeChain& chain : plan_.edges.chains)
      for (const ChainLink& link : chain.links) inChains.insert(link.edge);
    for (std::size_t e = 0; e < in_.joints.size(); ++e) {
      const int id = static_cast<int>(e) + 1;
      const TopoDS_Edge edge = TopoDS::Edge(in_.model->edge(id).Oriented(TopAbs_FORWARD));
      const bool followed =
          !plan_.edges.isRemoved[e] && !inChains.contains(id) && !BRep_Tool::Degenerated(edge);
      note(TopExp::FirstVertex(edge), followed);
      note(TopExp::LastVertex(edge), followed);
    }
    for (const EdgeChain& chain : plan_.edges.chains) {
      const auto endOf = [&](const ChainLink& link, bool start) {
        const TopoDS_Edge edge = TopoDS::Edge(in_.model->edge(link.edge).Oriented(TopAbs_FORWARD));
        return start != link.isReversed ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
      };
      note(endOf(chain.links.front(), true), true);
      note(endOf(chain.links.back(), false), true);
    }
    for (const auto& [vertex, followed] : isFollowed)
      if (!followed) plan_.vertices.push_back(vertex);
  }

  PlanInput in_;
  GroupingInput grouping_;
  MergePlan plan_;
  BackgroundFacets background_;
  std::vector<int> triangulated_;
  std::map<int, std::string> kept_;
  int parts_ = 0;
};

}  // namespace

MergePlan planMerging(PlanInput input) { return Planner(std::move(input)).plan(); }

std::vector<int> halfOf(const std::vector<int>& group, const std::vector<double>& areas,
                        const std::vector<EdgeJoint>& joints, const std::vector<bool>& isInner) {
  std::map<int, std::set<int>> beside;
  for (std::size_t e = 0; e < joints.size(); ++e) {
    if (e >= isInner.size() || !isInner[e] || joints[e].isSeam()) continue;
    beside[joints[e].one].insert(joints[e].other);
    beside[joints[e].other].insert(joints[e].one);
  }
  const auto areaOf = [&](int face) { return areas[static_cast<std::size_t>(face) - 1]; };
  double whole = 0;
  for (const int face : group) whole += areaOf(face);
  std::vector<int> half{group.front()};
  std::set<int> isIn{group.front()};
  double area = areaOf(group.front());
  for (std::size_t i = 0; i < half.size() && area < whole / 2; ++i)
    for (const int next : beside[half[i]]) {
      if (area >= whole / 2 || half.size() + 1 == group.size()) break;
      if (!isIn.insert(next).second) continue;
      half.push_back(next);
      area += areaOf(next);
    }
  return half;
}

}  // namespace af2::geometry
