#include "deck/prony_file.hpp"

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

TEST(PronyFile, ReadsWhatItWrites) {
  const test::TemporaryDirectory directory;
  const auto path = directory.path() / "g.csv";
  const PronySeries series(1.5e5, {{1.0 / 3.0, 2e6}, {1e-7, 3e8}});
  write_prony_file(path, series, ModulusKind::unspecified, "Made up.");
  EXPECT_EQ(read_text(path),
            "# Made up.\nrelaxation_time_s,modulus_Pa\ninf,150000\n0.3333333333333333,2000000\n"
            "1e-07,300000000\n");
  const auto file = read_prony_file(path);
  EXPECT_EQ(PronySeries(file.equilibrium.value(), file.terms), series);
}

TEST(PronyFile, WithoutAnEquilibriumModulusSaysSo) {
  const test::TemporaryDirectory directory;
  EXPECT_FALSE(read_prony_file(directory.written("g.csv", "relaxation_time_s,bulk_modulus_Pa\n1,2\n")).equilibrium);
}

TEST(PronyFile, HasTheKindOfItsModulus) {
  const test::TemporaryDirectory directory;
  const auto path = directory.path() / "g.csv";
  write_prony_file(path, PronySeries(2.0, {{1.0, 3.0}}), ModulusKind::young);
  EXPECT_TRUE(read_text(path).starts_with("relaxation_time_s,youngs_modulus_Pa\n"));
  EXPECT_EQ(read_prony_file(path, ModulusKind::young).equilibrium, 2.0);
  EXPECT_THROW(static_cast<void>(read_prony_file(path, ModulusKind::shear)), InputError);
}

TEST(PronyFile, InOtherUnitsIsTheSame) {
  const test::TemporaryDirectory directory;
  const auto si = read_prony_file(directory.written("a.csv", "relaxation_time_s,modulus_Pa\n7e-3,1.1e6\ninf,3e5\n"));
  const auto other = read_prony_file(directory.written("b.csv", "Relaxation time [ms];G [MPa]\n7;1,1\ninf;0,3\n"));
  EXPECT_EQ(PronySeries(*si.equilibrium, si.terms), PronySeries(*other.equilibrium, other.terms));
}

TEST(PronyFile, ReportsAllMistakesAtOnce) {
  const test::TemporaryDirectory directory;
  const auto path = directory.written("g.csv", "relaxation_time_s,modulus_Pa\n-1,2\n1,inf\ninf,1\ninf,2\n");
  const auto message = test::message_of<InputError>([&] { static_cast<void>(read_prony_file(path)); });
  const auto file = path.string();
  EXPECT_EQ(message, file + ":2: expected a positive relaxation time, got -1\n" + file +
                         ":3: expected a non-negative modulus, got inf\n" + file +
                         ":5: a second term with an infinite relaxation time");
}

}  // namespace
}  // namespace breccia
