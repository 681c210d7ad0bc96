// The distance that new edges must keep from the rest of the front.
// Not installed.
#pragma once

#include "engine/step/candidate_score.h"
#include "engine/step/neighborhood.h"

namespace af2 {

/// Everything that the clearance of a candidate's new edges covers.
Window clearanceWindow(const Candidate& candidate, double clearance);

/// The first edge of the neighborhood that is closer than the clearance to a new edge of the
/// candidate; null if there is none. Edges that the candidate has matched, edges that share an end
/// with the new edge, and the half of a new edge at a vertex of the front do not count.
const Neighborhood::Edge* tooCloseEdge(const Front& front, const Neighborhood& near,
                                       const Candidate& candidate, double clearance);

}  // namespace af2
