// What verbs say about parts that touch, overlap or coincide.
#pragma once

#include <string>

#include "geometry/mesh/contact.h"

namespace af2::cli {

/// A warning for those who mesh such parts: how many there are and what helps; empty if there are
/// none.
std::string contactWarning(const geometry::PartContacts& contacts);

/// A table of all pairs, or of the first ten of each kind; empty for a model of one part.
std::string contactTable(const geometry::PartContacts& contacts, bool all);

}  // namespace af2::cli
