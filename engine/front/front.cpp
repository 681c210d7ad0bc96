#include "engine/front/front.h"

#include <cmath>

#include "engine/base/error.h"
#include "engine/base/turn.h"

namespace af2 {

/// The caller sets every member: clearing a place first would cost as much as setting it.
PlaceId Front::take() {
  if (free_.empty()) {
    places_.emplace_back();
    return PlaceId(places_.size() - 1);
  }
  const PlaceId id = free_.back();
  free_.pop_back();
  return id;
}

PlaceId Front::addLoop(std::span<const BoundaryCorner> corners, std::span<const double> sizes) {
  const std::size_t first = places_.size();
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    Place place;
    place.point = corners[i].point;
    place.vertex = corners[i].vertex;
    place.size = sizes[i];
    place.next = PlaceId(first + (i + 1) % n);
    place.previous = PlaceId(first + (i + n - 1) % n);
    place.level = 1;
    place.age = age_++;
    places_.push_back(place);
  }
  edgeCount_ += n;
  return PlaceId(first);
}

PlaceId Front::addOpenChain(std::span<const BoundaryCorner> corners,
                            std::span<const double> sizes) {
  const PlaceId first = addLoop(corners, sizes);
  places_[first.value + corners.size() - 1].level = kNoEdge;
  --edgeCount_;
  return first;
}

PlaceId Front::addIsolated(const BoundaryCorner& corner, double size) {
  Place place;
  place.point = corner.point;
  place.vertex = corner.vertex;
  place.size = size;
  place.level = kNoEdge;
  const PlaceId id(places_.size());
  place.next = place.previous = id;
  places_.push_back(place);
  ++isolatedCount_;
  return id;
}

void Front::exchangePredecessors(PlaceId p, PlaceId q) {
  const PlaceId beforeP = previous(p), beforeQ = previous(q);
  link(beforeP, q);
  link(beforeQ, p);
}

void Front::cancelOppositeEdges(PlaceId id, Change& change) {
  const PlaceId other = next(id);
  if (!isUsed(id) || other == id || next(other) != id) return;
  for (PlaceId p : {id, other}) {
    places_[p.value].level = 0;
    change.removed.push_back(p);
  }
  edgeCount_ -= 2;
}

void Front::replace(PlaceId base, std::span<const WalkVertex> walk, Change& change) {
  change.added.clear();
  change.removed.clear();
  touched_.assign(1, base);
  const PlaceId end = next(base);

  PlaceId last = base;
  for (const WalkVertex& w : walk) {
    const PlaceId id = take();
    Place& place = places_[id.value];
    place.point = w.point;
    place.vertex = w.vertex;
    place.size = w.size;
    place.layer = w.layer;
    place.level = 1;
    place.ownCount = 0;
    link(last, id);
    if (loops_.areNumbered()) loops_.add(last, id);
    touched_.push_back(id);
    last = id;
  }
  link(last, end);
  edgeCount_ += walk.size();

  // Exchanging predecessors rather than successors keeps each old edge at the place that it leaves.
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const PlaceId old = walk[i].existing;
    if (old.isNone()) continue;
    if (isIsolated(old)) {
      places_[old.value].level = 0;
      change.removed.push_back(old);
      --isolatedCount_;
    } else {
      exchangePredecessors(touched_[i + 1], old);
      if (loops_.areNumbered()) loops_.exchanged(*this, touched_[i + 1], old);
    }
  }

  for (PlaceId id : touched_) {
    cancelOppositeEdges(id, change);
    if (isUsed(id)) cancelOppositeEdges(previous(id), change);
  }
  for (PlaceId id : touched_) {
    if (!isUsed(id)) continue;
    places_[id.value].level = 1;
    places_[id.value].age = age_++;
    change.added.push_back(id);
  }
}

void Front::weld(PlaceId first, PlaceId last, VertexId vertex, const SurfacePoint& point,
                 Change& change) {
  change.added.clear();
  change.removed = {first, next(first)};
  const std::int32_t layer = std::min((*this)[first].layer, (*this)[last].layer);
  if (loops_.areNumbered()) loops_.shorten(last);
  link(previous(first), last);
  edgeCount_ -= 2;
  for (const PlaceId id : change.removed) places_[id.value].level = 0;
  Place& place = places_[last.value];
  place.vertex = vertex;
  place.point = point;
  place.layer = layer;
  place.ownCount = 0;
  for (const PlaceId id : {previous(last), last}) {
    places_[id.value].level = 1;
    places_[id.value].age = age_++;
    change.added.push_back(id);
  }
}

void Front::release(const Change& change) {
  for (PlaceId id : change.removed) free_.push_back(id);
}

template <class Measure>
double Front::measureTurn(PlaceId id, const Measure& measure) const {
  const Place& place = (*this)[id];
  const Point3 out = (*this)[place.next].point.position - place.point.position;
  const Point3 back = (*this)[place.previous].point.position - place.point.position;
  return measure(dot(place.point.normal, cross(out, back)), dot(out, back));
}

double Front::turn(PlaceId id) const { return measureTurn(id, turnOf); }
double Front::sweep(PlaceId id) const { return measureTurn(id, sweepOf); }

int Front::loopSize(PlaceId id) const {
  if (isIsolated(id)) return 0;
  if (loops_.areNumbered()) return loops_.sizeOfLoop(id);
  int count = 0;
  PlaceId p = id;
  do {
    ++count;
    p = next(p);
  } while (p != id);
  return count;
}

}  // namespace af2
