#include "geometry/mesh/contact.h"

namespace af2::geometry {

const char* toString(ContactKind kind) {
  switch (kind) {
    case ContactKind::Touch:
      return "touch";
    case ContactKind::Overlap:
      return "overlap";
    case ContactKind::Coincide:
      return "coincide";
    case ContactKind::Unknown:
      return "unknown";
  }
  return "unknown";
}

}  // namespace af2::geometry
