// Looking into the variants of the syntax tree: every alternative is named, so that one that is
// added later does not compile until each place says what it means there.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>
#include <variant>

namespace af2::dsl {

/// One function made of several, of which the type of the argument chooses.
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

/// One of these types: for a case that serves several alternatives, among them those that a place
/// leaves alone. Never `const auto&`, which would take in what is added later.
template <class T, class... Alternatives>
concept AnyOf = (std::same_as<T, Alternatives> || ...);

/// The result of the case that takes what `content` holds. Every alternative needs one.
template <class... Alternatives, class... Cases>
decltype(auto) match(const std::variant<Alternatives...>& content, Cases&&... cases) {
  static_assert((std::invocable<Overloaded<std::decay_t<Cases>...>, const Alternatives&> && ...),
                "an alternative of the syntax tree has no case here");
  return std::visit(Overloaded<std::decay_t<Cases>...>{std::forward<Cases>(cases)...}, content);
}

}  // namespace af2::dsl
