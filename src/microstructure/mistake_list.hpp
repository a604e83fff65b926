#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

/// Throws InputError that lists the mistakes (up to twenty) that keep particles out of a box of this side [m]. Does
/// nothing if there are none.
inline void require_no_mistakes(const std::vector<std::string>& mistakes, double side, std::string_view particles) {
  if (mistakes.empty()) return;
  constexpr std::size_t most_listed = 20;
  auto message = fmt::format("microstructure: a box of side {:.6g} m cannot hold these {}:", side, particles);
  for (std::size_t k = 0; k < std::min(most_listed, mistakes.size()); ++k) message += "\n  " + mistakes[k];
  if (mistakes.size() > most_listed) message += fmt::format("\n  and {} more", mistakes.size() - most_listed);
  throw InputError(message);
}

}  // namespace breccia
