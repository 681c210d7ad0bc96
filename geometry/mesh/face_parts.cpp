#include "geometry/mesh/face_parts.h"

#include <algorithm>
#include <iterator>

namespace af2::geometry {

namespace {

template <class Values>
void append(Values& all, Values&& part) {
  all.insert(all.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
}

void joinDiagnosis(FaceDiagnosis&& part, FaceDiagnosis& diagnosis) {
  append(diagnosis.places, std::move(part.places));
  diagnosis.poorness += part.poorness;
  diagnosis.isBad = diagnosis.isBad || part.isBad;
  diagnosis.hasBadAngle = diagnosis.hasBadAngle || part.hasBadAngle;
  diagnosis.hasWrongArea = diagnosis.hasWrongArea || part.hasWrongArea;
}

void joinReport(FaceReport&& part, FaceReport& report) {
  if (report.chart.empty()) report.chart = part.chart;
  report.elements += part.elements;
  append(report.stuck, std::move(part.stuck));
  report.withoutRule += part.withoutRule;
  report.layers.insert(report.layers.end(), part.layers.begin(), part.layers.end());
  report.layerElements += part.layerElements;
  append(report.oddLoops, std::move(part.oddLoops));
  if (report.triangles == 0) report.firstTriangle = part.firstTriangle;
  report.triangles += part.triangles;
  if (part.status != FaceStatus::Complete) report.status = part.status;
  if (!part.reason.empty()) report.reason += (report.reason.empty() ? "" : "; ") + part.reason;
}

/// Corners of elements: first the vertices of all boundaries, then those inside.
class Numbering {
 public:
  explicit Numbering(const std::vector<FaceMesh>& parts) {
    for (const FaceMesh& part : parts) boundaryCount_ += part.boundary.size();
  }

  /// Of the next part, whose elements are numbered by themselves.
  void number(FaceMesh& part) {
    for (Element& element : part.elements)
      for (VertexId& v : element.corners)
        if (!v.isNone())
          v = v.value < part.boundary.size()
                  ? VertexId(boundary_ + v.value)
                  : VertexId(boundaryCount_ + inside_ + v.value - part.boundary.size());
    boundary_ += part.boundary.size();
    inside_ += part.inside.size();
  }

 private:
  std::size_t boundaryCount_ = 0, boundary_ = 0, inside_ = 0;
};

}  // namespace

void joinParts(std::vector<FaceMesh> parts, FaceMesh& mesh) {
  Numbering numbering(parts);
  std::vector<double> sizesInside;
  for (FaceMesh& part : parts) {
    const auto boundaryCount = static_cast<std::ptrdiff_t>(part.boundary.size());
    numbering.number(part);
    if (!part.wantedSizes.empty()) {
      const auto inside = part.wantedSizes.begin() + boundaryCount;
      mesh.wantedSizes.insert(mesh.wantedSizes.end(), part.wantedSizes.begin(), inside);
      sizesInside.insert(sizesInside.end(), inside, part.wantedSizes.end());
    }
    append(mesh.boundary, std::move(part.boundary));
    append(mesh.inside, std::move(part.inside));
    append(mesh.elements, std::move(part.elements));
    append(mesh.origins, std::move(part.origins));
    append(mesh.middles, std::move(part.middles));
    append(mesh.uses, std::move(part.uses));
    mesh.optimizeSeconds += part.optimizeSeconds;
    mesh.searchCost += part.searchCost;
    addNew(std::move(part.history), mesh.history);
    joinDiagnosis(std::move(part.diagnosis), mesh.diagnosis);
    joinReport(std::move(part.report), mesh.report);
  }
  append(mesh.wantedSizes, std::move(sizesInside));
  if (mesh.report.status == FaceStatus::Complete) return;
  // A face is only complete with all of its parts.
  mesh.boundary.clear();
  mesh.inside.clear();
  mesh.wantedSizes.clear();
  mesh.elements.clear();
  mesh.origins.clear();
  mesh.middles.clear();
  mesh.uses.clear();
  mesh.report.elements = 0;
}

}  // namespace af2::geometry
