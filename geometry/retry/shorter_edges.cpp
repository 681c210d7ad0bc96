#include "geometry/retry/shorter_edges.h"

#include <algorithm>
#include <iterator>

#include "geometry/retry/retry_limits.h"
#include "geometry/retry/score.h"

namespace af2::geometry {

namespace {

/// The places of the diagnosis; and where elements cross, places with half the length of these
/// elements. Where two faces almost touch along a curve, new crossings appear next to those that
/// vanished: after some unsuccessful tries the length is a quarter, so that the finer region
/// extends farther.
std::vector<SizeSource> placesAtFault(const Retrial& retrial, const FaceMeshes& state,
                                      std::size_t i) {
  const double share =
      retrial.faces[i].failures < kTriesBeforeMuchFiner ? kFinerAtCrossings : kMuchFinerAtCrossings;
  const int face = state.meshes[i].report.id;
  std::vector<SizeSource> places = state.meshes[i].diagnosis.places;
  const std::size_t most = places.size() + kMaxPlacesAtCrossings;
  for (const Crossing& crossing : state.faults.crossings)
    for (std::size_t k = 0; k < 2 && places.size() < most; ++k) {
      if (crossing.faces[k] != face) continue;
      places.push_back({crossing.place, share * crossing.widths[k]});
    }
  return places;
}

/// A face that failed may be bent more than its size can follow, wherever that was, or nowhere.
std::vector<SizeSource> sizesToFollow(const Retrial& retrial, const FaceMeshes& state,
                                      std::size_t i) {
  if (!failed(state.meshes[i]) || retrial.faces[i].askedShorter) return {};
  return retrial.model.sizesInside(i);
}

}  // namespace

void findFault(Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  const FaceMesh& mesh = state.meshes[face];
  retrial.faces[face].hasFault =
      failed(mesh) && mesh.diagnosis.isBad && retrial.model.hasFaultInModel(face);
}

bool mayShortenEdges(const Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  if (!retrial.hasBudgetLeft) return false;
  if (failed(state.meshes[face]) && retrial.faces[face].hasFault) return false;
  if (crossingsAt(state, face) > 0) return true;
  // A mesh that is fit for use is made nicer once, but not at any price.
  if (!state.meshes[face].diagnosis.isBad && retrial.faces[face].askedShorter) return false;
  return !placesAtFault(retrial, state, face).empty() ||
         !sizesToFollow(retrial, state, face).empty();
}

std::optional<std::size_t> shortenEdges(Retrial& retrial, FaceMeshes& state, std::size_t face) {
  std::vector<SizeSource> places = placesAtFault(retrial, state, face);
  const std::size_t atFault = places.size();
  std::ranges::move(sizesToFollow(retrial, state, face), std::back_inserter(places));
  retrial.requests.add(face, places);
  retrial.faces[face].askedShorter = true;
  return atFault;
}

void unshortenEdges(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next, std::size_t face) {
  if (failed(state.meshes[face]))
    retrial.requests.dropAll(face);
  else if (!failed(next.meshes[face]) && crossingsAt(next, face) > 0)
    retrial.requests.dropPlaces(face);
  else
    retrial.requests.dropLast(face);
}

}  // namespace af2::geometry
