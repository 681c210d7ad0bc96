// Finds invalid numbers in a STEP file.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace af2::geometry {

/// The first number of each entity that cannot be a length, an angle or a weight: one above 1e100,
/// the cube of which is close to overflow, or `-1.#IND`, which some compilers write for NaN. By the
/// label of the entity, 17 for #17.
std::map<int, std::string> unusableNumbersOf(const std::filesystem::path& path);

}  // namespace af2::geometry
