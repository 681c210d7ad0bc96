// The formats that models are read in: the tables of planar domains, surfaces of triangles and CAD
// models as one.
#pragma once

#include <filesystem>
#include <string>

namespace af2::cli {

enum class ModelKind { Cad, Faceted, Planar };

/// By the extension. A file whose extension belongs to no format of another kind is taken for a CAD
/// model: its content says in which format it is.
ModelKind modelKindOf(const std::filesystem::path& model);

/// "STL or OBJ", with `conjunction` before the last one. Empty for kinds that this program was
/// built without.
std::string formatNames(ModelKind kind, const char* conjunction);
/// Of all kinds.
std::string formatNames(const char* conjunction);

/// For help texts: "STEP, IGES or BREP file (CAD), ...".
std::string modelHelp();

/// That the program was built without OpenCASCADE, but the model needs it.
[[noreturn]] void refuseCadModel(const std::filesystem::path& model);

}  // namespace af2::cli
