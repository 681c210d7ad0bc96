// The file of the model, which one process reads from its disk for all.
#pragma once

#include <filesystem>

#include "cli/program/temporary_file.h"
#include "geometry/mpi/crew/process.h"

namespace af2::mpi {

/// Sends the file to all other processes. Throws InputError if it cannot be read.
void sendModel(Process& process, const std::filesystem::path& model);

/// A copy of the file of the first process. Waits for it; throws InputError if there is no room.
cli::TemporaryFile receiveModel(Process& process);

}  // namespace af2::mpi
