#include "results/history_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "messages.hpp"
#include "page/report_data.hpp"
#include "results/hand_made_results.hpp"
#include "study/identity.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Lt;
using testing::UnorderedElementsAre;

/// A million samples of a wave that begins before time zero.
StoredHistory wave() {
  StoredHistory history;
  for (int i = -1000; i < 1000000; ++i) {
    const double time = 1e-6 * i;
    history.times.push_back(time);
    history.values.push_back(std::sin(2.0 * std::numbers::pi * 5000.0 * time));
  }
  return history;
}

TEST(OutlineOfHistory, KeepsTheExtremesOfRinging) {
  const auto history = wave();
  const auto outline = outline_of(history);
  EXPECT_THAT(outline.times.size(), Lt(2000U));
  EXPECT_EQ(outline.times.size(), outline.values.size());
  EXPECT_TRUE(std::ranges::is_sorted(outline.times));
  for (double begin = 0.0; begin < 0.99; begin += 0.01) {
    double least = 0.0, most = 0.0;
    for (std::size_t i = 0; i < outline.times.size(); ++i) {
      if (outline.times[i] < begin || outline.times[i] > begin + 0.01) continue;
      least = std::min(least, outline.values[i]);
      most = std::max(most, outline.values[i]);
    }
    EXPECT_NEAR(least, -1.0, 1e-3) << begin;
    EXPECT_NEAR(most, 1.0, 1e-3) << begin;
  }
}

TEST(OutlineOfHistory, KeepsAShortHistoryWhole) {
  const StoredHistory history{.deck_hash = "h", .times = {-1.0, 0.0, 1.0, 2.0}, .values = {0.0, 1.0, 3.0, 2.0}};
  const auto outline = outline_of(history);
  EXPECT_EQ(outline.times, history.times);
  EXPECT_EQ(outline.values, history.values);
  EXPECT_EQ(outline.deck_hash, "h");
  EXPECT_TRUE(outline_of(StoredHistory{}).times.empty());
}

TEST(RoundedNumbers, HaveSixDigits) {
  EXPECT_THAT(rounded({0.0, 1.23456789, -98765.4321, 1e-300, INFINITY}),
              ElementsAre(0.0, 1.23457, -98765.4, 1e-300, INFINITY));
}

const TestId relaxation{Load::shear, Boundary::displacement, Method::dynamic, TestGrid(24)};
const TestId creep{Load::bulk, Boundary::traction, Method::dynamic, TestGrid(24)};

TimeDomain domain_with(Curve history) {
  TimeDomain domain;
  domain.mass_scaling = 1e6;
  domain.time_step = 1e-7;
  domain.ramp = 3e-5;
  domain.window = {1e-4, 2e-3};
  domain.steps = 12345;
  domain.terms = 3;
  domain.reduction_error = 1e-4;
  domain.history = std::move(history);
  return domain;
}

TestResult dynamic_test(const TestId& id, std::vector<TimeDomain> domains) {
  DynamicRecord record;
  record.domains = std::move(domains);
  auto test = test::test_with(id, {});
  test.record = std::move(record);
  return test;
}

class HistoryFile : public testing::Test {
 protected:
  HistoryFile() {
    study.provenance.hash = "0123456789abcdef";
    study.provenance.content = content_of(study);
    stage.name = "A";
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory.path())) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }
  /// The error message of read_history() for a file with these numbers and the hash of a deck.
  [[nodiscard]] std::string refusal_of(const std::vector<double>& times, const std::vector<double>& moduli) const {
    const auto path = directory.path() / "shear-displacement-dynamic-24-1.h5";
    Hdf5Writer file(path);
    file.write("/history/time_s", times);
    file.write("/history/modulus_Pa", moduli);
    file.write_attribute("/history", "deck_hash", std::string("0123"));
    file.commit();
    return test::message_of<FileError>([&] { static_cast<void>(read_history(path)); });
  }

  test::TemporaryDirectory directory;
  Study study;
  Stage stage;
};

TEST_F(HistoryFile, HoldsTheModulusOfARelaxationTest) {
  write_history(directory.path(), study, stage, relaxation, 2,
                domain_with({{-1e-5, 0.0}, {0.0, 1.0 / 3.0}, {1.0, 2.0}}));
  const auto path = directory.path() / "shear-displacement-dynamic-24-2.h5";
  const auto history = read_history(path);
  EXPECT_EQ(history.deck_hash, "0123456789abcdef");
  EXPECT_THAT(history.times, ElementsAre(-1e-5, 0.0, 1.0));
  EXPECT_THAT(history.values, ElementsAre(0.0, 1.0 / 3.0, 2.0));
  const Hdf5Reader file(path);
  EXPECT_FALSE(file.has("/history/compliance_1_per_Pa"));
  EXPECT_EQ(file.attribute<std::string>("/history", "stage"), "A");
  EXPECT_EQ(file.attribute<std::string>("/history", "load"), "shear");
  EXPECT_EQ(file.attribute<std::string>("/history", "boundary"), "displacement");
  EXPECT_EQ(file.attribute<std::int64_t>("/history", "cells"), 24);
  EXPECT_EQ(file.attribute<double>("/history", "density_factor"), 1e6);
  EXPECT_EQ(file.attribute<double>("/history", "time_step_s"), 1e-7);
  EXPECT_EQ(file.attribute<double>("/history", "ramp_s"), 3e-5);
  EXPECT_EQ(file.attribute<std::int64_t>("/history", "steps"), 12345);
  EXPECT_THAT(file.attribute<std::vector<double>>("/history", "valid_s"), ElementsAre(1e-4, 2e-3));
  EXPECT_EQ(file.attribute<std::int64_t>("/history", "active_terms"), 3);
  EXPECT_EQ(file.attribute<double>("/history", "reduction_error"), 1e-4);
}

TEST_F(HistoryFile, HoldsTheComplianceOfACreepTest) {
  write_history(directory.path(), study, stage, creep, 1, domain_with({{1e-3, 4.0}, {1.0, 0.5}}));
  const auto path = directory.path() / "bulk-traction-dynamic-24-1.h5";
  EXPECT_THAT(read_history(path).values, ElementsAre(0.25, 2.0));
  EXPECT_FALSE(Hdf5Reader(path).has("/history/modulus_Pa"));
}

TEST_F(HistoryFile, IsWrittenForEachTimeDomainOfTheDynamicTests) {
  write_histories(
      directory.path(), study, stage,
      {dynamic_test(relaxation, {domain_with({{1.0, 1.0}}), domain_with({{2.0, 5.0}})}),
       test::test_with({.grid = TestGrid(24)}, {{1.0, 1.0}}), dynamic_test(creep, {domain_with({{1.0, 1.0}})})});
  EXPECT_THAT(files(), UnorderedElementsAre("shear-displacement-dynamic-24-1.h5", "shear-displacement-dynamic-24-2.h5",
                                            "bulk-traction-dynamic-24-1.h5"));
  EXPECT_THAT(read_history(directory.path() / "shear-displacement-dynamic-24-2.h5").values, ElementsAre(5.0));
}

TEST_F(HistoryFile, IsKnownByItsName) {
  EXPECT_EQ(history_file("shear", "traction", 300, 2), "shear-traction-dynamic-300-2.h5");
  EXPECT_TRUE(is_history("shear-traction-dynamic-300-2.h5"));
  EXPECT_TRUE(is_history("shear-xx-yy-periodic-dynamic-24-11.h5"));
  for (const auto* name :
       {"shear-traction-quasistatic-300-2.h5", "shear-traction-dynamic-300-2.csv", "response.h5", "my-dynamic-data.h5",
        "shear-traction-dynamic-300.h5", "shear-traction-dynamic-300-last.h5", "shear-traction-dynamic-.h5",
        "my-traction-dynamic-300-2.h5", "traction-dynamic-300-2.h5", "shear-dynamic-300-2.h5", "-dynamic-.h5"}) {
    EXPECT_FALSE(is_history(name)) << name;
  }
}

TEST_F(HistoryFile, IsRefusedWhereItIsTornOrForeign) {
  const auto refusal = [](const std::filesystem::path& path) {
    return test::message_of<FileError>([&] { static_cast<void>(read_history(path)); });
  };
  EXPECT_THAT(refusal(directory.path() / "none.h5"), HasSubstr("none.h5: cannot open it (missing, damaged or no HDF5"));
  EXPECT_THAT(refusal(directory.written("text.h5", "time_s,modulus_Pa\n1,2\n")), HasSubstr("no HDF5 file"));
  write_history(directory.path(), study, stage, relaxation, 1, domain_with(Curve(1000, {1.0, 1.0})));
  const auto path = directory.path() / "shear-displacement-dynamic-24-1.h5";
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_THAT(refusal(path), HasSubstr("shear-displacement-dynamic-24-1.h5: cannot"));
  {
    Hdf5Writer foreign(directory.path() / "foreign.h5");
    foreign.write("/history/time_s", std::vector<double>{1.0});
    foreign.commit();
  }
  EXPECT_THAT(refusal(directory.path() / "foreign.h5"), HasSubstr("cannot find attribute deck_hash"));
}

TEST_F(HistoryFile, IsRefusedWithoutAValueForEachTime) {
  EXPECT_THAT(refusal_of({1.0, 2.0, 3.0}, {5.0}), HasSubstr("3 times and 1 values"));
  EXPECT_THAT(refusal_of({1.0}, {5.0, 6.0}), HasSubstr("1 times and 2 values"));
}

}  // namespace
}  // namespace breccia
