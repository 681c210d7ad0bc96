// The keywords of the language in one table: what begins an item of a file or a clause of a block.
//
// One row says all that is said about a clause apart from its tree, its grammar and its meaning.
// From it follow the words that the parser recovers at, "did you mean", the form shown where a
// clause is broken, completion and hover in editors, the colours of the TextMate grammar, and the
// grammar in docs/language.md (tests compare the last two).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace af2::dsl {

/// Where a keyword stands.
enum class BlockKind { File, Rule, RuleSet, Test, Property, Mirror, Meta };

/// What a name in a clause stands for.
enum class NameRole {
  Vertex,        ///< a vertex that is defined elsewhere
  ChainVertex,   ///< the same in a chain, which is where a vertex without a place is defined
  PlacedVertex,  ///< defined: a vertex with its place
  NewVertex,     ///< defined: a vertex that the rule makes
  Value,         ///< defined: a name for a value
  TestVertex,    ///< defined: a vertex of a test, with its place
  MirrorTitle,   ///< defined: the title of the mirror image
  RuleTitle,     ///< a rule
  RuleVertex,    ///< a vertex of the rule that was named last
};

/// What may follow a keyword, for completion.
enum class Follows {
  Nothing,           ///< a name or title of one's own, or a block
  Expression,        ///< an expression; besides it the words of the row
  Words,             ///< one of the words of the row
  Vertices,          ///< vertices only
  VerticesAndForms,  ///< vertices, and behind `~` how far they may deviate
  Definitions,       ///< names of one's own with expressions
  Header,            ///< several parts, each with a choice of its own
};

struct Keyword {
  BlockKind block = BlockKind::File;
  std::string_view word = {};
  std::string_view form = {};  ///< an example that can be read and printed; "..." stands for a body
  std::string_view otherForm = {};  ///< of a clause that is written in two ways
  std::string_view grammar = {};    ///< in EBNF, on one line or two; empty: said by the row before
  std::string_view help = {};       ///< one sentence
  std::string_view snippet = {};    ///< a skeleton for editors that can fill one in
  Follows follows = Follows::Expression;
  std::span<const std::string_view> words = {};  ///< of the language, that may stand in it
  std::optional<NameRole> defines = {};          ///< what the names are that it defines
  bool isReserved = false;                       ///< whether the word cannot be a name
};

/// All rows; those of a block in the order in which they are listed to users.
std::span<const Keyword> keywords();
/// The first row of a word in a block; null if none has it.
const Keyword* findKeyword(BlockKind block, std::string_view word);
/// The words that begin an item or a clause there, each once.
std::span<const std::string_view> keywordsOf(BlockKind block);

/// The form in backticks, or both.
std::string shownForm(const Keyword& keyword);

/// Whether a word begins an item, or a clause of a rule, of a rule set or of a test.
bool isClauseWord(std::string_view word);

/// Words that cannot be names.
std::span<const std::string_view> reservedWords();
bool isReserved(std::string_view word);

// Choices among words, for the grammar, the compiler and completion.

template <std::size_t N>
using WordList = std::array<std::string_view, N>;

inline constexpr WordList<3> kElementKinds{"tri", "quad", "poly"};
inline constexpr WordList<3> kFolds{"max", "sum", "mean"};
inline constexpr WordList<2> kScaleUnits{"h", "base"};
inline constexpr WordList<2> kParities{"even", "any"};
inline constexpr WordList<2> kFrontOrders{"by", "rows"};
inline constexpr WordList<2> kRowStarts{"smallest_turn", "oldest"};
inline constexpr WordList<6> kOutcomes{"rule", "new", "front", "elements", "stuck", "score"};
/// Why a rule was refused, as tests name it; `zone hit by edge` and `zone hit by vertex` besides.
inline constexpr WordList<9> kReasons{"class",     "pattern",  "require", "novalue", "shape",
                                      "convexity", "inverted", "score",   "beaten"};
inline constexpr WordList<3> kMetaKeys{"allow", "author", "note"};

}  // namespace af2::dsl
