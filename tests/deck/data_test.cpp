#include <filesystem>

#include <gtest/gtest.h>

#include "decks.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

const std::filesystem::path data = BRECCIA_DATA_DIRECTORY;

PronySeries series_of(const std::string& file) {
  const test::DeckDirectory directory;
  const auto override_text = "materials.binder.shear={ prony = \"" + (data / file).string() + "\" }";
  return directory.study(test::join(test::materials, test::stage, test::tests), {override_text})
      .materials.at(0)
      .material.shear;
}

TEST(Data, BinderInBothReadings) {
  const auto binder = series_of("pbx9501_binder_prony.csv");
  EXPECT_EQ(binder.terms().size(), 22U);
  EXPECT_EQ(binder.terms().front().relaxation_time, 1.5e7);
  EXPECT_EQ(binder.terms().back().relaxation_time, 1.5e-14);
  const auto shifted = series_of("pbx9501_binder_prony_shifted.csv");
  EXPECT_EQ(shifted.terms().front().relaxation_time, 1.5e6);
  for (const double t : {1e-9, 1e-6, 1e-3, 1.0}) EXPECT_NEAR(shifted.at(t), binder.at(10.0 * t), 1e-9 * shifted.at(t));
}

// The unrelaxed modulus is the sum of the five moduli: 944 + 173.8 + 521.2 + 908.5 + 687.5 MPa.
TEST(Data, MeasuredComposite) {
  const auto measured = series_of("pbx9501_measured_relaxation.csv");
  EXPECT_EQ(measured.equilibrium(), 944e6);
  EXPECT_DOUBLE_EQ(measured.unrelaxed(), 3235e6);
}

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  std::size_t i = 1;
  while (x[i] < at) ++i;
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

// The volume fractions of the three classes require 12.3 % below 14 um and 44.6 % below 100 um.
TEST(Data, SizesOfHmx) {
  const auto table = read_csv(data / "hmx_sizes.csv");
  const auto& diameters = table.numbers("diameter_m");
  const auto& fractions = table.numbers("cumulative_volume_fraction");
  EXPECT_EQ(diameters.front(), 2e-6);
  EXPECT_NEAR(interpolated(diameters, fractions, 14e-6), 0.123, 0.005);
  EXPECT_NEAR(interpolated(diameters, fractions, 100e-6), 0.446, 0.005);
}

}  // namespace
}  // namespace breccia
