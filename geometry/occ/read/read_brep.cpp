#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <fstream>

#include "engine/base/error.h"
#include "geometry/occ/read/readers.h"

namespace af2::geometry {

namespace {

bool isBinary(std::istream& stream) {
  std::string start(64, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  stream.clear();
  stream.seekg(0);
  return start.find("Open CASCADE Topology V") != std::string::npos;
}

}  // namespace

bool looksLikeBrep(const std::string& start) {
  return start.find("CASCADE Topology V") != std::string::npos ||
         start.find("DBRep_DrawableShape") != std::string::npos;
}

ReadShape readBrep(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const bool binary = isBinary(stream);
  // OpenCASCADE reads on past the end of a file that is cut off; so the stream has to throw.
  stream.exceptions(std::ios::failbit | std::ios::badbit);

  ReadShape result;
  if (binary)
    BinTools::Read(result.shape, stream);
  else
    BRepTools::Read(result.shape, stream, BRep_Builder());
  return result;
}

}  // namespace af2::geometry
