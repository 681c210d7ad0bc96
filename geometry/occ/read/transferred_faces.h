// What the readers of STEP and IGES files made of an entity.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>

namespace af2::geometry {

/// Whether a face, or a shape with faces, was made of the entity.
inline bool hasBecomeFace(const Handle(Transfer_TransientProcess) & process,
                          const Handle(Standard_Transient) & entity) {
  const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
  return !shape.IsNull() && TopExp_Explorer(shape, TopAbs_FACE).More();
}

}  // namespace af2::geometry
