#include "geometry/check/spooled_faults.h"

#include <cstdint>
#include <map>

#include "engine/base/parallel.h"
#include "geometry/check/edge_checker.h"
#include "geometry/check/element_checker.h"
#include "geometry/check/spooled_crossings.h"
#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {

namespace {

/// The mesh as far as it may be wrong: the elements along boundaries, and the faces that are not
/// sound inside.
class SuspectMesh {
 public:
  SuspectMesh(const ModelMesh& mesh, const EvidenceOfParts& evidence) {
    mesh_.vertices = mesh.vertices;
    mesh_.segments = mesh.segments;
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      const SpooledPart& part = mesh.spooled->parts()[i];
      if (evidence[i]->isSoundInside)
        addBoundary(part, evidence[i]->atBoundary);
      else
        addWhole(part);
    }
  }

  const ModelMesh& mesh() const { return mesh_; }
  /// Elements with right corners, ascending.
  const std::vector<std::size_t>& sound() const { return sound_; }

 private:
  /// Stands for all vertices inside faces that are sound. It is higher than all others.
  static constexpr std::size_t kInside = 0xfffffffeu;

  void addBoundary(const SpooledPart& part, const std::vector<Element>& elements) {
    for (Element element : elements) {
      for (VertexId& v : element.corners)
        if (!v.isNone())
          v = VertexId(v.value < part.boundary.size() ? part.boundary[v.value] : kInside);
      add(part.face, element, true);
    }
  }

  void addWhole(const SpooledPart& part) {
    const FaceBulk bulk = part.bulk->loadShape();
    const std::size_t first = mesh_.vertices.size(), boundary = part.boundary.size();
    mesh_.vertices.insert(mesh_.vertices.end(), bulk.inside.begin(), bulk.inside.end());
    for (Element element : bulk.elements) {
      const bool isSound = hasProperCorners(element, boundary + bulk.inside.size());
      for (VertexId& v : element.corners)
        if (!v.isNone())
          v = VertexId(v.value < boundary ? part.boundary[v.value] : first + v.value - boundary);
      add(part.face, element, isSound);
    }
  }

  void add(std::int32_t face, const Element& element, bool isSound) {
    if (isSound) sound_.push_back(mesh_.elements.size());
    mesh_.elements.push_back(element);
    mesh_.face.push_back(face);
  }

  ModelMesh mesh_;
  std::vector<std::size_t> sound_;
};

std::vector<MeshFinding> checkSpooled(const ModelMesh& mesh, const EvidenceOfParts& evidence,
                                      int threads) {
  Findings findings(kMaxFindings);
  std::map<int, double> areas;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    findings.take(evidence[i]->findings);
    const SpooledPart& part = mesh.spooled->parts()[i];
    if (part.bulk->counts().elements > 0) areas[part.face] += evidence[i]->area;
  }
  const SuspectMesh suspect(mesh, evidence);
  const std::vector<WantedUses> wanted = wantedUses(mesh);
  checkEdges({suspect.mesh(), wanted, suspect.sound(),
              static_cast<std::uint32_t>(suspect.mesh().vertices.size())},
             threads, findings);
  checkAreas(mesh, areas, findings);
  return findings.result();
}

}  // namespace

MeshFaults faultsOfSpooled(const ModelMesh& mesh, const EvidenceOfParts& evidence, bool mayCross,
                           int threads) {
  MeshFaults faults;
  faults.findings = checkSpooled(mesh, evidence, threads);
  if (mayCross)
    faults.crossings = spooledCrossings(mesh, evidence, [&](std::size_t count, const auto& work) {
      forEachInParallel(count, threads, work);
    });
  return faults;
}

}  // namespace af2::geometry
