#include "geometry/domain/domain_check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

bool isSize(double size) { return std::isfinite(size) && size > 0; }

void checkIds(const DomainModel& model, const DomainMeshingOptions& options) {
  const auto check = [&](const char* kind, int id, int count) {
    if (id < 1 || id > count)
      throw InputError(std::string(kind) + " " + std::to_string(id) + ": the model has " + kind +
                       "s 1 to " + std::to_string(count));
  };
  const int faces = static_cast<int>(model.faces.size());
  int edges = 0;
  for (const DomainCurve& curve : model.curves) edges = std::max(edges, curve.id);
  for (const int face : options.faces) check("face", face, faces);
  for (const auto& [face, size] : options.faceSizes) check("face", face, faces);
  for (const auto& [edge, size] : options.edgeSizes) check("edge", edge, edges);
  for (const auto& [edge, points] : options.edgePoints) {
    check("edge", edge, edges);
    if (std::ranges::count(model.curves, edge, &DomainCurve::id) != 1)
      throw InputError("points are given for edge " + std::to_string(edge) +
                       ", which bounds nothing or is split where others meet it; divide it there "
                       "in the file");
  }
}

void checkOptions(const DomainMeshingOptions& options) {
  const auto check = [](double size) {
    if (!isSize(size)) throw InputError("the size must be a positive number");
  };
  checkWanted(options);
  for (const auto& [face, size] : options.faceSizes) check(size);
  for (const auto& [edge, size] : options.edgeSizes) check(size);
  if (options.order != 1 && options.order != 2) throw InputError("elements can have order 1 or 2");
}

void checkCurves(const DomainModel& model) {
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    const DomainCurve& curve = model.curves[c];
    const auto require = [&](bool isSo, const char* fault) {
      if (!isSo) throw InputError("curve " + std::to_string(c + 1) + " of the model " + fault);
    };
    require(std::max(curve.first, curve.last) < model.corners.size(), "ends at no corner of it");
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
        require(use.curve < model.curves.size(), "is bounded by a curve that is not there");
    for (const std::size_t corner : face.isolated)
      require(corner < model.corners.size(), "has a vertex inside at no corner of the model");
  }
}

}  // namespace

void checkWanted(const WantedSizes& wanted) {
  constexpr double kFewestPerTurn = 3;
  if (!isSize(wanted.size)) throw InputError("the size must be a positive number");
  if (!(wanted.minSize >= 0) || !(wanted.maxSize >= wanted.minSize) || !(wanted.maxSize > 0))
    throw InputError("the smallest size must not be negative, nor above the largest");
  if (wanted.elementsPerTurn != 0 && !(wanted.elementsPerTurn >= kFewestPerTurn))
    throw InputError("a turn needs at least 3 elements");
  if (!(wanted.elementsAcross >= 0) || !std::isfinite(wanted.elementsAcross))
    throw InputError("the number of elements across narrow places must not be negative");
  if (!isSize(wanted.growth)) throw InputError("the growth of sizes must be a positive number");
  if (wanted.growth > kMostGrowth)
    throw InputError("the growth of sizes must be at most " +
                     std::to_string(static_cast<int>(kMostGrowth)) + " per unit of length");
}

void checkWanted(const DomainMeshingOptions& o) {
  checkWanted({o.size, o.minSize, o.maxSize, o.elementsPerTurn, o.elementsAcross, o.growth});
}

void checkDomain(const DomainModel& model, const DomainMeshingOptions& options) {
  checkOptions(options);
  checkIds(model, options);
  checkCurves(model);
  checkFaces(model);
}

}  // namespace af2::geometry
