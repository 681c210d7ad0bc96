// Case distinction over the variants of the syntax tree.
//
// Every alternative must be named, so that code does not compile until it handles an alternative
// that is added later.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>
#include <variant>

namespace af2::dsl {

/// Combines several functions into one; the type of the argument selects the function.
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;  // Clang 16 does not deduce it from the aggregate

/// One of these types: for a case that handles several alternatives, or ignores them. Do not use
/// `const auto&`: it would also accept alternatives that are added later.
template <class T, class... Alternatives>
concept AnyOf = (std::same_as<T, Alternatives> || ...);

/// The result of the case for the alternative in `content`. Every alternative needs a case.
template <class... Alternatives, class... Cases>
decltype(auto) match(const std::variant<Alternatives...>& content, Cases&&... cases) {
  static_assert((std::invocable<Overloaded<std::decay_t<Cases>...>, const Alternatives&> && ...),
                "an alternative of the syntax tree has no case here");
  return std::visit(Overloaded<std::decay_t<Cases>...>{std::forward<Cases>(cases)...}, content);
}

}  // namespace af2::dsl
