#pragma once

#include <string>
#include <vector>

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes pairs of numbers, such as times and moduli, as two lists with these names.
template <class Pairs>
void save_pairs(StateWriter& state, const std::string& first_name, const std::string& second_name, const Pairs& pairs) {
  std::vector<double> first, second;
  for (const auto& [a, b] : pairs) {
    first.push_back(a);
    second.push_back(b);
  }
  state.write(first_name, first);
  state.write(second_name, second);
}

/// Reads pairs of numbers from two lists. Throws FileError when a list is missing or the lists differ in length.
template <class Pair>
std::vector<Pair> read_pairs(const StateReader& state, const std::string& first_name, const std::string& second_name) {
  const auto first = state.numbers(first_name);
  const auto second = state.numbers(second_name, first.size());
  std::vector<Pair> pairs;
  pairs.reserve(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) pairs.push_back({first[i], second[i]});
  return pairs;
}

}  // namespace breccia
