#include "geometry/retry/collapsed_edges.h"
#include "geometry/retry/last_tries.h"
#include "geometry/retry/protected_neighbors.h"
#include "geometry/retry/remedy.h"
#include "geometry/retry/shared_diagonals.h"
#include "geometry/retry/shorter_edges.h"
#include "geometry/retry/withdrawn_requests.h"

namespace af2::geometry {

namespace {

constexpr FaceRemedy kFaceRemedies[] = {
    {"short edges collapsed to points", RemedyTime::BeforeRound, mayCollapseEdges, collapseEdges,
     uncollapseEdges, findShortEdges, false},
    {"shorter edges", RemedyTime::BeforeRound, mayShortenEdges, shortenEdges, unshortenEdges,
     findFault},
    {"protection of neighbors", RemedyTime::AfterRound, isSpoiledNeighbor, protectNeighbor, nullptr,
     rememberBadFace, false},
    {"original edges", RemedyTime::LastRound, hasVainRequests, withdrawRequests, nullptr, nullptr,
     false},
    {"no reflex quadrilaterals", RemedyTime::InPlace, mayRefuseReflex, meshWithoutReflex,
     restoreFailedFace},
    {"elements that tilt against the surface", RemedyTime::InPlace, mayIgnoreNormals,
     meshIgnoringNormals, restoreFailedFace}};

constexpr MeshRemedy kMeshRemedies[] = {{"diagonals that differ from adjacent faces", hasFindings,
                                         splitSharedDiagonals, hasFewerFindings}};

}  // namespace

std::span<const FaceRemedy> faceRemedies() { return kFaceRemedies; }
std::span<const MeshRemedy> meshRemedies() { return kMeshRemedies; }

}  // namespace af2::geometry
