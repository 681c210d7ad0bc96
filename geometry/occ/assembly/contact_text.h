// Contacts as text, to pass them from a forked process.
// Not installed.
#pragma once

#include <string>

#include "geometry/mesh/contact.h"

namespace af2::geometry {

/// All fields but the names, numbers without loss.
std::string textOf(const PartContact& contact);
PartContact contactFrom(const std::string& text);

}  // namespace af2::geometry
