// The zone of a region, with exact answers.
#pragma once

#include <utility>

#include "dsl/shapes/covering_zone.h"
#include "dsl/shapes/region.h"

namespace af2::dsl::shapes {

class RegionZone final : public CoveringZone {
 public:
  RegionZone(Region region, const Box2& box) : region_(std::move(region)), box_(box) {}

  Box2 boundingBox() const override { return box_; }

  bool contains(Point2 point, ZoneBoundary boundary) const override {
    const Place place = region_.locate(point);
    return place == Place::In || (place == Place::On && boundary == ZoneBoundary::Counts);
  }

  bool meets(Point2 from, Point2 to, ZoneBoundary boundary) const override {
    return region_.meets({from, to}, boundary);
  }

  bool covers(Point2 from, Point2 to) const override { return region_.covers({from, to}); }

  const Region& region() const { return region_; }

 private:
  Region region_;
  Box2 box_;
};

}  // namespace af2::dsl::shapes
