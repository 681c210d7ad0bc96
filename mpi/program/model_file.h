// The file of the model, which one process reads from its disk for all.
#pragma once

#include <filesystem>

#include "mpi/crew/process.h"

namespace af2::mpi {

/// Sends the file to all other processes. Throws InputError if it cannot be read.
void sendModel(Process& process, const std::filesystem::path& model);

/// A copy of the model's file of the first process, in a folder of its own until it is removed.
class ModelCopy {
 public:
  /// Waits for the file. Throws InputError if there is no room for it.
  explicit ModelCopy(Process& process);
  ~ModelCopy() { remove(); }
  ModelCopy(const ModelCopy&) = delete;
  ModelCopy& operator=(const ModelCopy&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void remove() const;

 private:
  std::filesystem::path folder_, path_;
};

}  // namespace af2::mpi
