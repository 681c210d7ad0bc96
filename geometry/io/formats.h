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
/// Netgen's .vol, text; quadrilaterals are split, each model face is a boundary condition between
/// two domains.
void writeVol(const ModelMesh& mesh, const Extras& extras, OutputFile& file);
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
    MeshFormat{.extension = ".vtu",
               .name = "VTK XML unstructured grid",
               .write = &writeVtu,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsScores = true,
               .isCompressible = true,
               .holdsSpooled = true},
    MeshFormat{.extension = ".vtk",
               .name = "legacy VTK",
               .write = &writeVtk,
               .holdsLines = true,
               .holdsScores = true,
               .holdsSpooled = true},
    MeshFormat{.extension = ".msh",
               .name = "Gmsh 4.1",
               .write = &writeMsh,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true},
    MeshFormat{.extension = ".msh2",
               .name = "Gmsh 2.2",
               .write = &writeMsh2,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true,
               .holdsSpooled = true},
    MeshFormat{.extension = ".stl",
               .name = "STL",
               .write = &writeStl,
               .holdsGroups = true,
               .holdsSpooled = true},
    MeshFormat{.extension = ".obj",
               .name = "Wavefront OBJ",
               .write = &writeObj,
               .holdsGroups = true,
               .holdsSpooled = true},
    MeshFormat{.extension = ".ply", .name = "PLY", .write = &writePly, .holdsSpooled = true},
    MeshFormat{.extension = ".smesh", .name = "TetGen", .write = &writeSmesh},
    MeshFormat{.extension = ".vol", .name = "Netgen", .write = &writeVol},
    MeshFormat{.extension = ".inp",
               .name = "Abaqus and CalculiX",
               .write = &writeInp,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true},
    MeshFormat{.extension = ".bdf",
               .name = "Nastran",
               .write = &writeNastran,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true},
    MeshFormat{.extension = ".nas",
               .name = "Nastran",
               .write = &writeNastran,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true},
    MeshFormat{.extension = ".med",
               .name = "MED",
               .write = &writeMed,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true,
               .writer = kMedWriter},
    MeshFormat{.extension = ".exo",
               .name = "Exodus II",
               .write = &writeExodus,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true,
               .writer = kExodusWriter},
    MeshFormat{.extension = ".cgns",
               .name = "CGNS",
               .write = &writeCgns,
               .holdsSecondOrder = true,
               .holdsLines = true,
               .holdsGroups = true,
               .writer = kCgnsWriter},
    MeshFormat{.extension = ".glb",
               .name = "glTF 2.0",
               .write = &writeGltf,
               .holdsLines = true,
               .holdsGroups = true},
    MeshFormat{.extension = ".html",
               .name = "page for browsers",
               .write = &writePage,
               .holdsSecondOrder = true,
               .holdsScores = true},
    MeshFormat{
        .extension = ".png", .name = "picture, PNG", .write = &writePng, .holdsSecondOrder = true},
    MeshFormat{.extension = ".svg",
               .name = "picture, SVG",
               .write = &writeSvg,
               .holdsSecondOrder = true,
               .isOnlyPlanar = true},
};

}  // namespace af2::geometry
