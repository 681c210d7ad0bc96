// Finds the places of the front that new elements can fill.
#pragma once

#include <vector>

#include "engine/step/rule_matcher.h"

namespace af2 {

/// The places of the front that new elements fill.
struct OpenPlaces {
  /// By matched vertex. If a vertex has several places on the front, this is the one whose free
  /// directions hold the new elements.
  std::vector<PlaceId> places;
  /// By vertex of the rule's replacement: WalkVertex::existing.
  std::vector<PlaceId> joined;
};

/// Returns false if a vertex has no such place.
bool findOpenPlaces(const StepView& view, const CompiledRule& rule, const Match& match,
                    OpenPlaces& open);

}  // namespace af2
