#include <cstring>

#include "cli/playground/http_server.h"
#include "engine/base/error.h"
#include "geometry/base/loaded_parts.h"

namespace af2::playground {

std::unique_ptr<HttpServer> makeHttpServer(HttpHandler& handler, const HttpOptions& options) {
  void* const entry = geometry::entryOfPart(kHttpLibrary, kHttpModuleEntry);
  const HttpModule* const found =
      entry ? reinterpret_cast<const HttpModule* (*)()>(entry)() : nullptr;
  if (!found || std::strcmp(found->version, AF2_VERSION) != 0)
    throw InputError(geometry::placeOfPart(kHttpLibrary).string() +
                     " belongs to another version of this program; build or install both together");
  return found->make(handler, options);
}

}  // namespace af2::playground
