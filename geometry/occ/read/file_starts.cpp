// How the start of a file tells its format; apart from the readers, which may have to be loaded
// first.
#include "geometry/occ/read/readers.h"

namespace af2::geometry {

bool looksLikeStep(const std::string& start) {
  return start.find("ISO-10303-21") != std::string::npos;
}

/// An IGES file is made of lines of 80 columns; column 73 holds the letter of the section.
bool looksLikeIges(const std::string& start) {
  const std::size_t end = start.find_first_of("\r\n");
  return end != std::string::npos && end >= 73 && end <= 81 &&
         (start[72] == 'S' || start[72] == 'C' || start[72] == 'B');
}

}  // namespace af2::geometry
