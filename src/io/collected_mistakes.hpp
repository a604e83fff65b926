#pragma once

#include <string>
#include <vector>

#include "breccia/error.hpp"

namespace breccia {

/// Throws InputError with a line for each mistake, if there is one.
void refuse_unless_empty(const std::vector<std::string>& mistakes);

/// Runs actions one by one and collects the mistakes of all of them.
class CollectedMistakes {
 public:
  /// Runs an action, and keeps the message if it throws InputError.
  template <class Action>
  void collect(const Action& action) {
    try {
      action();
    } catch (const InputError& error) {
      mistakes_.emplace_back(error.what());
    }
  }
  /// Throws InputError with a line for each mistake so far, if there is one.
  void refuse() const { refuse_unless_empty(mistakes_); }

 private:
  std::vector<std::string> mistakes_;
};

}  // namespace breccia
