#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/range.hpp"

namespace breccia {

/// Gathers the mistakes of a study, each with the part of the study in which it is.
class StudyMistakes {
 public:
  void add(std::string_view part, std::string_view mistake);
  void add_all(std::string_view part, const std::vector<std::string>& mistakes);
  /// Adds the InputError that an action throws.
  void add_error_of(std::string_view part, const std::function<void()>& action);
  /// Adds a number that is out of range: "tests: points per decade: expected an integer from 1 to 1000, got 0".
  void check_number(std::string_view part, std::string_view what, double value, const Range& range);
  void check_integer(std::string_view part, std::string_view what, int value, const Range& range);
  /// Adds a quantity, in its SI unit, that is out of range.
  void check_quantity(std::string_view part, std::string_view what, double value, const Range& range,
                      Dimension dimension);
  /// Adds a name that is missing, or that has control characters.
  void check_name(std::string_view part, const std::string& name);

  /// Throws InputError with one line for each mistake, if there are any.
  void refuse() const;

 private:
  std::vector<std::string> lines_;
};

}  // namespace breccia
