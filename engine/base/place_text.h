// Numbers and points as text for messages. Not installed.
#pragma once

#include <string>

#include "engine/base/point.h"

namespace af2 {

/// With at most this many digits, and with a decimal point whatever the locale.
std::string textOf(double number, int digits = 9);
/// "(1, 2.5, -3)"
std::string textOf(const Point3& place, int digits = 9);
std::string textOf(Point2 place, int digits = 9);

}  // namespace af2
