#include "geometry/occ/step/endless_profiles.h"

#include <StepGeom_HArray1OfTrimmingSelect.hxx>
#include <StepGeom_Hyperbola.hxx>
#include <StepGeom_SurfaceOfRevolution.hxx>
#include <StepGeom_TrimmedCurve.hxx>

#include "geometry/occ/step/step_entities.h"

namespace af2::geometry {

namespace {

Handle(StepGeom_HArray1OfTrimmingSelect) endAt(double parameter) {
  const Handle(StepGeom_HArray1OfTrimmingSelect) end = new StepGeom_HArray1OfTrimmingSelect(1, 1);
  StepGeom_TrimmingSelect select;
  select.SetParameterValue(parameter);
  end->SetValue(1, select);
  return end;
}

}  // namespace

void trimEndlessProfiles(const Handle(XSControl_WorkSession) & session) {
  constexpr double kFar = 100;  // 1e43 times as far as the axes of the hyperbola are long
  StepEntities(session).forEach([](const Handle(Standard_Transient) & entity) {
    const auto surface = Handle(StepGeom_SurfaceOfRevolution)::DownCast(entity);
    if (surface.IsNull()) return;
    const auto profile = Handle(StepGeom_Hyperbola)::DownCast(surface->SweptCurve());
    if (profile.IsNull()) return;
    const Handle(StepGeom_TrimmedCurve) trimmed = new StepGeom_TrimmedCurve;
    trimmed->Init(profile->Name(), profile, endAt(-kFar), endAt(kFar), true, StepGeom_tpParameter);
    surface->SetSweptCurve(trimmed);
  });
}

}  // namespace af2::geometry
