#include "cli/mpi/model_file.h"

#include <fstream>
#include <string>
#include <system_error>

#include "engine/base/error.h"
#include "geometry/mpi/crew/topics.h"

namespace af2::mpi {

namespace fs = std::filesystem;

namespace {

Bytes bytesOfFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code odd;
  const std::uintmax_t size = fs::file_size(path, odd);
  Bytes bytes;
  if (!odd) bytes.resize(size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (odd || !file) throw InputError("cannot read '" + path.string() + "'");
  return bytes;
}

}  // namespace

void sendModel(Process& process, const fs::path& model) {
  if (process.post().ranks() > 1)
    process.orderAll(Order::TakeModel, bytesOf(model.filename().string(), bytesOfFile(model)));
}

cli::TemporaryFile receiveModel(Process& process) {
  const Bytes letter = process.waitFor(Order::TakeModel);
  ByteReader reader(letter);
  const auto name = reader.take<std::string>();
  const auto bytes = reader.take<Bytes>();
  return cli::TemporaryFile(name,
                            std::span(reinterpret_cast<const char*>(bytes.data()), bytes.size()),
                            "a copy of the model");
}

}  // namespace af2::mpi
