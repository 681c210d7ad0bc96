// Writes the models of the benchmarks that are not among the examples, as STEP files:
//   benchmark_models DIRECTORY
//     sphere.step   radius 5
//     spline.step   one bicubic B-spline face of 20 x 20 spans, about 10 x 10, with waves
//     parts.step    1,000 faces of about 1 x 1: planes, splines, cylinders, cones, tori, spheres
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Compound.hxx>
#include <cstdio>
#include <filesystem>

#include "spline_face.h"

namespace {

/// Shapes in a row, none touching another.
class Row {
 public:
  Row() { builder_.MakeCompound(compound_); }
  gp_Ax2 next() { return {gp_Pnt(3.0 * count_++, 0, 0), gp::DZ()}; }
  void add(const TopoDS_Shape& shape) { builder_.Add(compound_, shape); }
  const TopoDS_Shape& shape() const { return compound_; }

 private:
  BRep_Builder builder_;
  TopoDS_Compound compound_;
  int count_ = 0;
};

TopoDS_Shape manyFaces() {
  Row row;
  for (int i = 0; i < 50; ++i) row.add(BRepPrimAPI_MakeBox(row.next(), 1, 1.1, 0.9).Shape());
  for (int i = 0; i < 50; ++i)
    row.add(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeBox(row.next(), 1, 1.1, 0.9).Shape()));
  for (int i = 0; i < 30; ++i) row.add(BRepPrimAPI_MakeCylinder(row.next(), 0.5, 0.5, 2).Shape());
  for (int i = 0; i < 30; ++i) row.add(BRepPrimAPI_MakeCone(row.next(), 0.6, 0.4, 0.7).Shape());
  for (int i = 0; i < 35; ++i) row.add(BRepPrimAPI_MakeTorus(row.next(), 0.6, 0.2, 1.0).Shape());
  for (int i = 0; i < 55; ++i) row.add(BRepPrimAPI_MakeSphere(row.next(), 0.5).Shape());
  return row.shape();
}

bool write(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  STEPControl_Writer writer;
  return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write(path.c_str()) == IFSelect_RetDone;
}

bool writeAll(const std::filesystem::path& directory) {
  return write(BRepPrimAPI_MakeSphere(5).Shape(), directory / "sphere.step") &&
         write(af2::benchmark::splineFace(), directory / "spline.step") &&
         write(manyFaces(), directory / "parts.step");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: benchmark_models DIRECTORY\n");
    return 2;
  }
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));  // it is talkative
  try {
    std::filesystem::create_directories(argv[1]);
    if (writeAll(argv[1])) return 0;
    std::fprintf(stderr, "benchmark_models: cannot write to %s\n", argv[1]);
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "benchmark_models: %s\n", failure.GetMessageString());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "benchmark_models: %s\n", failure.what());
  }
  return 1;
}
