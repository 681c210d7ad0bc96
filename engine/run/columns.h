// Where rows change the number of their elements, so that edges keep the wanted length.
// Not installed.
#pragma once

#include "engine/front/front.h"
#include "engine/front/front_queue.h"
#include "engine/rule/rule_set.h"

namespace af2 {

/// Gives counts of their own to vertices of the front: 3 where its edges are too long, so that a
/// column of elements is added, and 1 where they are too short, so that one ends. Walks along each
/// loop with a sum of the edges that are missing or too many. Returns the number of such vertices.
///
/// valence  by vertex: the number of elements so far
std::size_t planColumns(Front& front, FrontQueue& queue, const ColumnLimits& limits,
                        const std::vector<std::uint8_t>& valence);

}  // namespace af2
