// Puts back what STEP files leave out although it says nothing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace af2::geometry {

/// The text of a STEP file with an empty name wherever a complex entity leaves out its name:
/// `REPRESENTATION_ITEM()` becomes `REPRESENTATION_ITEM('')`. OpenCASCADE would not read such an
/// entity at all, and its face would be lost. Nothing if the file has all names.
std::optional<std::string> withOmittedNames(const std::filesystem::path& path);

}  // namespace af2::geometry
