// Reads fields of sizes that users have: views of Gmsh, and point arrays of VTK.
#pragma once

#include <filesystem>
#include <string>

#include "engine/base/export.h"
#include "geometry/sizes/cell_size.h"

namespace af2::geometry {

/// "FILE" or "FILE:ARRAY".
struct SizeFieldName {
  std::filesystem::path file;
  std::string array;  ///< empty: the only one
};
AF2_EXPORT SizeFieldName sizeFieldName(const std::string& text);

/// Reads the sizes at the vertices of the cells in a file: an array of $NodeData in an .msh file of
/// Gmsh, a view in a .pos file, or a point array in a .vtu file. Cells with a vertex without value
/// are left out.
///
/// Throws InputError, naming the arrays that there are, if the file has no such array, or several
/// and none is named; and if the file cannot be read or a size is not greater than 0.
AF2_EXPORT SizeCells readSizeField(const SizeFieldName& name);

}  // namespace af2::geometry
