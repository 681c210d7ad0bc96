#include "geometry/occ/iges/closed_runs.h"

#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {
namespace {

/// An edge as a face has it.
struct RunSide {
  std::size_t unit = 0;  ///< that the face is, or is part of
  double length = 0;
  gp_Pnt center;
};

/// Units that are not split: faces, shells and solids.
void collectUnits(const TopoDS_Shape& shape, std::vector<TopoDS_Shape>& units) {
  if (shape.ShapeType() != TopAbs_COMPOUND) return units.push_back(shape);
  for (TopoDS_Iterator it(shape); it.More(); it.Next()) collectUnits(it.Value(), units);
}

std::vector<RunSide> sidesOf(const std::vector<TopoDS_Shape>& units) {
  std::vector<RunSide> sides;
  for (std::size_t u = 0; u < units.size(); ++u)
    for (TopExp_Explorer it(units[u], TopAbs_EDGE); it.More(); it.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      GProp_GProps properties;
      BRepGProp::LinearProperties(it.Current(), properties);
      sides.push_back({u, properties.Mass(), properties.CentreOfMass()});
    }
  return sides;
}

/// Numbers the places of edges, by side: sides with the same number coincide.
class Places {
 public:
  Places(const std::vector<RunSide>& sides, double tolerance) : sets_(sides.size()) {
    std::vector<std::size_t> order(sides.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return sides[i].center.X(); });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = i + 1; k < order.size(); ++k) {
        const RunSide &a = sides[order[i]], &b = sides[order[k]];
        if (b.center.X() - a.center.X() > tolerance) break;
        if (a.center.Distance(b.center) <= tolerance && std::abs(a.length - b.length) <= tolerance)
          sets_.join(static_cast<std::uint32_t>(order[i]), static_cast<std::uint32_t>(order[k]));
      }
  }

  std::size_t of(std::size_t side) { return sets_.of(static_cast<std::uint32_t>(side)); }

 private:
  DisjointSets sets_;
};

/// Where, in the order of the file, nothing is open.
struct Closings {
  std::vector<std::size_t> ends;  ///< the units that follow
  std::vector<char> meetsOpen;    ///< by unit: whether an edge lies on it that stays open
};

Closings closingsOf(const std::vector<RunSide>& sides, Places places, std::size_t units) {
  Closings closings;
  std::vector<bool> isOpen(sides.size(), false);  // by place
  std::size_t side = 0, open = 0;
  for (std::size_t u = 0; u < units; ++u) {
    for (; side < sides.size() && sides[side].unit == u; ++side) {
      const std::size_t place = places.of(side);
      isOpen[place] = !isOpen[place];
      isOpen[place] ? ++open : --open;
    }
    if (open == 0) closings.ends.push_back(u + 1);
  }
  closings.meetsOpen.assign(units, 0);
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (isOpen[places.of(i)]) closings.meetsOpen[sides[i].unit] = 1;
  return closings;
}

TopoDS_Compound compoundOf(std::span<const TopoDS_Shape> units) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& unit : units) builder.Add(compound, unit);
  return compound;
}

}  // namespace

std::vector<TopoDS_Shape> closedRuns(const TopoDS_Shape& shape, double tolerance) {
  std::vector<TopoDS_Shape> units;
  collectUnits(shape, units);
  const std::vector<RunSide> sides = sidesOf(units);
  const Closings closings = closingsOf(sides, Places(sides, tolerance), units.size());
  std::vector<TopoDS_Shape> runs, rest;
  const std::span<const TopoDS_Shape> all(units);
  std::size_t begin = 0;
  for (const std::size_t end : closings.ends) {
    const auto run = all.subspan(begin, end - begin);
    if (!std::ranges::count(std::span(closings.meetsOpen).subspan(begin, run.size()), 1))
      runs.push_back(compoundOf(run));
    else
      rest.insert(rest.end(), run.begin(), run.end());
    begin = end;
  }
  rest.insert(rest.end(), units.begin() + static_cast<std::ptrdiff_t>(begin), units.end());
  if (!rest.empty()) runs.push_back(compoundOf(rest));
  return runs;
}

}  // namespace af2::geometry
