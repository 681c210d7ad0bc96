// af2 version
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/program/exit_code.h"
#include "cli/program/verbs.h"

namespace af2::cli {

Action declareVersion(CLI::App& command) {
  const auto asJson = std::make_shared<bool>(false);
  command.add_flag("--json", *asJson, "print as JSON");
  return [asJson] {
    if (*asJson) {
      const nlohmann::ordered_json json{
          {"name", "af2"}, {"version", AF2_VERSION}, {"opencascade", bool{AF2_HAVE_OCC}}};
      fmt::print("{}\n", json.dump());
    } else {
      fmt::print("af2 {}\n", AF2_VERSION);
    }
    return kComplete;
  };
}

}  // namespace af2::cli
