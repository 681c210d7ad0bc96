// Writes a CAD model as STL, as programs for CAD do: `write_stl MODEL OUT.stl`. For run_corpus.py,
// which so tries surfaces of triangles.
#include <BRepMesh_IncrementalMesh.hxx>
#include <Standard_Failure.hxx>
#include <StlAPI_Writer.hxx>
#include <cstdio>
#include <exception>

#include "geometry/occ/model/model.h"
#include "geometry/occ/model/model_shape.h"

namespace {

/// In shares of the diagonal, and in radians.
constexpr double kDeflection = 1e-3, kTurn = 0.35;

void write(const char* from, const char* to) {
  const af2::geometry::Model model = af2::geometry::readModel(from);
  const TopoDS_Shape& shape = model.shape().shape;
  BRepMesh_IncrementalMesh(shape, kDeflection * model.diagonal(), false, kTurn);
  StlAPI_Writer writer;
  writer.ASCIIMode() = false;
  if (!writer.Write(shape, to)) throw std::runtime_error("no triangles");
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::fprintf(stderr, "write_stl MODEL OUT.stl\n");
    return 2;
  }
  try {
    write(words[1], words[2]);
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "%s: %s\n", words[1], failure.GetMessageString());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", words[1], error.what());
    return 1;
  }
}
