#include "breccia/viscoelasticity/shift_table.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

const ShiftTable falling({260.0, 280.0, 320.0}, {3.0, 1.0, -1.0}, 300.0);

TEST(ShiftTable, IsOneAtTheReferenceAndLinearBetweenItsRows) {
  EXPECT_EQ(falling.shift_factor(300.0), 1.0);
  EXPECT_NEAR(std::log10(falling.shift_factor(270.0)), 2.0, 1e-14);
  EXPECT_NEAR(std::log10(falling.shift_factor(310.0)), -0.5, 1e-14);
  EXPECT_NEAR(std::log10(falling.shift_factor(260.0)), 3.0, 1e-14);
  EXPECT_NEAR(std::log10(falling.shift_factor(320.0)), -1.0, 1e-14);
}

TEST(ShiftTable, HasATemperatureForEachFactor) {
  for (const double temperature : {260.0, 271.0, 280.0, 301.0, 320.0}) {
    EXPECT_NEAR(falling.temperature_at(std::log10(falling.shift_factor(temperature))), temperature, 1e-10);
  }
  EXPECT_EQ(falling.temperature_at(5.0), 260.0);
  EXPECT_EQ(falling.temperature_at(-2.0), 320.0);
}

TEST(ShiftTable, DoesNotReachBeyondItsRows) {
  EXPECT_THAT(test::message_of<InputError>([] { static_cast<void>(falling.shift_factor(259.0)); }),
              HasSubstr("reaches from 260 K (-13.15 degC) to 320 K (46.85 degC), got 259 K (-14.15 degC)"));
  EXPECT_THROW(static_cast<void>(falling.shift_factor(321.0)), InputError);
  EXPECT_THROW(static_cast<void>(falling.shift_factor(std::nan(""))), InputError);
  EXPECT_THROW(ShiftTable({260.0, 280.0}, {1.0, 0.0}, 300.0), InputError);
}

TEST(ShiftTable, RefusesAllThatIsNotFalling) {
  const auto message = test::message_of<InputError>([] {
    static_cast<void>(ShiftTable({260.0, 260.0, 270.0}, {1.0, 0.0, 0.5}, 265.0));
  });
  EXPECT_THAT(message, HasSubstr("expected rising temperatures, got 260 K"));
  EXPECT_THAT(message, HasSubstr("got log10 a_T = 0.5 after 0 at 270 K"));
  EXPECT_THROW(ShiftTable({260.0}, {1.0}, 260.0), InputError);
  EXPECT_THROW(ShiftTable({260.0, 270.0}, {1.0}, 260.0), InputError);
  EXPECT_THROW(ShiftTable({260.0, INFINITY}, {1.0, 0.0}, 260.0), InputError);
}

}  // namespace
}  // namespace breccia
