// Files of meshes in parts, of which each process writes its own.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "geometry/io/output_file.h"
#include "geometry/mpi/partition/owned_part.h"

namespace af2::mpi {

/// Throws InputError unless the extension is one of those that files in parts have: .pvtu, .msh.
void checkPartsFile(const std::filesystem::path& file);

/// The file of one process: that of `mesh.pvtu` is `mesh_0.vtu` for process 0, that of `mesh.msh`
/// is `mesh_1.msh`, as Gmsh calls them.
std::filesystem::path partFileOf(const std::filesystem::path& file, int process);

using PartFiles = std::vector<std::unique_ptr<geometry::OutputFile>>;

/// Writes the part, and on process 0 the file that names all parts, where the format has one. The
/// files do not appear until they are committed. Throws InputError if one cannot be written.
PartFiles writePart(const OwnedPart& part, const std::filesystem::path& file);

void writePartVtu(const OwnedPart& part, geometry::OutputFile& file);
/// The file that names the parts.
void writePvtu(const OwnedPart& part, const std::filesystem::path& all, geometry::OutputFile& file);
/// Gmsh 4.1, binary, with the sections of partitioned entities and ghost elements.
void writePartMsh(const OwnedPart& part, geometry::OutputFile& file);

}  // namespace af2::mpi
