// Models as IGES files.
#pragma once

#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "geometry/base/words.h"
#include "tests/support/test_folder.h"

namespace af2::testing {

/// The text of the file that OpenCASCADE writes: faces that share no edges.
inline std::string inIges(const std::vector<TopoDS_Shape>& shapes) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  IGESControl_Writer writer("MM", 0);
  for (const TopoDS_Shape& shape : shapes) writer.AddShape(shape);
  writer.ComputeModel();
  const TestFile file("model.igs");
  writer.Write(file.path().c_str());
  return geometry::contentOf(file.path());
}

}  // namespace af2::testing
