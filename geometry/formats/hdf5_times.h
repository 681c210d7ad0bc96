// Takes the times of writing out of HDF5 files. Not installed.
#pragma once

#include <filesystem>

namespace af2::geometry {

/// Sets all times in the file to zero, so that the same mesh gives the same bytes. A file that is
/// not HDF5 stays as it is.
void clearHdf5Times(const std::filesystem::path& file);

}  // namespace af2::geometry
