#include "dsl/syntax/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "dsl/text/characters.h"

namespace af2::dsl {
namespace {

/// Longest first, so that `<=` is not read as `<` and `=`.
constexpr std::array<std::string_view, 26> kSymbols{
    "->", "=>", "..", "<=", ">=", "==", "!=", "<", ">", "=", "+", "-", "*",
    "/",  "^",  "(",  ")",  "{",  "}",  ",",  ";", ":", ".", "~", "|", "&"};

class Lexer {
 public:
  Lexer(const SourceText& source, DiagnosticList& diagnostics)
      : source_(source), text_(source.text()), diagnostics_(diagnostics) {}

  TokenList read(std::size_t most) {
    constexpr std::size_t kBytesPerWord = 3;  // or more
    result_.tokens.reserve(std::min(most, text_.size() / kBytesPerWord) + 2);
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    if (isText())
      while (at_ < text_.size() && result_.tokens.size() <= most) readOne();
    result_.isCut = result_.tokens.size() > most;
    add(TokenKind::End, at_, "");
    return std::move(result_);
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  static Span spanOf(std::size_t from, std::size_t to) {
    return {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)};
  }

  void tell(Code code, std::size_t from, std::size_t to, std::string message, std::string help) {
    isDoubtful_ = true;
    if (!diagnostics_.takes(Severity::Error)) return;
    Diagnostic d(code);
    d.message = std::move(message);
    d.place = placeOf(source_, spanOf(from, to));
    d.help = std::move(help);
    diagnostics_.add(std::move(d));
  }

  void add(TokenKind kind, std::size_t from, std::string text, double number = 0) {
    Token token{kind, spanOf(from, at_), std::move(text), number, std::move(doc_), lineIsEmpty_};
    token.isDoubtful = std::exchange(isDoubtful_, false);
    doc_.clear();
    lineIsEmpty_ = false;
    result_.tokens.push_back(std::move(token));
  }

  /// Reports faults of the file as a whole. Returns false if the file cannot be read.
  bool isText() {
    const auto fault = findUnreadable(text_);
    if (!fault) return true;
    tell(Code::UnknownCharacter, fault->from, fault->to, fault->fault, fault->help);
    if (!fault->isHopeless) return true;
    result_.isText = false;
    return false;
  }

  void readOne() {
    const char c = peek();
    if (c == '\n') {
      ++at_;
      lineIsEmpty_ = true;
      toldOnLine_.clear();
    } else if (c == ' ' || c == '\t' || c == '\r') {
      ++at_;
    } else if (c == '#') {
      readComment();
    } else if (c == '"') {
      readString("\"");
    } else if (isNameStart(c) || beginsWithForeignLetter(rest())) {
      readName();
    } else if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
      readNumber();
    } else if (!readConflictMarker() && !readForeignComment() && !readLookAlike()) {
      readSymbol();
    }
  }

  std::string_view rest() const { return text_.substr(at_); }

  void skipTo(std::size_t end) { at_ = std::min(end, text_.size()); }

  /// Conflict markers of a merge of two versions; reported at the first marker.
  bool readConflictMarker() {
    const bool opens = rest().starts_with("<<<<<<<");
    if (!lineIsEmpty_ || !(opens || rest().starts_with("=======") || rest().starts_with(">>>>>>>")))
      return false;
    if (opens || !isInConflict_)
      tell(Code::UnknownCharacter, at_, at_ + 7,
           "a conflict between two versions of this file is left here",
           "keep one of them, and delete the lines of <, = and >");
    isInConflict_ = true;
    isDoubtful_ = false;  // nothing is missing
    skipTo(text_.find('\n', at_));
    return true;
  }

  /// The beginning of a comment in another language.
  bool readForeignComment() {
    const bool isBlock = rest().starts_with("/*");
    const bool isLine = rest().starts_with("//") || (lineIsEmpty_ && rest().starts_with("-- "));
    if (!isBlock && !isLine) return false;
    tell(Code::UnknownCharacter, at_, at_ + 2,
         "'" + std::string(text_.substr(at_, 2)) + "' does not begin a comment",
         "a comment begins with '#' and runs to the end of its line");
    isDoubtful_ = false;  // nothing is missing
    const std::size_t close = isBlock && !isLastBlock_ ? text_.find("*/", at_ + 2) : text_.npos;
    isLastBlock_ = isLastBlock_ || (isBlock && close == text_.npos);
    skipTo(close != text_.npos ? close + 2 : text_.find('\n', at_));
    return true;
  }

  /// Reported once on each line, and read as the intended character.
  bool readLookAlike() {
    const LookAlike* found = lookAlikeAt(rest());
    if (!found) return false;
    const std::size_t from = at_;
    const std::size_t to = at_ + found->written.size();
    const std::string meant(found->meant);
    const bool isQuote = meant == "\"" || meant == "'";
    if (toldOnLine_.insert(std::string(found->written)).second)
      tell(Code::UnknownCharacter, from, to,
           found->name.empty() ? "unknown character '" + std::string(found->written) + "'"
                               : "this is " + std::string(found->name),
           isQuote        ? "write strings in plain double quotes: \"...\""
           : meant == " " ? "write a plain space"
                          : "write '" + meant + "'");
    if (isQuote) {
      readString(found->written);
      return true;
    }
    at_ = to;
    isDoubtful_ = false;
    if (meant != " ") add(isNameStart(meant[0]) ? TokenKind::Name : TokenKind::Symbol, from, meant);
    return true;
  }

  void readComment() {
    const std::size_t from = at_;
    while (at_ < text_.size() && peek() != '\n') ++at_;
    std::string text(text_.substr(from, at_ - from));
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ' || text.back() == '\t'))
      text.pop_back();
    if (text.starts_with("##") && lineIsEmpty_) {
      std::string_view line = std::string_view(text).substr(2);
      if (line.starts_with(' ')) line.remove_prefix(1);
      if (!doc_.empty()) doc_ += '\n';
      doc_ += line;
    } else if (lineIsEmpty_) {
      doc_.clear();  // a plain comment separates a doc comment from the item after it
    }
    const auto length = text.size();
    result_.comments.push_back({spanOf(from, from + length), std::move(text), lineIsEmpty_});
  }

  void readName() {
    const std::size_t from = at_;
    bool isPlain = true;
    for (;;) {
      const bool isForeign = beginsWithForeignLetter(rest());
      if (!isForeign && !isNamePart(peek())) break;
      isPlain = isPlain && !isForeign;
      at_ += isForeign ? characterSize(rest()) : 1;
    }
    std::string name(text_.substr(from, at_ - from));
    if (!isPlain) name = toldForeignName(from, std::move(name));
    add(TokenKind::Name, from, std::move(name));
  }

  /// Each name is reported once. A name that looks like a plain name is read as that name.
  std::string toldForeignName(std::size_t from, std::string name) {
    const auto plain = plainSpelling(name);
    if (!toldNames_.insert(name).second) return plain.value_or(std::move(name));
    if (!plain) {
      tell(Code::UnknownCharacter, from, at_,
           "a name may hold only the letters a-z, A-Z, digits and '_'",
           "write the name without accents and special characters");
      return name;
    }
    tell(Code::UnknownCharacter, from, at_,
         "this only looks like '" + *plain + "': it has letters of another alphabet",
         "write '" + *plain + "' in plain letters");
    isDoubtful_ = false;
    return *plain;
  }

  /// digits, a fraction, an exponent; `1..30` is the number 1 and then `..`.
  void readNumber() {
    const std::size_t from = at_;
    while (isDigit(peek())) ++at_;
    if (peek() == '.' && isDigit(peek(1))) {
      ++at_;
      while (isDigit(peek())) ++at_;
    }
    const bool hasExponent =
        (peek() == 'e' || peek() == 'E') &&
        (isDigit(peek(1)) || ((peek(1) == '+' || peek(1) == '-') && isDigit(peek(2))));
    if (hasExponent) {
      at_ += 2;
      while (isDigit(peek())) ++at_;
    }
    const std::size_t end = at_;
    if (!checkNumberEnd(from)) return;
    addNumber(from, end);
  }

  /// Whether a number may end here; if not, reports it and adds a number in its place.
  bool checkNumberEnd(std::size_t from) {
    const bool runsOn = (isNameStart(peek()) && !isUnit()) || beginsWithForeignLetter(rest()) ||
                        (peek() == '.' && peek(1) != '.');
    if (!runsOn) return true;
    while (isNamePart(peek()) || beginsWithForeignLetter(rest()) ||
           (peek() == '.' && peek(1) != '.'))
      at_ += characterSize(rest());
    const std::string written(text_.substr(from, at_ - from));
    tell(Code::MalformedNumber, from, at_, "'" + written + "' is not a number",
         "numbers are written 12, 1.5, .5 or 2e-3; angles 60deg");
    add(TokenKind::Number, from, written, 1);
    return false;
  }

  bool isUnit() const {
    return text_.substr(at_).starts_with("deg") && !isNamePart(peek(3)) &&
           !beginsWithForeignLetter(text_.substr(at_ + 3));
  }

  void addNumber(std::size_t from, std::size_t end) {
    const std::string_view digits = text_.substr(from, end - from);
    double value = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (parsed.ec != std::errc() || !std::isfinite(value)) {
      const bool isTiny = value == 0 && digits.find("e-") != std::string_view::npos;
      tell(Code::MalformedNumber, from, end,
           "the number " + std::string(digits.substr(0, 40)) +
               (isTiny ? " is too small" : " is too large"),
           "the size of a number must lie between about 1e-300 and 1e300");
      value = 1;
    }
    add(TokenKind::Number, from, std::string(digits), value);
  }

  /// The size of the quote, plain or typographic, that ends the string here; 0 if there is none.
  std::size_t closingSize(std::string_view opening) const {
    if (peek() == '"') return opening == "'" ? 0 : 1;
    if (opening == "'") return peek() == '\'' ? 1 : 0;
    const LookAlike* quote = opening == "\"" ? nullptr : lookAlikeAt(rest());
    return quote && (quote->meant == "\"" || quote->meant == "'") ? quote->written.size() : 0;
  }

  /// `opening` is the character at at_: a quote or a look-alike.
  void readString(std::string_view opening) {
    const std::size_t from = at_;
    at_ += opening.size();
    const std::size_t contentFrom = at_;
    std::string value;
    while (at_ < text_.size() && closingSize(opening) == 0 && peek() != '\n') {
      if (peek() == '\\') {
        if (peek(1) == '"' || peek(1) == '\\') {
          value += peek(1);
          at_ += 2;
          continue;
        }
        tell(Code::UnknownEscape, at_, at_ + 2, "unknown escape in a string",
             "only \\\" and \\\\ have a meaning after a backslash");
      }
      value += text_[at_++];
    }
    if (at_ < text_.size() && peek() != '\n')
      at_ += closingSize(opening);
    else
      value = unclosedString(from, contentFrom);
    add(TokenKind::String, from, std::move(value));
  }

  /// Usually the closing quote is missing. Then `{` or `;` at the end of the line is not a part of
  /// the string, so it is read again as a symbol.
  std::string unclosedString(std::size_t from, std::size_t contentFrom) {
    const std::size_t lineEnd = at_;
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (at_ > contentFrom && isBlank(text_[at_ - 1])) --at_;
    const bool givesBack = at_ > contentFrom && (text_[at_ - 1] == '{' || text_[at_ - 1] == ';');
    if (givesBack) --at_;
    while (givesBack && at_ > contentFrom && isBlank(text_[at_ - 1])) --at_;
    if (!givesBack) at_ = lineEnd;
    tell(Code::UnclosedString, from, at_, "this string is not closed",
         "end it with \" on the same line");
    return std::string(text_.substr(contentFrom, at_ - contentFrom));
  }

  void readSymbol() {
    const std::size_t from = at_;
    if (rest().starts_with("...")) {
      at_ += 3;
      tell(Code::UnknownCharacter, from, at_, "'...' has no meaning here",
           "a range is written 1..50");
      isDoubtful_ = false;
      return add(TokenKind::Symbol, from, "..");
    }
    for (std::string_view symbol : kSymbols) {
      if (!rest().starts_with(symbol)) continue;
      at_ += symbol.size();
      return add(TokenKind::Symbol, from, std::string(symbol));
    }
    if (peek() == '[' || peek() == ']') return readSquareBracket();
    if (peek() == '\'' &&
        text_.substr(at_ + 1, text_.find('\n', at_) - at_).find('\'') != text_.npos) {
      tell(Code::UnknownCharacter, at_, at_ + 1, "a string begins with a double quote",
           "write \"...\"");
      isDoubtful_ = false;
      return readString("'");
    }
    readUnknown();
  }

  /// A square bracket is read as a parenthesis, and reported where it opens.
  void readSquareBracket() {
    const bool opens = peek() == '[';
    ++at_;
    if (opens || openBrackets_ == 0)
      tell(Code::UnknownCharacter, at_ - 1, at_,
           std::string("unknown character '") + text_[at_ - 1] + "'",
           "points and vectors are written (x, y)");
    openBrackets_ = opens ? openBrackets_ + 1 : std::max(0, openBrackets_ - 1);
    isDoubtful_ = true;
    add(TokenKind::Symbol, at_ - 1, opens ? "(" : ")");
  }

  void readUnknown() {
    const std::size_t from = at_;
    const auto isKnown = [&](char c) {
      return isNamePart(c) || c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '#' ||
             c == '"' || c == '\'' || c == '[' || c == ']' ||
             std::string_view("-=<>.+*/^(){},;:~|&").find(c) != std::string_view::npos;
    };
    do ++at_;
    while (at_ < text_.size() && !isKnown(text_[at_]) && !lookAlikeAt(rest()));
    const std::string_view written = text_.substr(from, at_ - from);
    isDoubtful_ = true;
    if (isMalformedCharacter(written)) return;  // reported for the whole file
    tell(Code::UnknownCharacter, from, at_,
         "unknown character" + std::string(written.size() > characterSize(written) ? "s " : " ") +
             shownUnknown(written),
         helpForUnknown(written));
  }

  const SourceText& source_;
  std::string_view text_;
  DiagnosticList& diagnostics_;
  TokenList result_;
  std::size_t at_ = 0;
  std::string doc_;
  std::set<std::string> toldNames_, toldOnLine_;
  int openBrackets_ = 0;  ///< square ones
  bool isInConflict_ = false;
  bool isLastBlock_ = false;  ///< no more end markers of comments of another language follow
  bool lineIsEmpty_ = true;
  bool isDoubtful_ = false;
};

}  // namespace

TokenList readTokens(const SourceText& source, DiagnosticList& diagnostics, std::size_t most) {
  return Lexer(source, diagnostics).read(most);
}

}  // namespace af2::dsl
