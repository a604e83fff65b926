#include "io/collected_mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {

void refuse_unless_empty(const std::vector<std::string>& mistakes) {
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

}  // namespace breccia
