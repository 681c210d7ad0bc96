#include <BRepBuilderAPI_Sewing.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>

#include "engine/error.h"
#include "geometry/occ/readers.h"

namespace af2::geometry {

namespace {

/// Edges that only one face has. Seams count as shared.
int freeEdges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  int count = 0;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (faces(i).Extent() == 1) ++count;
  return count;
}

/// IGES gives each trimmed surface edges of its own; only sewn do neighbours share them.
void sew(ReadShape& read, double tolerance) {
  const int before = freeEdges(read.shape);
  if (before == 0) return;
  BRepBuilderAPI_Sewing sewing(tolerance);
  sewing.SetNonManifoldMode(false);
  sewing.Add(read.shape);
  sewing.Perform();
  const TopoDS_Shape sewn = sewing.SewedShape();
  if (sewn.IsNull()) return;
  const int after = freeEdges(sewn);
  if (after >= before) return;
  read.shape = sewn;
  read.notes.push_back("sewed neighbouring faces: " + std::to_string(before) +
                       " edges had one face only, now " + std::to_string(after));
}

}  // namespace

ReadShape readIges(const std::filesystem::path& path) {
  IGESControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw InputError(path.string() +
                     ": this IGES file is damaged or cut off; export the model again");
  reader.SetReadVisible(false);
  reader.TransferRoots();

  ReadShape result;
  result.unit = "mm";
  const IGESData_GlobalSection& global = reader.IGESModel()->GlobalSection();
  if (!global.UnitName().IsNull()) result.fileUnit = global.UnitName()->ToCString();
  result.shape = reader.OneShape();
  if (!result.shape.IsNull()) sew(result, 1e-4);
  return result;
}

}  // namespace af2::geometry
