#include "geometry/domain/domain_defects.h"

#include <algorithm>

#include "geometry/base/constants.h"
#include "geometry/domain/points_on_curve.h"

namespace af2::geometry {

namespace {

Point3 middleOf(const DomainCurve& curve) {
  return curve.pointAt((curve.knots.front() + curve.knots.back()) / 2);
}

Defect defectOf(DefectKind kind, const DomainCurve& curve, double extent) {
  Defect defect;
  defect.kind = kind;
  defect.edge = curve.id;
  defect.extent = extent;
  defect.place = middleOf(curve);
  return defect;
}

}  // namespace

std::vector<Defect> findDefects(const DomainModel& model, double size) {
  std::vector<Defect> defects;
  std::vector<double> lengths;
  for (const DomainCurve& curve : model.curves) {
    lengths.push_back(lengthOf(curve));
    if (lengths.back() < kTinyShare * size)
      defects.push_back(defectOf(DefectKind::TinyEdge, curve, lengths.back()));
  }
  std::ranges::stable_sort(defects, {}, &Defect::extent);
  std::vector<Defect> slivers;
  std::vector<int> uses(model.curves.size(), 0);
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    double perimeter = 0;
    for (const auto& loop : model.faces[f].loops)
      for (const CurveUse& use : loop) {
        perimeter += lengths[use.curve];
        ++uses[use.curve];
      }
    const double width = perimeter > 0 ? 2 * model.faces[f].area / perimeter : size;
    if (!(width < kTinyShare * size)) continue;
    Defect defect =
        defectOf(DefectKind::Sliver, model.curves[model.faces[f].loops[0][0].curve], width);
    defect.edge = 0;
    defect.face = static_cast<int>(f) + 1;
    slivers.push_back(std::move(defect));
  }
  std::ranges::stable_sort(slivers, {}, &Defect::extent);
  defects.insert(defects.end(), slivers.begin(), slivers.end());
  if (model.isFlat) return defects;  // a plane has borders
  for (const DefectKind kind : {DefectKind::FreeEdge, DefectKind::NonManifoldEdge})
    for (std::size_t c = 0; c < uses.size(); ++c)
      if (kind == DefectKind::FreeEdge ? uses[c] == 1 : uses[c] > 2)
        defects.push_back(defectOf(kind, model.curves[c], lengths[c]));
  return defects;
}

}  // namespace af2::geometry
