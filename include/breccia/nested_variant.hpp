#pragma once

#include <type_traits>
#include <variant>

namespace breccia {

/// Calls the visitor with what a variant of variants holds, such as a choice of two dimensions whose alternatives are
/// choices of a content.
template <class Visitor, class Nested>
decltype(auto) visit_nested(const Visitor& visitor, Nested& nested) {
  return std::visit([&visitor](auto& inner) -> decltype(auto) { return std::visit(visitor, inner); }, nested);
}

/// What a variant of variants holds, if it is of this type; nullptr otherwise.
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
