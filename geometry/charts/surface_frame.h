// A surface at one place of its parameters: position and derivatives.
#pragma once

#include "engine/base/point.h"

namespace af2::geometry {

struct SurfaceFrame {
  Point3 position, du, dv;
};

struct SurfaceJet {
  Point3 position, du, dv, duu, duv, dvv;
};

}  // namespace af2::geometry
