// The entry of a library with one reader, compiled once for each: AF2_MODULE_READER is its
// function.
#include "geometry/occ/loading/reader_module.h"
#include "geometry/occ/read/readers.h"

extern "C" __attribute__((visibility("default"))) const af2::geometry::ReaderModule*
af2ReaderModule() {
  static const af2::geometry::ReaderModule module{AF2_VERSION, sizeof(af2::geometry::ReadShape),
                                                  &af2::geometry::AF2_MODULE_READER};
  return &module;
}
