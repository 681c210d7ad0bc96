// What can stand at a place, as a list to choose from.
#pragma once

#include <string>
#include <vector>

#include "cli/lsp/session.h"
#include "dsl/symbols/block_context.h"

namespace af2::lsp {

/// Kinds as the protocol numbers them.
enum class ItemKind {
  Function = 3,
  Field = 5,
  Variable = 6,
  Class = 7,
  Module = 9,
  Value = 12,
  Keyword = 14,
  File = 17,
  Reference = 18,
  Folder = 19,
  Constant = 21,
};

/// Collects items. What is nearer to the place comes first: names of the block, of the file, of the
/// language, then its words.
class ItemList {
 public:
  enum class Rank { Local = 1, File = 2, Language = 3, Word = 4 };

  ItemList(const Session& session, const Place& place, const dsl::BlockContext& context);

  /// Replaces what has been typed of the word.
  Json& add(Rank rank, ItemKind kind, const std::string& label, const std::string& detail = {},
            const std::string& meaning = {});
  void addWords(std::span<const std::string_view> words);
  void addWords(std::initializer_list<std::string_view> words) {
    addWords(std::span(words.begin(), words.size()));
  }
  /// What may begin a clause of a block, with what it means; with a skeleton if the editor can fill
  /// one in.
  void addKeywords(dsl::BlockKind block);

  const dsl::BlockContext& context() const { return context_; }
  const Place& place() const { return place_; }
  const Session& session() const { return session_; }
  Json take() { return {{"isIncomplete", false}, {"items", std::move(items_)}}; }

 private:
  const Session& session_;
  const Place& place_;
  const dsl::BlockContext& context_;
  TextMap map_;
  Json range_;
  Json items_ = Json::array();
};

/// Titles, paths and names inside of quotes.
void addInString(ItemList& list);
/// Whatever an expression may use here.
void addExpression(ItemList& list);
/// Vertices of the rule or of the test around the place.
void addVertices(ItemList& list);
/// Vertices of a rule elsewhere.
void addVerticesOfRule(ItemList& list, const std::string& title);
void addImports(ItemList& list);
void addTemplates(ItemList& list);
void addMetrics(ItemList& list);
/// What stands behind `lib.`, or the parts of a point.
void addMembers(ItemList& list, const std::string& owner);

}  // namespace af2::lsp
