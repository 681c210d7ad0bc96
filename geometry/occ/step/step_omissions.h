// Mends what OpenCASCADE's lexer of STEP files refuses although its meaning is plain.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace af2::geometry {

/// The text of a STEP file, mended. OpenCASCADE would lose the entities, and with them faces, in
/// which
/// * a complex entity leaves out its name: `REPRESENTATION_ITEM()` becomes
///   `REPRESENTATION_ITEM('')`;
/// * the exponent of a real has a small letter, as scripts write it: `1e-7` becomes `1.E-7`.
/// Nothing if the file has neither.
std::optional<std::string> mendedStepText(const std::filesystem::path& path);

}  // namespace af2::geometry
