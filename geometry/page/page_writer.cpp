#include "geometry/page/page_writer.h"

#include <algorithm>

#include "geometry/page/page_parts.h"

namespace af2::geometry {

void fillPage(std::string_view page, OutputFile& file, const std::function<void()>& writeData) {
  std::string_view rest = pagePart(page);
  for (bool isName = false; !rest.empty(); isName = !isName) {
    const std::string_view piece = rest.substr(0, rest.find('@'));
    rest.remove_prefix(std::min(piece.size() + 1, rest.size()));
    if (!isName)
      file.text(piece);
    else if (piece == "data")
      writeData();
    else
      file.text(pagePart(piece));
  }
}

std::string jsonInScript(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

void writePageJson(std::string_view id, std::string_view json, OutputFile& file) {
  file.text("<script type=\"application/json\" id=\"");
  file.text(id);
  file.text("\">");
  file.text(json);
  file.text("</script>\n");
}

}  // namespace af2::geometry
