// The writers behind mesh_files.h, one file each, and the table of them.
// Not installed.
#pragma once

#include <array>
#include <span>

#include "geometry/io/line_elements.h"
#include "geometry/io/mesh_files.h"
#include "geometry/io/output_file.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// VTK XML, base64: elements with their face, rule, level, score and quality, lines with edge and
/// boundary.
void writeVtu(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// Legacy VTK, binary: the same.
void writeVtk(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// Gmsh 4.1, binary: each model face and each edge with lines is an entity and a
/// physical group, or in that of its boundary; each solid is a volume entity.
void writeMsh(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// Gmsh 2.2, text: the same without volumes. Each element is in one physical group.
void writeMsh2(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// STL, binary, or with groups text with a solid for each; quadrilaterals are split.
void writeStl(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// TetGen's .smesh, text; quadrilaterals are split, each model face is a boundary marker.
void writeSmesh(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// Wavefront OBJ, text: each model face, name or group is a group.
void writeObj(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// Abaqus and CalculiX, text: shell elements, sets of elements and nodes for all groups.
void writeInp(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// Nastran, text: shell elements, properties and sets for all groups.
void writeNastran(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// glTF 2.0, binary: a node for each model face, with its colour and the names of its groups.
void writeGltf(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// For SALOME and code_aster: families for all groups, overlapping or not.
void writeMed(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// Exodus II: blocks and sets for all groups.
void writeExodus(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// CGNS, in HDF5: sections, sub-regions and boundary conditions for all groups.
void writeCgns(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// PLY, binary.
void writePly(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// A page for browsers, which needs no other file: geometry/page/.
void writePage(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// A picture, PNG: geometry/picture/.
void writePng(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
/// A picture of a planar mesh, SVG. Throws InputError if the mesh is not planar.
void writeSvg(const ModelMesh& mesh, const Extras& extras, OutputFile& file);

/// Libraries of AF2: the writers that need those of others.
inline constexpr const char* kMedWriter = "af2-med.so";
inline constexpr const char* kExodusWriter = "af2-exodus.so";
inline constexpr const char* kCgnsWriter = "af2-cgns.so";

/// In the order in which help texts name them.
inline constexpr std::array kMeshFormats{
    MeshFormat{".vtu", "VTK XML unstructured grid", &writeVtu, true, true, true, false, false,
               true},
    MeshFormat{".vtk", "legacy VTK", &writeVtk, false, true, true},
    MeshFormat{".msh", "Gmsh 4.1", &writeMsh, true, true, false, false, true},
    MeshFormat{".msh2", "Gmsh 2.2", &writeMsh2, true, true, false, false, true},
    MeshFormat{".stl", "STL", &writeStl, false, false, false, false, true},
    MeshFormat{".obj", "Wavefront OBJ", &writeObj, false, false, false, false, true},
    MeshFormat{".ply", "PLY", &writePly},
    MeshFormat{".smesh", "TetGen", &writeSmesh},
    MeshFormat{".inp", "Abaqus and CalculiX", &writeInp, true, true, false, false, true},
    MeshFormat{".bdf", "Nastran", &writeNastran, true, true, false, false, true},
    MeshFormat{".nas", "Nastran", &writeNastran, true, true, false, false, true},
    MeshFormat{".med", "MED", &writeMed, true, true, false, false, true, false, kMedWriter},
    MeshFormat{".exo", "Exodus II", &writeExodus, true, true, false, false, true, false,
               kExodusWriter},
    MeshFormat{".cgns", "CGNS", &writeCgns, true, true, false, false, true, false, kCgnsWriter},
    MeshFormat{".glb", "glTF 2.0", &writeGltf, false, true, false, false, true},
    MeshFormat{".html", "page for browsers", &writePage, true, false, true},
    MeshFormat{".png", "picture, PNG", &writePng, true},
    MeshFormat{".svg", "picture, SVG", &writeSvg, true, false, false, true},
};

}  // namespace af2::geometry
