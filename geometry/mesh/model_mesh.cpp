#include "geometry/mesh/model_mesh.h"

#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {

namespace {

MeshSlice wholeOf(const ModelMesh& mesh) {
  return {0,           0,        mesh.vertices, mesh.wantedSizes, mesh.elements, mesh.origins,
          mesh.scores, mesh.face};
}

SpooledMesh::Shared sharedOf(const ModelMesh& mesh) { return {mesh.vertices, mesh.wantedSizes}; }

void visitRuns(const MeshSlice& slice, const std::function<void(const ElementRun&)>& visit) {
  ElementRun run;
  for (std::size_t e = 0; e < slice.elements.size(); ++e) {
    const std::int32_t face = slice.face(e);
    const bool isQuad = slice.elements[e].isQuad();
    if (run.count > 0 && (run.face != face || run.areQuads != isQuad))
      visit(std::exchange(run, {}));
    run = {face, isQuad, run.count + 1};
  }
  if (run.count > 0) visit(run);
}

}  // namespace

std::size_t vertexCount(const ModelMesh& mesh) {
  return mesh.spooled ? mesh.spooled->vertexCount() : mesh.vertices.size();
}

std::size_t elementCount(const ModelMesh& mesh) {
  return mesh.spooled ? mesh.spooled->elementCount() : mesh.elements.size();
}

std::size_t quadCount(const ModelMesh& mesh) {
  return mesh.spooled
             ? mesh.spooled->quadCount()
             : static_cast<std::size_t>(std::ranges::count_if(mesh.elements, &Element::isQuad));
}

bool hasScores(const ModelMesh& mesh) {
  if (!mesh.spooled) return !mesh.scores.empty();
  return !mesh.spooled->parts().empty() && mesh.spooled->parts().front().scores;
}

void forEachSlice(const ModelMesh& mesh, const SliceVisit& visit) {
  if (mesh.spooled)
    mesh.spooled->visitAll(sharedOf(mesh), visit);
  else
    visit(wholeOf(mesh));
}

void visitSliceOf(const ModelMesh& mesh, std::size_t element, const SliceVisit& visit) {
  if (mesh.spooled)
    mesh.spooled->visitPart(mesh.spooled->partOf(element), sharedOf(mesh), visit);
  else
    visit(wholeOf(mesh));
}

void forEachRun(const ModelMesh& mesh, const std::function<void(const ElementRun&)>& visit) {
  if (!mesh.spooled) return visitRuns(wholeOf(mesh), visit);
  for (std::size_t i = 0; i < mesh.spooled->parts().size(); ++i) {
    const SpooledPart& part = mesh.spooled->parts()[i];
    const std::size_t elements = part.bulk->counts().elements, quads = part.bulk->counts().quads;
    if (quads > 0 && quads < elements)
      mesh.spooled->visitPart(i, sharedOf(mesh),
                              [&](const MeshSlice& slice) { visitRuns(slice, visit); });
    else if (elements > 0)
      visit({part.face, quads > 0, elements});
  }
}

std::vector<FaceElements> elementsByFace(const ModelMesh& mesh) {
  std::vector<FaceElements> all;
  const auto add = [&](std::int32_t face, std::size_t first, std::size_t last) {
    if (first == last) return;
    if (!all.empty() && all.back().face == face)
      all.back().last = last;
    else
      all.push_back({face, first, last});
  };
  if (!mesh.spooled)
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      add(e < mesh.face.size() ? mesh.face[e] : 0, e, e + 1);
  else
    for (std::size_t i = 0; i < mesh.spooled->parts().size(); ++i)
      add(mesh.spooled->parts()[i].face, mesh.spooled->firstElement(i),
          mesh.spooled->firstElement(i + 1));
  return all;
}

}  // namespace af2::geometry
