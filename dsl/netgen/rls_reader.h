// Reads the words of a rule file of Netgen one by one.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "dsl/netgen/rls_file.h"
#include "dsl/netgen/rls_tokens.h"

namespace af2::dsl {

/// Thrown if a part cannot be read; the reader continues at the next clause.
struct Unreadable {};

/// The common part of readers of such files: position, diagnostics, numbers.
class RlsReader {
 public:
  RlsReader(const SourceText& source, DiagnosticList& diagnostics)
      : tokens_(rlsTokensOf(source.text(), &comments_)),
        source_(source),
        diagnostics_(diagnostics) {}

  void tell(Code code, Span span, std::string message, std::string help, std::string label = {});

 protected:
  const RlsToken& now() const { return tokens_[at_]; }
  const RlsToken& ahead(std::size_t n) const {
    return tokens_[std::min(at_ + n, tokens_.size() - 1)];
  }
  void next() {
    if (now().kind != RlsTokenKind::End) ++at_;
  }
  void skip(std::size_t count) { at_ = std::min(at_ + count, tokens_.size() - 1); }
  const std::vector<Span>& comments() const { return comments_; }

  /// A part of the file that can later be asked whether it had errors.
  void begin() {
    about_.clear();
    isSound_ = true;
  }
  /// Sets the rule that following diagnostics name.
  void beAbout(const std::string& rule) { about_ = rule; }
  /// Whether no error has been reported since the part began.
  bool isSound() const { return isSound_; }

  [[noreturn]] void unreadable(const std::string& wanted);
  void expect(std::string_view sign);
  Exact number();
  int wholeNumber(const std::string& what);
  static std::string shown(const RlsToken& token);

 private:
  std::vector<Span> comments_;
  std::vector<RlsToken> tokens_;
  std::size_t at_ = 0;
  const SourceText& source_;
  DiagnosticList& diagnostics_;
  std::string about_;
  bool isSound_ = true;
};

}  // namespace af2::dsl
