#pragma once

#include <type_traits>
#include <variant>

namespace breccia {

/// Calls the visitor with the value inside a variant of variants. An example is the box of a stage: it has two or three
/// dimensions, and for each of them one of several contents.
template <class Visitor, class Nested>
decltype(auto) visit_nested(const Visitor& visitor, Nested& nested) {
  return std::visit([&visitor](auto& inner) -> decltype(auto) { return std::visit(visitor, inner); }, nested);
}

/// A pointer to the value inside a variant of variants, if it is of this type; nullptr otherwise.
template <class Alternative, class Nested>
auto find_alternative(Nested& nested) {
  using Found = std::conditional_t<std::is_const_v<Nested>, const Alternative, Alternative>;
  return visit_nested(
      [](auto& one) -> Found* {
        if constexpr (std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(one)>>, Alternative>) {
          return &one;
        } else {
          return nullptr;
        }
      },
      nested);
}

}  // namespace breccia
