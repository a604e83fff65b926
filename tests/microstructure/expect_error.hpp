#pragma once

#include <string>

#include <gmock/gmock.h>

namespace breccia::test {

/// Expects that `action` throws an `Error` whose message contains every one of `parts`.
template <class Error, class Action, class... Parts>
void expect_error(Action&& action, const Parts&... parts) {
  try {
    action();
    ADD_FAILURE() << "no error was thrown";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_THAT(message, ::testing::AllOf(::testing::HasSubstr(parts)...));
  }
}

}  // namespace breccia::test
