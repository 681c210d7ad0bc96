// Models as STEP files.
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <string>

#include "geometry/base/words.h"
#include "tests/support/test_folder.h"

namespace af2::testing {

/// The text of the file that OpenCASCADE writes.
inline std::string inStep(const TopoDS_Shape& shape) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const TestFile file("model.step");
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  writer.Write(file.path().c_str());
  return geometry::contentOf(file.path());
}

}  // namespace af2::testing
