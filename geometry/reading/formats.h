// The readers behind readMesh, one file each, and the table of them.
// Not installed.
#pragma once

#include <array>

#include "geometry/reading/mesh_builder.h"

namespace af2::geometry {

/// VTK XML, with inline arrays that are not compressed.
void readVtu(const std::string& content, MeshBuilder& mesh);
/// Legacy VTK, text or binary, up to version 4.2.
void readVtk(const std::string& content, MeshBuilder& mesh);
/// Gmsh 2.2 and 4.1, text or binary.
void readMsh(const std::string& content, MeshBuilder& mesh);
void readStlMesh(const std::string& content, MeshBuilder& mesh);
void readObjMesh(const std::string& content, MeshBuilder& mesh);
/// Text or binary.
void readPly(const std::string& content, MeshBuilder& mesh);
/// Geomview's OFF, text.
void readOff(const std::string& content, MeshBuilder& mesh);

/// In the order in which messages list them.
inline constexpr std::array kMeshFileFormats{
    MeshFileFormat{{"VTK XML", {".vtu"}}, &readVtu},
    MeshFileFormat{{"VTK", {".vtk"}}, &readVtk},
    MeshFileFormat{{"Gmsh", {".msh", ".msh2"}}, &readMsh},
    MeshFileFormat{{"STL", {".stl"}}, &readStlMesh},
    MeshFileFormat{{"OBJ", {".obj"}}, &readObjMesh},
    MeshFileFormat{{"PLY", {".ply"}}, &readPly},
    MeshFileFormat{{"OFF", {".off"}}, &readOff},
};

}  // namespace af2::geometry
