#include "geometry/domain/domain_check.h"

#include <algorithm>
#include <functional>
#include <string>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

void checkCurves(const DomainModel& model) {
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    const DomainCurve& curve = model.curves[c];
    const auto require = [&](bool isSo, const char* fault) {
      if (!isSo) throw InputError("curve " + std::to_string(c + 1) + " of the model " + fault);
    };
    require(std::max(curve.first, curve.last) < model.corners.size(),
            "has an end that is not a corner of it");
    require(static_cast<bool>(curve.pointAt), "has no points");
    require(curve.knots.size() >= 2 &&
                std::ranges::adjacent_find(curve.knots, std::greater_equal()) == curve.knots.end(),
            "needs knots at its ends, in ascending order");
  }
}

void checkFaces(const DomainModel& model) {
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const DomainFace& face = model.faces[f];
    const auto require = [&](bool isSo, const char* fault) {
      if (!isSo) throw InputError("face " + std::to_string(f + 1) + " of the model " + fault);
    };
    require(face.surface != nullptr, "has no surface");
    require(!face.loops.empty(), "has no boundary; cut a closed surface along curves");
    for (const auto& loop : face.loops)
      for (const CurveUse& use : loop)
        require(use.curve < model.curves.size(), "is bounded by a curve that does not exist");
    for (const std::size_t corner : face.isolated)
      require(corner < model.corners.size(),
              "has a vertex inside that is not a corner of the model");
  }
}

}  // namespace

void checkDomain(const DomainModel& model) {
  checkCurves(model);
  checkFaces(model);
}

void checkPoints(const DomainModel& model, const EdgePoints& given) {
  for (const auto& [edge, points] : given)
    if (std::ranges::count(model.curves, edge, &DomainCurve::id) != 1)
      throw InputError("points are given for edge " + std::to_string(edge) +
                       ", which bounds nothing or is split where others meet it; divide it there "
                       "in the file");
}

}  // namespace af2::geometry
