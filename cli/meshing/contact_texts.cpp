#include "cli/meshing/contact_texts.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include "engine/base/place_text.h"

namespace af2::cli {
namespace {

using geometry::ContactKind;
using geometry::PartContact;
using geometry::PartContacts;

std::size_t countOf(const PartContacts& contacts, ContactKind kind) {
  return static_cast<std::size_t>(std::ranges::count(contacts.pairs, kind, &PartContact::kind));
}

/// "'a' and 'b'" of the first pair of a kind.
std::string exampleOf(const PartContacts& contacts, ContactKind kind) {
  const auto pair = std::ranges::find(contacts.pairs, kind, &PartContact::kind);
  return fmt::format("'{}' and '{}' at {}", pair->one, pair->other, textOf(pair->place));
}

std::string kindText(const PartContacts& contacts, ContactKind kind, const char* verb,
                     const char* verbOfOne) {
  const std::size_t count = countOf(contacts, kind);
  if (count == 0) return "";
  return fmt::format("{} {} of parts {}, e.g. {}", count, count == 1 ? "pair" : "pairs",
                     count == 1 ? verbOfOne : verb, exampleOf(contacts, kind));
}

std::string rowOf(const PartContact& pair) {
  std::string amount;
  if (pair.kind == ContactKind::Unknown) amount = "could not be compared";
  if (pair.volume > 0) amount = fmt::format("volume {:.4g}", pair.volume);
  const auto add = [&](const std::string& text) { amount += (amount.empty() ? "" : ", ") + text; };
  if (pair.area > 0 && pair.volume == 0) add(fmt::format("area {:.4g}", pair.area));
  if (pair.length > 0 && pair.volume == 0) add(fmt::format("length {:.4g}", pair.length));
  if (pair.isAtPoint) add("a vertex");
  std::string text = fmt::format("{:<10}  {:<24}  '{}' and '{}'", geometry::toString(pair.kind),
                                 amount, pair.one, pair.other);
  if (pair.kind != ContactKind::Unknown) text += " at " + textOf(pair.place);
  constexpr std::size_t kMaxTwins = 5;
  for (std::size_t i = 0; i < std::min(pair.twins.size(), kMaxTwins); ++i)
    text += fmt::format("{}{} = {}", i == 0 ? "; equal faces " : ", ", pair.twins[i].first,
                        pair.twins[i].second);
  if (pair.twins.size() > kMaxTwins)
    text += fmt::format(" and {} more", pair.twins.size() - kMaxTwins);
  return text + "\n";
}

/// isAlone  nothing is said of other pairs
std::string notComparedText(const PartContacts& contacts, bool isAlone) {
  const std::size_t count = contacts.notCompared;
  if (count == 0) return "";
  return fmt::format("{}{} {}", count, isAlone ? "" : " more",
                     count == 1 ? "pair of parts is close to each other and was not compared"
                                : "pairs of parts are close to each other and were not compared");
}

}  // namespace

std::string contactWarning(const PartContacts& contacts) {
  std::string text;
  for (const std::string& part :
       {kindText(contacts, ContactKind::Touch, "touch", "touches"),
        kindText(contacts, ContactKind::Overlap, "overlap", "overlaps"),
        kindText(contacts, ContactKind::Coincide, "coincide", "coincides")})
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  if (!text.empty()) text += ": their meshes do not match there without --imprint";
  if (const std::size_t unknown = countOf(contacts, ContactKind::Unknown); unknown > 0)
    text += fmt::format("{}{} {} of parts could not be compared", text.empty() ? "" : "; ", unknown,
                        unknown == 1 ? "pair" : "pairs");
  if (const std::string rest = notComparedText(contacts, text.empty()); !rest.empty())
    text += (text.empty() ? "" : "; ") + rest;
  if (text.empty()) return "";
  return fmt::format("note: {} (af2 inspect lists all)\n", text);
}

std::string contactTable(const PartContacts& contacts, bool all) {
  if (contacts.parts < 2) return "";
  constexpr std::size_t kMaxListed = 10;
  std::string text = fmt::format("{} parts; ", contacts.parts);
  if (contacts.pairs.empty())
    text += "none touches another one without sharing its faces there\n";
  else
    text +=
        fmt::format("{} pairs touch or overlap without sharing faces, edges or vertices there\n",
                    contacts.pairs.size());
  std::map<ContactKind, std::size_t> listed, left;
  for (const PartContact& pair : contacts.pairs) {
    if (all || listed[pair.kind]++ < kMaxListed)
      text += rowOf(pair);
    else
      ++left[pair.kind];
  }
  for (const auto& [kind, count] : left)
    text += fmt::format("and {} more of the kind '{}' (--all lists them)\n", count,
                        geometry::toString(kind));
  if (const std::string rest = notComparedText(contacts, contacts.pairs.empty()); !rest.empty())
    text += rest + "\n";
  return text;
}

}  // namespace af2::cli
