// What all pages for browsers are written with. Not installed.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "geometry/io/base64.h"
#include "geometry/io/output_file.h"

namespace af2::geometry {

/// Writes a page of geometry/page/web/: in it, a name between two "@" stands for that part, and
/// "@data@" for what `writeData` writes.
void fillPage(std::string_view page, OutputFile& file, const std::function<void()>& writeData);

/// JSON without "<", so that no text in it can end the element of the page that holds it.
std::string jsonInScript(std::string_view json);

/// A part of the data as JSON, which jsonInScript has made.
void writePageJson(std::string_view id, std::string_view json, OutputFile& file);

/// One array of the data; `fill` puts its values into the stream.
///
/// type  that of the browser, such as Float32
template <class Fill>
void writePageArray(std::string_view name, std::string_view type, OutputFile& file, Fill fill) {
  file.text("<script type=\"text/plain\" id=\"array-");
  file.text(name);
  file.text("\" data-type=\"");
  file.text(type);
  file.text("\">");
  Base64Stream stream(file);
  fill(stream);
  stream.finish();
  file.text("</script>\n");
}

}  // namespace af2::geometry
