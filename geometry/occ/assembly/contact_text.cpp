#include "geometry/occ/assembly/contact_text.h"

#include <cstdio>
#include <cstdlib>

namespace af2::geometry {

namespace {

void append(std::string& text, double number) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%a ", number);
  text += digits;
}

}  // namespace

std::string textOf(const PartContact& contact) {
  std::string text;
  for (const double number :
       {static_cast<double>(contact.kind), contact.area, contact.length, contact.volume,
        contact.isAtPoint ? 1.0 : 0.0, contact.place.x, contact.place.y, contact.place.z})
    append(text, number);
  for (const auto& [one, other] : contact.twins) {
    append(text, one);
    append(text, other);
  }
  return text;
}

PartContact contactFrom(const std::string& text) {
  const char* rest = text.c_str();
  const auto next = [&] {
    char* end = nullptr;
    const double number = std::strtod(rest, &end);
    rest = end;
    return number;
  };
  PartContact contact;
  contact.kind = static_cast<ContactKind>(static_cast<int>(next()));
  contact.area = next();
  contact.length = next();
  contact.volume = next();
  contact.isAtPoint = next() != 0;
  contact.place.x = next();
  contact.place.y = next();
  contact.place.z = next();
  while (*rest == ' ' && rest[1] != '\0') {
    const int one = static_cast<int>(next());
    contact.twins.emplace_back(one, static_cast<int>(next()));
  }
  return contact;
}

}  // namespace af2::geometry
