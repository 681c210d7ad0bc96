// The places of the front that new elements can fill.
#pragma once

#include <vector>

#include "engine/step/rule_matcher.h"

namespace af2 {

/// Where new elements go.
struct OpenPlaces {
  /// By matched vertex: where a vertex stands on the front more than once, the place whose free
  /// directions hold the new elements.
  std::vector<PlaceId> places;
  /// By vertex of the rule's replacement: WalkVertex::existing.
  std::vector<PlaceId> joined;
};

/// False if a vertex has no such place.
bool findOpenPlaces(const StepView& view, const CompiledRule& rule, const Match& match,
                    OpenPlaces& open);

}  // namespace af2
