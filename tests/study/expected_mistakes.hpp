#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/study/soundness.hpp"

#include "messages.hpp"

namespace breccia::test {

/// The message by which a study is refused.
inline std::string mistakes_of(const Study& study) {
  return message_of<InputError>([&] { require_sound(study); });
}

/// One mistake in a sound study, and its message.
struct Case {
  std::function<void(Study&)> make;
  std::string message;
};

/// Expects each mistake to be reported, and no other one.
inline void expect_each(const std::vector<Case>& cases, const Study& sound) {
  for (const auto& [make, message] : cases) {
    auto study = sound;
    make(study);
    EXPECT_THAT(mistakes_of(study), testing::AllOf(testing::HasSubstr(message), testing::Not(testing::HasSubstr("\n"))))
        << message;
  }
}

}  // namespace breccia::test
