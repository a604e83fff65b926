#include "results/response_curves.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "results/hand_made_results.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

StageResult answer(double modulus) {
  auto test = test::test_with({.grid = TestGrid(12)}, {{1e-3, 2.0 * modulus}, {1.0, modulus}});
  test.series = PronySeries(modulus);
  return test::stage_with("A", {test});
}

class WriteResponseCurves : public testing::Test {
 protected:
  WriteResponseCurves() : destination{directory.path() / "aged", "aged binder", "0123456789abcdef", {}} {}

  [[nodiscard]] std::vector<double> moduli() const {
    return read_csv(destination.directory / "curves.csv", test::columns_of_tests).numbers("modulus_Pa");
  }
  [[nodiscard]] std::string refusal(const ResponseDestination& to) const {
    return test::message_of<InputError>([&] { write_response_curves(to, {answer(9.0)}); });
  }

  test::TemporaryDirectory directory;
  ResponseDestination destination;
};

TEST_F(WriteResponseCurves, LeavesTheCurvesAndWhatTheyComeFrom) {
  write_response_curves(destination, {answer(3.0)});
  EXPECT_THAT(moduli(), ElementsAre(6.0, 3.0));
  EXPECT_TRUE(std::filesystem::exists(destination.directory / "prony.csv"));
  EXPECT_FALSE(std::filesystem::exists(destination.directory / "compliance.csv")) << "no creep test";
  const auto record = nlohmann::json::parse(read_text(destination.directory / "respond.json"));
  EXPECT_EQ(record.at("program"), "breccia");
  EXPECT_EQ(record.at("command"), "respond");
  EXPECT_EQ(record.at("source"), "aged binder: A from 1 ms to 1 s, study 0123456789abcdef");
}

TEST_F(WriteResponseCurves, ReplacesWhatTheSameCommandHasLeft) {
  write_response_curves(destination, {answer(3.0)});
  write_response_curves(destination, {answer(4.0)});
  EXPECT_THAT(moduli(), ElementsAre(8.0, 4.0));
}

TEST_F(WriteResponseCurves, ReplacesCurvesFromElsewhereOnRequestAlone) {
  write_response_curves(destination, {answer(3.0)});
  auto other = destination;
  other.matrix = "fresh binder";
  EXPECT_THAT(refusal(other), AllOf(HasSubstr("here is what `breccia respond` made of \"aged binder: A from 1 ms"),
                                    HasSubstr("not of \"fresh binder: A from 1 ms"), HasSubstr("replace it")));
  EXPECT_THAT(moduli(), ElementsAre(6.0, 3.0)) << "as it was";
  other.overwrite = true;
  write_response_curves(other, {answer(5.0)});
  EXPECT_THAT(moduli(), ElementsAre(10.0, 5.0));
}

// The file of the material has the same name, but another content.
TEST_F(WriteResponseCurves, KnowsItsInputsByTheirContent) {
  destination.inputs = {directory.written("material.csv", "1")};
  write_response_curves(destination, {answer(3.0)});
  directory.write("material.csv", "2");
  EXPECT_THAT(refusal(destination), HasSubstr("whose content was another then"));
}

TEST_F(WriteResponseCurves, RefusesAPlaceThatIsNotItsOwn) {
  std::filesystem::create_directory(destination.directory);
  const auto curves = destination.directory / "curves.csv";
  write_text(curves, "mine");
  EXPECT_THAT(refusal(destination), HasSubstr("the results would replace curves.csv, which `breccia respond` did not"));
  destination.inputs = {curves};
  EXPECT_THAT(refusal(destination), HasSubstr("curves.csv"));
  EXPECT_EQ(read_text(curves), "mine");
  std::filesystem::remove(curves);
  destination.inputs.clear();
  write_text(destination.directory / "study.json", "{}");
  EXPECT_THAT(refusal(destination), HasSubstr("here are the results of a study; take another directory"));
}

}  // namespace
}  // namespace breccia
