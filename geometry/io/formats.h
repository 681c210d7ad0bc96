// The writers behind mesh_files.h, one file each.
#pragma once

#include "geometry/io/output_file.h"
#include "geometry/model_mesh.h"

namespace af2::geometry {

/// VTK XML, base64: elements with their face, rule and quality.
void writeVtu(const ModelMesh& mesh, OutputFile& file);
/// Legacy VTK, binary: elements with their face, rule and quality.
void writeVtk(const ModelMesh& mesh, OutputFile& file);
/// Gmsh 4.1, binary: each model face is an entity and a physical group.
void writeMsh(const ModelMesh& mesh, OutputFile& file);
/// STL, binary; quadrilaterals are split.
void writeStl(const ModelMesh& mesh, OutputFile& file);
/// TetGen's .smesh, text; quadrilaterals are split, each model face is a boundary marker.
void writeSmesh(const ModelMesh& mesh, OutputFile& file);
/// Wavefront OBJ, text: each model face is a group.
void writeObj(const ModelMesh& mesh, OutputFile& file);
/// PLY, binary.
void writePly(const ModelMesh& mesh, OutputFile& file);

}  // namespace af2::geometry
