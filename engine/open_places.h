// The places of the front that new elements can fill.
#pragma once

#include <vector>

#include "engine/rule_matcher.h"

namespace af2 {

/// Puts the places of all matched vertices into `places`: where a vertex stands on the front more
/// than once, the one whose free directions hold the new elements. False if a vertex has none.
bool findOpenPlaces(const StepView& view, const CompiledRule& rule, const Match& match,
                    std::vector<PlaceId>& places);

}  // namespace af2
