// The formats of models: one table for planar domains, surfaces of triangles and CAD models.
#pragma once

#include <filesystem>
#include <string>

namespace af2::cli {

enum class ModelKind { Cad, Faceted, Planar };

/// Decides by the extension. A file with an unknown extension is taken for a CAD model, whose
/// content shows its format.
ModelKind modelKindOf(const std::filesystem::path& model);

/// "STL or OBJ", with `conjunction` before the last one. Empty for kinds that this program was
/// built without.
std::string formatNames(ModelKind kind, const char* conjunction);
/// The same for all kinds.
std::string formatNames(const char* conjunction);

/// "step, stp, ...": the extensions of all formats, without dots.
std::string modelExtensions();
/// Throws UsageError unless `format` is one of these, or empty.
void checkModelFormat(const std::string& format);

/// For help texts: "STEP, IGES or BREP file (CAD), ...".
std::string modelHelp();

/// Throws InputError: the model needs OpenCASCADE, which the program was built without.
[[noreturn]] void refuseCadModel(const std::filesystem::path& model);

}  // namespace af2::cli
