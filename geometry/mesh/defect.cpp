#include "geometry/mesh/defect.h"

namespace af2::geometry {

const char* toString(DefectKind kind) {
  switch (kind) {
    case DefectKind::TinyEdge:
      return "tiny edge";
    case DefectKind::Sliver:
      return "sliver";
    case DefectKind::Gap:
      return "gap";
    case DefectKind::OpenLoop:
      return "open loop";
    case DefectKind::TouchingLoop:
      return "touching loop";
    case DefectKind::FreeEdge:
      return "free edge";
    case DefectKind::NonManifoldEdge:
      return "non-manifold edge";
    case DefectKind::TurnedFaces:
      return "turned faces";
    case DefectKind::EdgeOnEdge:
      return "edge on edge";
    case DefectKind::FaceOnFace:
      return "face on face";
    case DefectKind::NoCurve:
      return "edge without curve";
    case DefectKind::NoSurface:
      return "empty face";
    case DefectKind::Invalid:
      return "invalid";
  }
  return "invalid";
}

}  // namespace af2::geometry
