// Sizes by the names of faces and groups.
#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// By face id: the size of the last of the `parts` that matches the name of the face or of one of
/// its groups.
///
/// names  of the faces 1, 2, ...; may be empty
///
/// Throws InputError if a part matches no name, or its size is not positive.
AF2_EXPORT std::map<int, double> sizesByName(std::span<const std::pair<std::string, double>> parts,
                                             std::span<const std::string> names,
                                             std::span<const FaceGroup> groups);

/// The ids, ascending, of faces whose name, or that of one of their groups, matches the pattern.
/// The name of a group is also that in mesh files, such as "solid 1" or "color #ff0000".
AF2_EXPORT std::vector<int> facesCalled(const std::string& pattern,
                                        std::span<const std::string> names,
                                        std::span<const FaceGroup> groups);

/// The same faces, then those that match one of the patterns. Throws InputError if one matches
/// none.
AF2_EXPORT std::vector<int> withFacesCalled(std::vector<int> faces,
                                            std::span<const std::string> patterns,
                                            std::span<const std::string> names,
                                            std::span<const FaceGroup> groups);

/// The same for a size or bound that is given for the pattern: throws InputError if there is none.
AF2_EXPORT std::vector<int> facesNamed(const std::string& pattern,
                                       std::span<const std::string> names,
                                       std::span<const FaceGroup> groups);

/// Whether a name matches a pattern, in which `*` matches any text and `?` any UTF-8 character. All
/// other characters match themselves, including brackets and backslashes.
AF2_EXPORT bool fitsPattern(const std::string& name, const std::string& pattern);

}  // namespace af2::geometry
