#include "study/study_mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/printable.hpp"

namespace breccia {

void StudyMistakes::add(std::string_view part, std::string_view mistake) {
  lines_.push_back(fmt::format("{}: {}", printable(part), mistake));
}

void StudyMistakes::add_all(std::string_view part, const std::vector<std::string>& mistakes) {
  for (const auto& mistake : mistakes) add(part, mistake);
}

void StudyMistakes::add_error_of(std::string_view part, const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    add(part, error.what());
  }
}

void StudyMistakes::check_number(std::string_view part, std::string_view what, double value, const Range& range) {
  if (accepts(range, value)) return;
  add(part, fmt::format("{}: expected {}, got {}", what, described(range, "number"), value));
}

void StudyMistakes::check_integer(std::string_view part, std::string_view what, int value, const Range& range) {
  if (accepts(range, value)) return;
  add(part, fmt::format("{}: expected {}, got {}", what, described(range, "integer"), value));
}

void StudyMistakes::check_quantity(std::string_view part, std::string_view what, double value, const Range& range,
                                   Dimension dimension) {
  if (accepts(range, value)) return;
  add(part, fmt::format("{}: expected {}, got {}", what, described(range, dimension), readable(value, dimension)));
}

void StudyMistakes::check_name(std::string_view part, const std::string& name) {
  if (name.empty()) add(part, "expected a name");
  if (!is_printable(name)) add(part, "expected a name without line breaks and other control characters");
}

void StudyMistakes::refuse() const {
  if (!lines_.empty()) throw InputError(fmt::format("{}", fmt::join(lines_, "\n")));
}

}  // namespace breccia
