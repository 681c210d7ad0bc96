#include "engine/base/place_text.h"

#include <charconv>

namespace af2 {

std::string textOf(double number, int digits) {
  char text[32];
  return {text,
          std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits).ptr};
}

std::string textOf(const Point3& p, int digits) {
  return "(" + textOf(p.x, digits) + ", " + textOf(p.y, digits) + ", " + textOf(p.z, digits) + ")";
}

std::string textOf(Point2 p, int digits) {
  return "(" + textOf(p.x, digits) + ", " + textOf(p.y, digits) + ")";
}

}  // namespace af2
