#include <cstring>

#include "cli/playground/http_server.h"
#include "geometry/base/loaded_parts.h"

namespace af2::playground {

std::unique_ptr<HttpServer> makeHttpServer(HttpHandler& handler, const HttpOptions& options) {
  const auto isSame = [](const HttpModule& module) {
    return std::strcmp(module.version, AF2_VERSION) == 0;
  };
  return geometry::moduleOfPart<HttpModule>(kHttpLibrary, kHttpModuleEntry, isSame)
      .make(handler, options);
}

}  // namespace af2::playground
