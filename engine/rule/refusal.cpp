#include "engine/rule/refusal.h"

namespace af2 {

const char* toString(Refusal refusal) {
  switch (refusal) {
    case Refusal::None:
      return "none";
    case Refusal::Class:
      return "class";
    case Refusal::Pattern:
      return "pattern";
    case Refusal::Require:
      return "require";
    case Refusal::NoValue:
      return "novalue";
    case Refusal::Parity:
      return "parity";
    case Refusal::Shape:
      return "shape";
    case Refusal::Convexity:
      return "convexity";
    case Refusal::ZoneHitByVertex:
      return "zone hit by vertex";
    case Refusal::ZoneHitByEdge:
      return "zone hit by edge";
    case Refusal::Clearance:
      return "clear";
    case Refusal::Inverted:
      return "inverted";
    case Refusal::Weld:
      return "weld";
    case Refusal::Score:
      return "score";
    case Refusal::Surface:
      return "surface";
    case Refusal::Beaten:
      return "beaten";
  }
  return "unknown";
}

}  // namespace af2
