#include "deck/condition.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

TEST(Condition, ReadsModuliOverTimeAndFrequency) {
  const auto shear = read_condition("G(1 ms) = 3 GPa");
  EXPECT_EQ(shear.quantity, "G(1 ms)");
  EXPECT_EQ(shear.wanted.modulus, ObservedModulus::shear);
  EXPECT_EQ(shear.wanted.curve, ObservedCurve::relaxation);
  EXPECT_DOUBLE_EQ(shear.wanted.at, 1e-3);
  EXPECT_DOUBLE_EQ(shear.wanted.value, 3e9);
  EXPECT_EQ(value_in_words(shear, 2.9e9), "2.9 GPa");

  const auto loss = read_condition(" E''( 10 Hz )=20 MPa ");
  EXPECT_EQ(loss.quantity, "E''( 10 Hz )");
  EXPECT_EQ(loss.wanted.modulus, ObservedModulus::young);
  EXPECT_EQ(loss.wanted.curve, ObservedCurve::loss);
  EXPECT_NEAR(loss.wanted.at, 20.0 * std::numbers::pi, 1e-12);
  EXPECT_EQ(read_condition("G″(10 Hz) = 20 MPa").wanted.curve, ObservedCurve::loss);
  EXPECT_EQ(read_condition("G′(10 Hz) = 20 MPa").quantity, "G'(10 Hz)");
  EXPECT_EQ(read_condition("K'(1 Hz) = 1 GPa").wanted.curve, ObservedCurve::storage);
  EXPECT_EQ(read_condition("|M*|(1 Hz) = 1 GPa").wanted.modulus, ObservedModulus::p_wave);
  EXPECT_EQ(read_condition("|G*|(2 rad/s) = 1 GPa").wanted.curve, ObservedCurve::absolute);
  EXPECT_NEAR(read_condition("|G*|(2 rad/s) = 1 GPa").wanted.at, 2.0, 1e-12);
}

TEST(Condition, ReadsThePhaseAndItsTangent) {
  const auto tangent = read_condition("tan_delta(10 Hz) = 0.3");
  EXPECT_EQ(tangent.wanted.curve, ObservedCurve::phase);
  EXPECT_DOUBLE_EQ(tangent.wanted.value, std::atan(0.3));
  EXPECT_NEAR(as_written(tangent, tangent.wanted.value), 0.3, 1e-15);
  EXPECT_EQ(value_in_words(tangent, 0.31), "0.31");
  EXPECT_EQ(unit_of(tangent), "");
  const auto phase = read_condition("phase(10 Hz) = 17 deg");
  EXPECT_DOUBLE_EQ(phase.wanted.value, 17.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(value_in_words(phase, phase.wanted.value), "17 deg");
  EXPECT_EQ(unit_of(phase), "rad");
}

TEST(Condition, RefusesWhatIsNone) {
  const std::vector<std::pair<const char*, const char*>> mistakes = {
      {"", "expected a condition such as"},
      {"G = 3 GPa", "expected a condition such as"},
      {"G(1 ms) > 3 GPa", "expected a condition such as"},
      {"G(1 ms) 2 = 3 GPa", "expected a condition such as"},
      {")G(1 ms) = 3 GPa", "expected a condition such as"},
      {"H(1 ms) = 3 GPa", "unknown quantity \"H\""},
      {"tandelta(1 Hz) = 0.3", "did you mean \"tan_delta\"?"},
      {"G(10 Hz) = 3 GPa", "expected a time"},
      {"G'(1 ms) = 3 GPa", "expected a frequency"},
      {"G(0 s) = 3 GPa", "expected a positive time"},
      {"G(1 s) = 3", "expected a pressure"},
      {"G(1 s) = -3 GPa", "expected a positive pressure"},
      {"G(1 s) = 3 GPa = 4 GPa", "expected a pressure"},
      {"tan_delta(1 Hz) = 0", "expected a positive number"},
      {"tan_delta(1 Hz) = 3 deg", "expected a positive number"},
      {"phase(1 Hz) = 100 deg", "expected an angle between 0 and 90 deg"},
      {"phase(1 Hz) = 0.3", "expected an angle"},
  };
  for (const auto& [text, message] : mistakes) {
    EXPECT_THAT(test::message_of<InputError>([&, &condition = text] { static_cast<void>(read_condition(condition)); }),
                HasSubstr(message))
        << text;
  }
}

}  // namespace
}  // namespace breccia
