#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "study/chain.hpp"

// Tests of files that a deck names, in other units and in other forms than Breccia writes them.

namespace breccia {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

class DeckFiles : public testing::Test {
 protected:
  [[nodiscard]] Stage stage(const std::string& filler, const std::string& packing) const {
    const auto text =
        test::join(test::materials, "[[stages]]\nname = \"A\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 300\n",
                   "filler = ", filler, "\npacking = ", packing, "\n", test::tests);
    return directory.study(text).stages.at(0);
  }
  [[nodiscard]] static std::string measured(const std::string& name, const std::string& shear) {
    return test::join(test::materials, test::stage, test::tests, "[[measurements]]\nname = \"", name,
                      "\"\nshear = ", shear, "\n");
  }

  test::DeckDirectory directory;
};

TEST_F(DeckFiles, SizesInMicrometres) {
  directory.write("sizes.csv", "Diameter [µm];Cumulative volume fraction [%]\n7;0\n14,5;40\n30;100\n");
  const auto filler = stage(R"({ material = "hmx", fraction = 0.3, sizes = "sizes.csv", gap = "9 um" })",
                            R"({ method = "lubachevsky-stillinger" })")
                          .fillers.at(0);
  const auto& sizes = std::get<TabulatedSizes>(*filler.sizes);
  EXPECT_EQ(sizes.diameters, (std::vector{7e-6, 14.5e-6, 30e-6}));
  EXPECT_EQ(sizes.cumulative_volume_fractions, (std::vector{0.0, 0.4, 1.0}));
}

TEST_F(DeckFiles, DiscsInMicrometres) {
  directory.write("discs.csv", "label,x_um,y_um,diameter_um\nfirst,300,250,200\nsecond,700,700,100\n");
  const auto box = stage(R"({ material = "hmx" })", R"({ method = "explicit", discs = "discs.csv" })");
  const auto discs = std::get<std::vector<Disc>>(box.packed_by<ExplicitPacking<2>>()->particles);
  ASSERT_EQ(discs.size(), 2U);
  EXPECT_EQ(discs[0].centre[0], 300e-6);
  EXPECT_EQ(discs[0].centre[1], 250e-6);
  EXPECT_EQ(discs[1].diameter, 100e-6);
}

TEST_F(DeckFiles, MeasuredCurvesInOtherUnits) {
  directory.write("curve.csv", "time_ms,relaxation_modulus_MPa\n1,3\n1000,2\n");
  const auto curve = directory.study(measured("DMA", "{ curve = \"curve.csv\" }")).measurements.at(0);
  EXPECT_EQ(curve.at(1e-3), 3e6);
  directory.write("prony.csv", "relaxation_time_ms,shear_modulus_MPa\n1000,3\ninf,1\n");
  const auto series = directory.study(measured("DMA", "{ prony = \"prony.csv\" }")).measurements.at(0);
  EXPECT_DOUBLE_EQ(series.at(1.0), 1e6 + 3e6 * std::exp(-1.0));
}

// The data are those of a Maxwell element of 3 MPa and 10 ms in parallel with 1 MPa, at 1 to 1000 rad/s.
TEST_F(DeckFiles, MeasuredDynamicModuliAreFitted) {
  std::string table = "angular_frequency_rad_per_s,storage_modulus_Pa,loss_modulus_Pa\n";
  for (int i = 0; i <= 30; ++i) {
    const double omega = std::pow(10.0, 0.1 * i), x = 0.01 * omega;
    table += fmt::format("{},{},{}\n", omega, 1e6 + 3e6 * x * x / (1.0 + x * x), 3e6 * x / (1.0 + x * x));
  }
  directory.write("dma.csv", table);
  const auto fitted = directory.study(measured("DMA", "{ measured = \"dma.csv\" }")).measurements.at(0);
  for (const double time : {2e-3, 1e-2, 1e-1}) {
    EXPECT_NEAR(fitted.at(time) / (1e6 + 3e6 * std::exp(-time / 0.01)), 1.0, 1e-3) << time;
  }
  ASSERT_TRUE(fitted.times);
  EXPECT_NEAR(fitted.times->begin, 1e-3, 1e-15);
  EXPECT_NEAR(fitted.times->end, 1.0, 1e-12);
  EXPECT_THAT(directory.mistakes(measured("DMA", "{ measured = \"dma.csv\", reference_temperature = \"1 degC\" }")),
              HasSubstr("shear.measured: reference_temperature: only for dynamic moduli at several temperatures"));
}

TEST_F(DeckFiles, MeasuredYoungsAndBulkModuliAreNamedByTheirKeys) {
  const auto of = [](std::string_view line) {
    return test::join(test::materials, test::stage, test::tests, "[[measurements]]\nname = \"DMA\"\n", line, "\n");
  };
  directory.write("curve.csv", "time_s,youngs_modulus_MPa\n1,3\n2,2\n");
  const auto study = directory.study(of(R"(young = { curve = "curve.csv" })"));
  EXPECT_EQ(study.measurements.at(0).kind, ModulusKind::young);
  EXPECT_EQ(study.measurements.at(0).at(2.0), 2e6);
  EXPECT_THAT(loads_of(study, study.stages.back()), Contains(Load::bulk)) << "without it there is no Young's modulus";
  directory.write("compliance.csv", "time_s,bulk_modulus_GPa\n1,3\n2,2.5\n4,2.2\n8,2\n");
  EXPECT_EQ(directory.study(of(R"(bulk = { measured = "compliance.csv" })")).measurements.at(0).kind,
            ModulusKind::bulk);
  const auto law = directory.study(of(
      R"(young = { law = "power-law-creep", instantaneous = "1 /GPa", creep = "1 /GPa", time = "1 s", exponent = 0.3 })"));
  EXPECT_NEAR(law.measurements.at(0).at(1e-9), 1e9, 5e6);
  EXPECT_THAT(directory.mistakes(of(R"(bulk = { curve = "curve.csv" })")),
              HasSubstr("expected a column of the bulk modulus, got \"youngs_modulus_MPa\""));
  EXPECT_THAT(directory.mistakes(of(R"(poisson = { curve = "curve.csv" })")),
              AllOf(HasSubstr("expected exactly one of shear, young, bulk"), HasSubstr("unknown key \"poisson\"")));
}

TEST_F(DeckFiles, MeasurementsOfAnotherModulusAreRefused) {
  directory.write("curve.csv", "time_s,E [MPa]\n1,3\n2,2\n");
  directory.write("prony.csv", "relaxation_time_s,tensile_modulus_Pa\n1,3\n");
  EXPECT_THAT(
      directory.mistakes(measured("DMA", "{ curve = \"curve.csv\" }")),
      HasSubstr(
          "shear.curve: curve.csv: expected a column of the shear modulus, got \"E [MPa]\", that of Young's modulus"));
  EXPECT_THAT(directory.mistakes(measured("DMA", "{ prony = \"prony.csv\" }")),
              HasSubstr("shear.prony: prony.csv: expected a column of the shear modulus, got \"tensile_modulus_Pa\""));
}

TEST_F(DeckFiles, MeasuredSeriesAreAboveZero) {
  directory.write("prony.csv", "relaxation_time_s,shear_modulus_Pa\n1,0\n");
  EXPECT_THAT(directory.mistakes(measured("DMA", "{ prony = \"prony.csv\" }")),
              HasSubstr("shear.prony: prony.csv: expected a modulus above zero, and finite"));
}

TEST_F(DeckFiles, NamesAreNotEmpty) {
  directory.write("curve.csv", "time_s,modulus_Pa\n1,3\n2,2\n");
  EXPECT_THAT(directory.mistakes(measured("", "{ curve = \"curve.csv\" }")),
              HasSubstr(".name: expected a text that is not empty"));
}

TEST_F(DeckFiles, NamesHaveNoControlCharacters) {
  directory.write("curve.csv", "time_s,modulus_Pa\n1,3\n2,2\n");
  EXPECT_THAT(
      directory.mistakes("title = \"a\\nb\"\n" + measured("c\\rd", "{ curve = \"curve.csv\" }")),
      AllOf(
          HasSubstr("deck.toml:1:9: title: expected text without line breaks"),
          HasSubstr(".name: expected text without line breaks, tabs and other control characters, got \"c\\u000dd\"")));
}

}  // namespace
}  // namespace breccia
