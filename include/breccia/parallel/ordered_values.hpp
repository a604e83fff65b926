#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

namespace breccia::parallel {

/// The places (indices) of the values of this process in one ordered list of the values of all processes of its group.
/// For each place exactly one process has the value. A value is one number or several.
struct OrderedPlaces {
  std::size_t count = 0;                                  ///< number of the values of this process
  std::function<std::size_t(std::size_t)> place_of = {};  ///< place of each of these values; places rise

  /// Number of the values of this process before a place.
  [[nodiscard]] std::size_t before(std::size_t place) const;
};

/// Places that follow one another.
[[nodiscard]] OrderedPlaces consecutive_places(std::size_t first, std::size_t count);

/// Number of places in a piece. Values are collected piece by piece, so that no process has to hold all of them.
inline constexpr std::size_t places_of_a_piece = std::size_t{1} << 20U;

/// Calls action(begin, end) for each piece of the places, in order.
template <class Action>
void for_each_piece(std::size_t count, const Action& action) {
  for (std::size_t begin = 0; begin < count; begin += places_of_a_piece) {
    action(begin, std::min(count, begin + places_of_a_piece));
  }
}

/// Whether this is the process that receives collected values: the first of the group.
[[nodiscard]] bool is_collecting() noexcept;

/// Copies the values at the places from `begin` to before `end`, of `bytes_each` bytes, in their order to `all` on the
/// first process; on the other processes `all` is not used.
void collect_bytes(const std::byte* own, std::size_t bytes_each, const OrderedPlaces& places, std::size_t begin,
                   std::size_t end, std::byte* all);

/// The values at the places from `begin` to before `end`, in their order, on the first process of the group; an empty
/// list on the other processes. Every process must call the function, with its own values.
template <class Value>
[[nodiscard]] std::vector<Value> collect(std::span<const Value> own, const OrderedPlaces& places, std::size_t begin,
                                         std::size_t end) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::vector<Value> all(is_collecting() ? end - begin : 0);
  collect_bytes(reinterpret_cast<const std::byte*>(own.data()), sizeof(Value), places, begin, end,
                reinterpret_cast<std::byte*>(all.data()));
  return all;
}

}  // namespace breccia::parallel
