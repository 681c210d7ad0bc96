// The families of models that are made to be meshed: each a function from drawn numbers to a shape.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

#include "tests/corpus/made/draw.h"

namespace af2::made {

struct Family {
  const char* name;
  /// Returns a null shape, or throws Standard_Failure, where the numbers give no model.
  TopoDS_Shape (*make)(Draw&);
};

/// Boolean operations, fillets, chamfers, shells, drafts: what parts of machines are made with.
std::vector<Family> partFamilies();

/// Lofts, pipes, springs, threads, revolutions: what comes of curves.
std::vector<Family> sweptFamilies();

/// Free surfaces, sheets, what shares faces, odd units and places.
std::vector<Family> surfaceFamilies();

/// Faces that turn sharply inside, along lines that are no edges.
std::vector<Family> creasedFamilies();

/// Sheet metal, heat sinks, gears, twisted bars: what comes of one profile.
std::vector<Family> profiledFamilies();

/// Castings, bottles, lattices, impellers, fittings.
std::vector<Family> productFamilies();

/// Surfaces between curves, uneven splines, many holes, long and ragged boundaries.
std::vector<Family> ornateFamilies();

/// Details below the size, needles, slits, large tolerances, edges beside their plane.
std::vector<Family> awkwardFamilies();

}  // namespace af2::made
