#include "mpi/program/model_file.h"

#include <stdlib.h>

#include <fstream>
#include <string>
#include <system_error>

#include "engine/base/error.h"
#include "mpi/crew/topics.h"

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

fs::path newFolder() {
  std::string name = (fs::temp_directory_path() / "af2-mpi-XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw InputError("cannot make the folder '" + name + "' for a copy of the model");
  return name;
}

}  // namespace

void sendModel(Process& process, const fs::path& model) {
  if (process.post().ranks() > 1)
    process.orderAll(Order::TakeModel, bytesOf(model.filename().string(), bytesOfFile(model)));
}

ModelCopy::ModelCopy(Process& process) {
  const Bytes letter = process.waitFor(Order::TakeModel);
  ByteReader reader(letter);
  const auto name = reader.take<std::string>();
  const auto bytes = reader.take<Bytes>();
  folder_ = newFolder();
  path_ = folder_ / name;
  std::ofstream file(path_, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) {
    remove();
    throw InputError("there is no room in '" + folder_.parent_path().string() +
                     "' for a copy of the model; set TMPDIR to another folder");
  }
}

void ModelCopy::remove() const {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

}  // namespace af2::mpi
