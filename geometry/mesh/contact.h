// Where parts of a model touch, overlap or coincide although they share no faces there.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

enum class ContactKind {
  Touch,     ///< along faces, edges or at a vertex
  Overlap,   ///< some volume belongs to both solids
  Coincide,  ///< both are the same
  Unknown,   ///< their boxes meet, but they could not be compared
};

/// "touch", "overlap", "coincide" or "unknown".
AF2_EXPORT const char* toString(ContactKind kind);

/// Two parts of a model and what they have in common.
struct PartContact {
  ContactKind kind = ContactKind::Touch;
  std::string one, other;                  ///< names of the parts, in the order of the model
  double area = 0;                         ///< of the common surface
  double length = 0;                       ///< of common lines that do not bound a common surface
  double volume = 0;                       ///< of the overlap
  bool isAtPoint = false;                  ///< they have vertices in common, and nothing else
  Point3 place;                            ///< the middle of what they have in common
  std::vector<std::pair<int, int>> twins;  ///< faces of the two parts that are equal as a whole
  bool operator==(const PartContact&) const = default;
};

/// All pairs of parts with something in common.
struct PartContacts {
  std::size_t parts = 0;
  std::vector<PartContact> pairs;  ///< in the order of the model
  /// Pairs whose boxes meet that were not compared, because the limit was reached.
  std::size_t notCompared = 0;
  bool operator==(const PartContacts&) const = default;
};

}  // namespace af2::geometry
