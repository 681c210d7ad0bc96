#include "geometry/occ/step/step_records.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace af2::geometry {

namespace {

constexpr std::string_view kNoLabel = "#0";

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isBlank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool isOfKeyword(char c) { return isLetter(c) || isDigit(c) || c == '_'; }
bool isOfEnumeration(char c) { return (c >= 'A' && c <= 'Z') || isDigit(c) || c == '_'; }

/// Each function that reads something returns whether it is there and plain.
///
/// Take  is called with the label, the type and the values of each record
template <class Take>
class Parser {
 public:
  /// text  ends with a zero, and has no other
  Parser(const std::string& text, std::deque<std::string>& listLabels, const Take& take)
      : at_(text.data()), end_(at_ + text.size()), listLabels_(listLabels), take_(take) {}

  /// The head, with the word that begins the data.
  bool head() {
    if (!section("ISO-10303-21;") || !section("HEADER;") || !part(kNoLabel)) return false;
    for (;;) {
      if (!symbol(';')) return false;
      if (section("ENDSEC;")) return section("DATA;");
      if (!part(kNoLabel)) return false;
    }
  }

  /// The data, to the end of the file.
  bool data() {
    do
      if (!entity()) return false;
    while (!section("ENDSEC;"));
    return section("END-ISO-10303-21;");
  }

 private:
  /// A record whose list is not closed yet.
  struct Open {
    std::string_view label, type;
    std::size_t firstValue = 0;  ///< in values_
  };

  /// A comment that does not end is not skipped.
  void skipBlanks() {
    for (;;) {
      while (isBlank(*at_)) ++at_;
      if (at_[0] != '/' || at_[1] != '*') return;
      const std::string_view rest(at_ + 2, end_);
      const std::size_t length = rest.find("*/");
      if (length == rest.npos) return;
      at_ += length + 4;
    }
  }

  bool symbol(char c) {
    skipBlanks();
    if (*at_ != c) return false;
    ++at_;
    return true;
  }

  bool section(std::string_view word) {
    skipBlanks();
    if (!std::string_view(at_, end_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }

  template <class IsPart>
  std::string_view wordOf(const IsPart& isPart) {
    const char* const begin = at_;
    while (isPart(*at_)) ++at_;
    return {begin, at_};
  }

  /// `#12`
  std::optional<std::string_view> label() {
    skipBlanks();
    const char* const begin = at_;
    if (*at_ != '#') return std::nullopt;
    ++at_;
    if (wordOf(isDigit).empty()) return std::nullopt;
    return std::string_view(begin, at_);
  }

  /// `#12 = PART(...);` or `#12 = (PART(...) PART(...));`
  bool entity() {
    const auto own = label();
    if (!own || !symbol('=')) return false;  // OpenCASCADE's parser wants both in one line
    if (!symbol('(')) return part(*own) && symbol(';');
    if (!part(*own)) return false;
    while (!symbol(')'))
      if (!part(kNoLabel)) return false;
    return symbol(';');
  }

  std::optional<std::string_view> keyword() {
    skipBlanks();
    if (!isLetter(*at_)) return std::nullopt;
    const std::string_view word = wordOf(isOfKeyword);
    constexpr std::string_view kEndOfScope = "ENDSCOPE";
    const auto isSame = [](char a, char b) { return (a & ~0x20) == b; };
    if (std::ranges::equal(word, kEndOfScope, isSame)) return std::nullopt;
    return word;
  }

  /// `KEYWORD(value, ...)`
  bool part(std::string_view label) {
    const auto type = keyword();
    if (!type || !symbol('(')) return false;
    listCount_ = 0;
    open_.push_back({label, *type, 0});
    return values();
  }

  /// The values of the part up to its last bracket. This does not call itself: lists may be in
  /// others to any depth.
  bool values() {
    enum class Next : std::uint8_t { ValueOrEnd, Value, CommaOrEnd };
    for (Next next = Next::ValueOrEnd;;) {
      skipBlanks();
      if (next == Next::CommaOrEnd && *at_ == ',') {
        ++at_;
        next = Next::Value;
      } else if (next != Next::Value && *at_ == ')') {
        ++at_;
        close();
        if (open_.empty()) return true;
        next = Next::CommaOrEnd;
      } else if (next != Next::CommaOrEnd && list()) {
        next = Next::ValueOrEnd;
      } else if (next != Next::CommaOrEnd && value()) {
        next = Next::CommaOrEnd;
      } else {
        return false;
      }
    }
  }

  /// The list that was opened last becomes a record, and a value of the one that it is in.
  void close() {
    const Open closed = open_.back();
    open_.pop_back();
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(closed.firstValue);
    take_(StepRecord{closed.label, closed.type, {first, values_.end()}});
    values_.erase(first, values_.end());
    if (!open_.empty()) values_.push_back({closed.label, StepKind::List});
  }

  /// The beginning of a list: `(` or `KEYWORD(`
  bool list() {
    if (symbol('(')) return openList(kListType);
    const char* const begin = at_;
    const auto type = keyword();
    if (type && symbol('(')) return openList(*type);
    at_ = begin;  // it is a value, or nothing that may be here
    return false;
  }

  bool openList(std::string_view type) {
    if (++listCount_ > listLabels_.size()) listLabels_.push_back('$' + std::to_string(listCount_));
    open_.push_back({listLabels_[listCount_ - 1], type, values_.size()});
    return true;
  }

  bool value() {
    switch (*at_) {
      case '#':
        return add(StepKind::Label, label());
      case '\'':
        return add(StepKind::Text, quoted());
      case '$':
        return add(StepKind::Omitted, std::string_view(at_++, 1));
      case '*':
        return add(StepKind::Derived, std::string_view(at_++, 1));
      default:
        return *at_ == '.' && isLetter(at_[1]) ? add(StepKind::Enumeration, enumeration())
                                               : number();
    }
  }

  bool add(StepKind kind, std::optional<std::string_view> word) {
    if (word) values_.push_back({*word, kind});
    return word.has_value();
  }

  /// As in OpenCASCADE's parser, a text ends where a comma or a bracket follows, so that one may
  /// have quotes that are not doubled.
  std::optional<std::string_view> quoted() {
    const char* const begin = at_;
    for (;;) {
      const std::string_view rest(at_ + 1, end_);
      const std::size_t quote = rest.find('\'');
      if (quote == rest.npos) return std::nullopt;
      at_ += quote + 1;
      const std::size_t after = rest.find_first_not_of(" \"\n\r", quote + 1);
      if (after == rest.npos) return std::nullopt;
      if (rest[after] == ',' || rest[after] == ')') return std::string_view(begin, ++at_);
    }
  }

  std::optional<std::string_view> enumeration() {
    const char* const begin = at_++;
    wordOf(isOfEnumeration);
    if (*at_ != '.') return std::nullopt;
    return std::string_view(begin, ++at_);
  }

  bool number() {
    const char* const begin = at_;
    const auto skipSign = [&] {
      if (*at_ == '+' || *at_ == '-') ++at_;
    };
    skipSign();
    std::size_t digits = wordOf(isDigit).size();
    const bool isReal = *at_ == '.';
    if (isReal) {
      ++at_;
      digits += wordOf(isDigit).size();
    }
    if (digits == 0) return false;
    if (isReal && *at_ == 'E') {
      ++at_;
      skipSign();
      if (wordOf(isDigit).empty()) return false;
    }
    return add(isReal ? StepKind::Real : StepKind::Integer, std::string_view(begin, at_));
  }

  const char* at_;
  const char* end_;  ///< where the zero is
  std::deque<std::string>& listLabels_;
  const Take& take_;
  std::vector<Open> open_;
  std::vector<StepValue> values_;  ///< of what is open
  std::size_t listCount_ = 0;      ///< in the part
};

}  // namespace

StepRecords::StepRecords(std::string& text) : text_(text) {
  if (text.find('\0') != text.npos) return;
  const auto count = [this](const StepRecord& record) {
    ++count_;
    valueCount_ += record.values.size();
  };
  Parser parser(text, listLabels_, count);
  if (!parser.head()) return;
  headCount_ = count_;
  arePlain_ = parser.data();
}

void StepRecords::forEach(const std::function<void(const StepRecord&)>& take) {
  const auto end = [this](std::string_view word) {
    text_[static_cast<std::size_t>(word.data() - text_.data()) + word.size()] = '\0';
  };
  const auto takeEnded = [&](const StepRecord& record) {
    const bool isList = record.label.front() == '$';
    if (!isList && record.label.data() != kNoLabel.data()) end(record.label);
    if (record.type != kListType) end(record.type);
    for (const StepValue& value : record.values)
      if (value.kind != StepKind::List) end(value.word);
    take(record);
  };
  Parser parser(text_, listLabels_, takeEnded);
  parser.head();
  parser.data();
}

}  // namespace af2::geometry
