#include "geometry/check/face_evidence.h"

#include <algorithm>

#include "geometry/check/element_checker.h"
#include "geometry/check/sound_faces.h"

namespace af2::geometry {

namespace {

/// Whether all corners are vertices; if not, elements have no places at which they could cross.
bool hasVerticesOnly(const ModelMesh& face) {
  return std::ranges::all_of(face.elements, [&](const Element& element) {
    return std::ranges::all_of(element.vertices(),
                               [&](VertexId v) { return v.value < face.vertices.size(); });
  });
}

void addShapes(const ModelMesh& face, FaceEvidence& evidence) {
  const PatchOutlines outlines(face, kOneByOne);
  evidence.patch = outlines.patch(0, face.elements.size());
  const auto first = face.elements.front().vertices();
  for (std::size_t i = 0; i < first.size(); ++i)
    evidence.firstCorners[i] = face.vertices[first[i].value];
  evidence.canBeDrawn = outlines.canBeDrawn(evidence.patch);
  if (evidence.canBeDrawn) return;
  const OutlinedPatch* const patch = &evidence.patch;
  evidence.isStarShaped = outlines.isStarShaped({&patch, 1});
}

}  // namespace

FaceEvidence evidenceOf(const ModelMesh& face, std::size_t boundary, bool mayCross) {
  FaceEvidence evidence;
  if (face.elements.empty()) return evidence;
  Findings findings(kMaxFindings);
  ElementChecker elements(face, static_cast<std::uint32_t>(boundary), findings);
  elements.checkElements(1);
  evidence.findings = findings.result();
  evidence.area = elements.areas().begin()->second;
  evidence.isSoundInside =
      elements.firstInside() && elements.areSurrounded(static_cast<std::uint32_t>(boundary), 1);
  if (evidence.isSoundInside)
    for (const std::size_t i : elements.atSegments())
      evidence.atBoundary.push_back(face.elements[i]);
  if (mayCross && hasVerticesOnly(face)) addShapes(face, evidence);
  return evidence;
}

}  // namespace af2::geometry
