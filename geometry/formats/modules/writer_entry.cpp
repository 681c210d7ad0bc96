// The entry of a library that writes one format, compiled once for each: AF2_MODULE_WRITER is its
// function.
#include "geometry/formats/writer_module.h"

namespace af2::geometry {
void AF2_MODULE_WRITER(const GroupedMesh& mesh, const char* path);
}

extern "C" __attribute__((visibility("default"))) const af2::geometry::WriterModule*
af2WriterModule() {
  static const af2::geometry::WriterModule module{AF2_VERSION, af2::geometry::kWriterMeshSize,
                                                  &af2::geometry::AF2_MODULE_WRITER};
  return &module;
}
