#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <fstream>
#include <iostream>
#include <new>
#include <span>

#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/base/words.h"
#include "geometry/occ/model/model.h"
#include "geometry/occ/read/crossed_faces.h"
#include "geometry/occ/read/readers.h"

namespace af2::geometry {

namespace {

namespace fs = std::filesystem;

/// Keeps OpenCASCADE from printing while a file is read; its readers share global state anyway.
class Silence {
 public:
  Silence() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    // Some readers write to the streams directly.
    out_ = std::cout.rdbuf(nullptr);
    error_ = std::cerr.rdbuf(nullptr);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(error_);
    std::cout.clear();
    std::cerr.clear();
    Message::DefaultMessenger()->ChangePrinters() = printers_;
  }

 private:
  Message_SequenceOfPrinters printers_;
  std::streambuf* out_;
  std::streambuf* error_;
};

std::string startOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string start(kStartSize, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return start;
}

std::string namesOfFormats() {
  std::vector<std::string_view> names;
  for (const CadFormat& format : kCadFormats) names.push_back(format.name);
  return listed(names, "or");
}

/// "an IGES file".
std::string fileOf(const CadFormat& format) {
  const bool isSpokenWithVowel = std::string_view("AEIO").find(format.name[0]) != std::string::npos;
  return (isSpokenWithVowel ? "an " : "a ") + std::string(format.name) + " file";
}

/// The content determines the format; for a file whose start is damaged, the name shows the
/// intended format.
const CadFormat& formatOfFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw InputError(path.string() + ": there is no such file");
  if (fs::is_directory(status)) throw InputError(path.string() + ": is a folder, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string() + ": cannot be opened; check its permissions");
  const std::string start = startOf(path);
  if (start.empty()) throw InputError(path.string() + ": is empty; export the model again");

  for (const CadFormat& format : kCadFormats)
    if (format.looksLike(start)) return format;
  if (const CadFormat* byName = formatOf(std::span<const CadFormat>(kCadFormats), path))
    throw InputError(path.string() + ": does not start like " + fileOf(*byName) +
                     "; it is damaged or in another format, export the model again");
  if (start.starts_with("\x1f\x8b") || start.starts_with("PK\x03\x04"))
    throw InputError(path.string() + ": is compressed; unpack it first");
  throw InputError(path.string() + ": is not a " + namesOfFormats() +
                   " file; export the model as one of these");
}

std::string damaged(const fs::path& path, const CadFormat& format, const std::string& cause) {
  return path.string() + ": this " + std::string(format.name) + " file is damaged or truncated (" +
         cause + "); export the model again";
}

ReadShape readShape(const fs::path& path) {
  const CadFormat& format = formatOfFile(path);
  try {
    const Silence silence;
    return format.read(path);
  } catch (const InputError&) {
    throw;
  } catch (const Standard_Failure& failure) {
    const std::string text = failure.GetMessageString() ? failure.GetMessageString() : "";
    throw InputError(damaged(path, format, text.empty() ? failure.DynamicType()->Name() : text));
  } catch (const std::bad_alloc&) {
    throw InputError(damaged(path, format, "it needs more memory than is available"));
  } catch (const std::exception& failure) {
    throw InputError(damaged(path, format, failure.what()));
  }
}

}  // namespace

std::vector<FileFormat> cadFormats() { return {kCadFormats.begin(), kCadFormats.end()}; }

Model readModel(const fs::path& path) {
  ReadShape read = readShape(path);
  if (read.shape.IsNull())
    throw InputError(path.string() +
                     ": contains no shape; it is truncated, or was exported without one");
  std::shared_ptr<const ModelShape> shape;
  try {
    const Silence silence;
    turnBackCrossedFaces(read);
    shape = makeModelShape(std::move(read));
  } catch (const Standard_Failure& failure) {
    throw InputError(path.string() + ": the shape in it is damaged (" +
                     failure.DynamicType()->Name() + "); repair or export the model again");
  }
  if (shape->faces.IsEmpty() && !shape->lostFaces.empty())
    throw InputError(path.string() + ": none of its " + std::to_string(shape->lostFaces.size()) +
                     " faces can be read, the first is " + shape->lostFaces.front() +
                     "; export the model again");
  if (shape->faces.IsEmpty())
    throw InputError(path.string() + ": contains no face, only " +
                     std::to_string(shape->edges.Extent()) + " edges and " +
                     std::to_string(shape->vertices.Extent()) +
                     " vertices; export the model with its surfaces");
  return Model(shape);
}

}  // namespace af2::geometry
