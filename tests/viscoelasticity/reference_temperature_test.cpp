#include "viscoelasticity/reference_temperature.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

TEST(ReferenceTemperature, ChangesNoRatioOfShiftFactors) {
  const WilliamsLandelFerry law{17.44, 51.6, 373.15};
  const auto other = with_reference(law, 400.0);
  EXPECT_EQ(other.reference_temperature, 400.0);
  EXPECT_NEAR(other.c1 * other.c2, 17.44 * 51.6, 1e-10);
  for (const double temperature : {340.0, 373.15, 400.0, 450.0}) {
    EXPECT_NEAR(std::log10(other.shift_factor(temperature)),
                std::log10(law.shift_factor(temperature)) - std::log10(law.shift_factor(400.0)), 1e-12);
  }
}

TEST(ReferenceTemperature, OfATableChangesNoRatioOfShiftFactors) {
  const ShiftTable table({280.0, 300.0, 330.0}, {2.0, 0.5, -1.0}, 300.0);
  const auto other = with_reference(table, 310.0);
  EXPECT_NEAR(other.shift_factor(310.0), 1.0, 1e-15);
  EXPECT_NEAR(other.shift_factor(285.0) / (table.shift_factor(285.0) / table.shift_factor(310.0)), 1.0, 1e-12);
}

TEST(ReferenceTemperature, RefusesTemperaturesWithoutALaw) {
  EXPECT_THROW(static_cast<void>(with_reference(WilliamsLandelFerry{17.44, 51.6, 373.15}, 320.0)), InputError);
}

}  // namespace
}  // namespace breccia
