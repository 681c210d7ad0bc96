// A rule set as an HTML page that needs no network.
#pragma once

#include <map>
#include <string>

#include "dsl/load/rule_file.h"

namespace af2::cli {

/// File contents by path within the folder: index.html and its pictures.
using Site = std::map<std::string, std::string>;

Site makeGallery(const dsl::LoadedRules& loaded);

}  // namespace af2::cli
