#include "dsl/netgen/rls_file.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "dsl/netgen/rls_reader.h"
#include "dsl/netgen/rls_rule_check.h"
#include "dsl/text/characters.h"
#include "dsl/text/words.h"

namespace af2::dsl {
namespace {

constexpr std::array<std::string_view, 10> kClauses{
    "quality",  "mappoints", "maplines", "newpoints",    "newlines",
    "freearea", "freearea2", "elements", "orientations", "endrule"};

/// Words that occur only in rules for tetrahedra, whose files have the same form.
constexpr std::array<std::string_view, 7> kSolidClauses{
    "freezone", "freezone2", "freezonelimit", "mapfaces", "newfaces", "mapedges", "elements3"};

/// Words of those files that do not show whether a rule fills volumes.
constexpr std::array<std::string_view, 3> kSolidSettings{"freeset", "flags", "tolfak"};

/// Limits above the needs of any rule or file.
constexpr std::size_t kMaxParts = 64, kMaxRules = 1000;

/// The clause that differs from a word in at most two letters; empty if there is none. Other words
/// are ignored, as Netgen does.
std::string_view nearestClause(std::string_view word) {
  std::string_view best;
  std::size_t least = 3;
  for (std::string_view clause : kClauses) {
    if (word.size() > 20) break;
    const std::size_t distance = editDistance(word, clause);
    if (distance < least) best = clause, least = distance;
  }
  return best;
}

bool isOneOf(const RlsToken& token, std::span<const std::string_view> words) {
  return token.kind == RlsTokenKind::Word &&
         std::ranges::any_of(words, [&](std::string_view word) { return token.is(word); });
}

bool isClause(const RlsToken& token) { return isOneOf(token, kClauses); }

class Reader : RlsReader {
 public:
  using RlsReader::RlsReader;

  std::vector<RlsRule> read() {
    if (!comments().empty())
      tell(Code::NetgenStrayText, comments().front(),
           "such files cannot contain comments; they are ignored here",
           comments().size() > 1 ? "there are " + std::to_string(comments().size()) + " of them"
                                 : "");
    while (now().kind != RlsTokenKind::End) {
      if (beginsRule()) {
        readRule();
        if (rules_.size() <= kMaxRules) continue;
        tell(Code::NetgenContradiction, now().span, "more than 1000 rules in one file", "split it");
        break;
      } else {
        passOver();
      }
    }
    return std::move(rules_);
  }

 private:
  /// The word `rule` in text between rules does not begin a rule if neither a name nor clauses
  /// follow.
  bool beginsRule() const {
    if (!now().is("rule")) return false;
    if (ahead(1).kind == RlsTokenKind::String) return true;
    for (std::size_t n = 1; ahead(n).kind != RlsTokenKind::End && !ahead(n).is("rule"); ++n)
      if (isClause(ahead(n))) return true;
    return false;
  }

  /// A rule for volumes is reported once as such, instead of once for each unknown clause.
  bool passOverSolidRule() {
    std::size_t length = 1;
    bool isSolid = false;
    RlsToken solid;
    for (; ahead(length).kind != RlsTokenKind::End && !ahead(length).is("endrule"); ++length) {
      const RlsToken& token = ahead(length);
      if (token.is("rule") && ahead(length + 1).kind == RlsTokenKind::String) break;
      if (isSolid || !isOneOf(token, kSolidClauses)) continue;
      isSolid = true;
      solid = token;
    }
    if (!isSolid) return false;
    tellSolid(solid);
    skip(length);
    if (now().is("endrule")) next();
    return true;
  }

  void tellSolid(const RlsToken& token) {
    tell(Code::NetgenVolumeRule, token.span,
         shown(token) + " belongs to rules that fill volumes with tetrahedra",
         "AF2 meshes surfaces: import a rule file for surfaces");
  }

  // Text between rules is ignored, so a rule with a misspelt 'rule' is lost.
  void passOver() {
    const RlsToken first = now();
    bool looksLikeRule = false;
    Span last = first.span;
    while (now().kind != RlsTokenKind::End && !beginsRule()) {
      looksLikeRule |= isClause(now());
      last = now().span;
      next();
    }
    tell(
        Code::NetgenStrayText, looksLikeRule ? first.span : cover(first.span, last),
        looksLikeRule ? "a rule is lost here: it does not begin with the word 'rule'"
                      : "this text is outside of the rules and is ignored",
        looksLikeRule ? "write 'rule' where it says " + shown(first) + " to have it imported" : "");
  }

  void readRule() {
    rule_ = {};
    begin();
    rule_.span = now().span;
    const Span word = now().span;
    if (passOverSolidRule()) return;
    tellCapitals(now());
    next();
    if (now().kind == RlsTokenKind::String) {
      rule_.name = std::string(now().text.substr(1, now().text.size() - 2));
      beAbout(rule_.name);
      rule_.span = now().span;
      next();
    } else {
      tell(Code::NetgenSyntax, now().span, "a rule has a name in quotes",
           "write: rule \"its name\"", "instead of " + shown(now()));
    }
    while (!now().is("endrule")) {
      if (now().kind == RlsTokenKind::End ||
          (now().is("rule") && ahead(1).kind == RlsTokenKind::String)) {
        tell(Code::NetgenSyntax, word, "this rule does not end", "close it with 'endrule'");
        return;
      }
      readClauseOrRecover();
    }
    tellCapitals(now());
    next();
    if (isSound()) checkRlsRule(rule_, *this);
    if (isSound()) rules_.push_back(std::move(rule_));
    rule_ = {};
    begin();
  }

  void readClauseOrRecover() {
    try {
      readClause();
    } catch (const Unreadable&) {
      toNextClause();
    }
  }

  void readClause() {
    const RlsToken clause = now();
    if (!isClause(clause)) return passOverClause(clause);
    tellCapitals(clause);
    next();
    if (clause.is("quality")) readQuality(clause);
    if (clause.is("mappoints")) readAll([&] { readMapPoint(); });
    if (clause.is("maplines")) readAll([&] { readMapLine(); });
    if (clause.is("newpoints")) readAll([&] { readPoint(rule_.newPoints); });
    if (clause.is("freearea")) readAll([&] { readPoint(rule_.freeArea); });
    if (clause.is("freearea2")) readAll([&] { readPoint(rule_.freeArea2); });
    if (clause.is("newlines")) readAll([&] { readTuple(rule_.newLines, 2, 2); });
    if (clause.is("elements")) readAll([&] { readTuple(rule_.elements, 3, 4); });
    if (clause.is("orientations")) readAll([&] { readTuple(rule_.orientations, 3, 3); });
  }

  void tellCapitals(const RlsToken& keyword) {
    const std::string usual = lowered(keyword.text);
    if (keyword.text == usual) return;
    tell(Code::NetgenIdlePart, keyword.span,
         "Netgen ignores " + shown(keyword) + ": its keywords are in lower case",
         "it is read as '" + usual + "' here");
  }

  /// The reader of Netgen also ignores words that are not clauses, but they may be mistakes.
  void passOverClause(const RlsToken& token) {
    const std::string_view meant = nearestClause(lowered(token.text));
    if (!meant.empty()) {
      tell(Code::NetgenSyntax, token.span, shown(token) + " is not a clause of a rule",
           "did you mean '" + std::string(meant) + "'?");
    } else if (isOneOf(token, kSolidSettings)) {
      tell(Code::NetgenStrayText, token.span,
           shown(token) + " belongs to rules that fill volumes, and is ignored here", "");
    } else {
      tell(Code::NetgenStrayText, token.span,
           shown(token) + " is not a clause of a rule: it is ignored",
           "clauses are quality, mappoints, maplines, newpoints, newlines, freearea, "
           "freearea2, elements, orientations, endrule");
    }
    next();
    toNextClause();
  }

  void toNextClause() {
    while (now().kind != RlsTokenKind::End && !isClause(now()) && !now().is("rule")) next();
  }

  template <class Read>
  void readAll(Read read) {
    if (!now().is("(")) {
      if (!isClause(now())) unreadable("'('");
      return;  // a clause without parts
    }
    while (now().is("(")) read();
  }

  void readQuality(const RlsToken& clause) {
    const RlsToken value = now();
    rule_.quality = wholeNumber("a quality");
    rule_.qualitySpan = cover(clause.span, value.span);
    if (now().is(";")) next();
  }

  RlsForm readForm() {
    RlsForm form;
    const Span open = now().span;
    expect("{");
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) expect(",");
      form.weights[i] = number();
    }
    form.span = cover(open, now().span);
    expect("}");
    return form;
  }

  /// `{...}` and `del`, in any order, up to the ';'.
  template <class Part>
  void readRest(Part& part) {
    while (!now().is(";")) {
      if (now().is("{")) {
        part.form = readForm();
      } else if (now().is("del")) {
        part.isDeleted = true;
        next();
      } else {
        passOverPart("'{', 'del' or ';'");
      }
    }
    part.span = cover(part.span, now().span);
    next();
  }

  /// Skips text without a meaning between a part and its ';'.
  void passOverPart(const std::string& wanted) {
    if (now().kind != RlsTokenKind::Word || isClause(now()) || now().is("rule")) unreadable(wanted);
    tell(Code::NetgenIdlePart, now().span, shown(now()) + " has no effect here", "");
    next();
  }

  void expectEnd() {
    while (!now().is(";")) passOverPart("';'");
    next();
  }

  /// (X, Y)
  template <class Point>
  Point pointHere() {
    Point point;
    point.span = now().span;
    expect("(");
    point.x = number();
    expect(",");
    point.y = number();
    expect(")");
    return point;
  }

  void readMapPoint() {
    auto point = pointHere<RlsMapPoint>();
    readRest(point);
    rule_.mapPoints.push_back(std::move(point));
    limit(rule_.mapPoints, kMaxRlsPoints, "mappoints");
  }

  void readMapLine() {
    RlsLine line;
    line.span = now().span;
    expect("(");
    line.from = wholeNumber("the number of a point");
    expect(",");
    line.to = wholeNumber("the number of a point");
    expect(")");
    readRest(line);
    rule_.mapLines.push_back(std::move(line));
    limit(rule_.mapLines, kMaxRlsPoints, "maplines");
  }

  /// X2, or X 2.
  void readCoordinate(RlsTerm& term) {
    const RlsToken of = now();
    const bool isApart = of.text.size() == 1 && ahead(1).kind == RlsTokenKind::Number;
    const std::string_view number =
        isApart ? ahead(1).text : of.text.substr(of.text.empty() ? 0 : 1);
    const bool isCoordinate =
        of.kind == RlsTokenKind::Word &&
        (of.text[0] == 'x' || of.text[0] == 'X' || of.text[0] == 'y' || of.text[0] == 'Y') &&
        !number.empty() && number.size() <= 4 && std::ranges::all_of(number, isDigit);
    if (!isCoordinate) unreadable("a coordinate such as X2 or Y3");
    term.isX = of.text[0] == 'x' || of.text[0] == 'X';
    term.point = std::stoi(std::string(number));
    if (isApart) next();
    term.span = cover(term.span, now().span);
    next();
  }

  std::vector<RlsTerm> readRow() {
    std::vector<RlsTerm> row;
    expect("{");
    while (!now().is("}")) {
      RlsTerm term;
      term.span = now().span;
      term.coefficient = number();
      readCoordinate(term);
      row.push_back(std::move(term));
      if (row.size() > kMaxParts) unreadable("'}'");
      if (now().is(",")) next();
    }
    next();
    return row;
  }

  void readPoint(std::vector<RlsPoint>& points) {
    auto point = pointHere<RlsPoint>();
    for (auto& row : point.rows)
      if (now().is("{")) row = readRow();
    point.span = cover(point.span, now().span);
    expectEnd();
    points.push_back(std::move(point));
    limit(points, kMaxParts, "points");
  }

  void readTuple(std::vector<RlsTuple>& tuples, std::size_t least, std::size_t most) {
    RlsTuple tuple;
    tuple.span = now().span;
    expect("(");
    tuple.points.push_back(wholeNumber("the number of a point"));
    while (now().is(",")) {
      next();
      tuple.points.push_back(wholeNumber("the number of a point"));
      if (tuple.points.size() > most) unreadable("')'");
    }
    if (tuple.points.size() < least) unreadable("',' and the number of a further point");
    expect(")");
    tuple.span = cover(tuple.span, now().span);
    expectEnd();
    tuples.push_back(std::move(tuple));
    limit(tuples, kMaxParts, "parts");
  }

  template <class Part>
  void limit(const std::vector<Part>& parts, std::size_t most, const std::string& what) {
    if (parts.size() <= most) return;
    tell(Code::NetgenContradiction, parts.back().span,
         "more than " + std::to_string(most) + " " + what + " in one rule", "");
    throw Unreadable{};
  }

  std::vector<RlsRule> rules_;
  RlsRule rule_;
};

}  // namespace

std::vector<RlsRule> readRls(const SourceText& source, DiagnosticList& diagnostics) {
  return Reader(source, diagnostics).read();
}

}  // namespace af2::dsl
