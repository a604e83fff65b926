// Tests of voids through the command line.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "rasters/npy.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using testing::HasSubstr;
using testing::Not;

constexpr const char* porous = R"(
[materials.bitumen]
density = "1 g/cm^3"
bulk    = "2.5 GPa"
shear   = { equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "300 MPa" }] }

[materials.stone]
density = "2.5 g/cm^3"
bulk    = "35 GPa"
shear   = "25 GPa"

[[stages]]
name    = "asphalt"
matrix  = "bitumen"
box     = "10 mm"
cells   = 60
filler  = [
  { material = "stone", fraction = 0.40, sizes = { diameter = "2 mm" } },
  { material = "void",  fraction = 0.05, sizes = { diameter = "1 mm" } },
]
packing = { method = "lubachevsky-stillinger", walls = false, seed = 1 }

[tests]
loads  = ["shear"]
times  = ["10 us", "100 us"]
fields = "none"
)";

TEST(PorousComposite, HasTheSameModulusByBothMethods) {
  const StudyDirectory study(porous);
  const auto run = study.breccia("run", {"--set", R"(tests.method=["quasistatic", "dynamic"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("; voids: 4.7 % by volume"));
  EXPECT_THAT(run.errors, Not(HasSubstr("are the units right"))) << "a void is softer than the binder";
  const auto record = nlohmann::json::parse(read_text(study.result("study.json")))["stages"][0];
  EXPECT_NEAR(record["filler_of_the_whole"]["porosity"].get<double>(), 0.05, 0.003);
  EXPECT_NEAR(record["filler_of_the_whole"]["fraction"].get<double>(), 0.40, 0.01);
  const auto curves = study.result("curves.csv");
  const auto quasistatic = test::read_curve(curves, "asphalt", "shear", "quasistatic");
  const auto dynamic = test::read_curve(curves, "asphalt", "shear", "dynamic");
  EXPECT_NEAR(test::modulus_at(dynamic, 1e-5) / test::modulus_at(quasistatic, 1e-5), 1.0, 2e-3);
  EXPECT_NEAR(test::modulus_at(dynamic, 1e-4) / test::modulus_at(quasistatic, 1e-4), 1.0, 1e-2) << "where it rings";
}

/// Bitumen without an equilibrium modulus, which is sampled down to a shear modulus of 1e-7 of its bulk modulus.
constexpr const char* flowing = R"(
[materials.bitumen]
density = "1.03 g/cm^3"
bulk    = "2.5 GPa"
shear   = { terms = [
  { time = "0.1 ms", modulus = "400 MPa" }, { time = "1 ms", modulus = "150 MPa" }, { time = "10 ms", modulus = "60 MPa" },
  { time = "100 ms", modulus = "15 MPa" }, { time = "1 s", modulus = "3 MPa" }, { time = "10 s", modulus = "0.5 MPa" } ] }

[materials.stone]
density = "2.7 g/cm^3"
young   = "60 GPa"
poisson = 0.25

[[stages]]
name    = "asphalt"
matrix  = "bitumen"
box     = "24 mm"
cells   = 200
filler  = [
  { material = "stone", fraction = 0.50, sizes = { diameter = "4 mm" }, gap = "0.2 mm" },
  { material = "void",  fraction = 0.04, sizes = { diameter = "2 mm" }, gap = "0.2 mm" },
]
packing = { method = "random", seed = 2 }

[tests]
loads  = ["shear"]
times  = ["1 ms", "10 s"]
fields = "none"
)";

// With a trace of stiffness in the voids of 1e-13 of the stiffest phase the factors of this box break down.
TEST(PorousComposite, WithANearlyIncompressibleMatrixHasFactors) {
  const StudyDirectory study(flowing);
  const auto run = study.breccia("run");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
}

/// A layer of void across the box.
TEST(PorousComposite, ThatIsPartedIsRefused) {
  const StudyDirectory study(porous);
  const std::array<std::size_t, 2> extents = {10, 10};
  std::vector<std::uint16_t> values(100, 1);
  std::fill(values.begin() + 30, values.begin() + 50, std::uint16_t{0});
  write_npy(study.path() / "layers.npy", extents, values);
  auto deck = std::string(porous);
  const auto begin = deck.find("filler"), end = deck.find("[tests]");
  deck.replace(begin, end - begin,
               "packing = { method = \"image\", file = \"layers.npy\", labels = [{ value = 0, material = \"void\" }, "
               "{ value = 1, material = \"bitumen\" }] }\n");
  study.write("deck.toml", deck);
  for (const auto* method : {R"(tests.method="quasistatic")", R"(tests.method="dynamic")", "tests.solver=stepping"}) {
    const auto run = study.breccia("run", {"--overwrite", "--set", method});
    EXPECT_EQ(run.exit_code, 2) << method << run.output;
    EXPECT_THAT(run.errors,
                HasSubstr("the composite has no stiffness under the load shear and the boundary periodic: voids part"));
  }
  const auto traction = study.breccia("run", {"--overwrite", "--set", R"(tests.boundaries=["traction"])"});
  EXPECT_EQ(traction.exit_code, 2) << traction.output;
  EXPECT_THAT(traction.errors, HasSubstr("a void lies at a side of the box, on which the boundary \"traction\""));
}

}  // namespace
}  // namespace breccia
