#include "results/response_file.hpp"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "one_vector_response.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A response of two vectors in which no number occurs twice, so that none can be mistaken for another.
ReducedResponse two_vector_response() {
  ReducedResponse response;
  response.load = Load::bulk;
  response.boundary = Boundary::traction;
  response.constant = Eigen::MatrixXd{{1.0, 1.0 / 3.0}, {2.0, 4.0}};
  response.parts = matrix_parts(Eigen::MatrixXd{{5.0, 6.0}, {7.0, 8.0}}, Eigen::MatrixXd{{9.0, 10.0}, {11.0, 12.0}});
  response.load_forces = Eigen::VectorXd{{13.0, 14.0}};
  response.residual_products = Eigen::MatrixXd::Random(7, 7);
  response.residual_scale = 15.0;
  response.snapshots = {{{{.bulk = 16.0, .shear = 17.0}}, 0.0}, {{{.bulk = 18.0, .shear = 19.0}}, 1e-3}};
  return response;
}

StageResponses two_responses() {
  StageResponses stored;
  stored.stage = "A";
  stored.matrix = Material{"binder", 1000.0, PronySeries(2.0), PronySeries(1.0)};
  stored.filler_density = 1850.0;
  stored.filler_fraction = 0.65;
  stored.side = 48e-6;
  stored.deck_hash = "0123456789abcdef";
  stored.fit_tolerance = 0.02;
  stored.times = {1e-8, 1e-2};
  stored.points_per_decade = 12;
  stored.mixing = Mixing::points;
  stored.range = SampledRange::times;
  stored.entries = {{TestGrid(24), test::one_vector_response(Load::shear, Boundary::displacement, {3.0, 2.0, 1.0},
                                                             {{{{.bulk = 2.0, .shear = 1.0}}, 0.0}})},
                    {TestGrid(150), two_vector_response()}};
  return stored;
}

class ResponseFile : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal() const {
    return test::message_of<FileError>([&] { static_cast<void>(read_responses(path)); });
  }
  /// The attributes of a file of an older version.
  static std::vector<std::pair<std::string, Hdf5Attribute>> usual_attributes() {
    return {{"format_version", std::int64_t{4}},
            {"deck_hash", std::string("0123")},
            {"stage", std::string("A")},
            {"matrix", std::string("binder")},
            {"matrix_is", std::string("stage")},
            {"filler_density_kg_per_m3", 1.0},
            {"filler_fraction", 0.5},
            {"box_m", 1.0},
            {"times_s", std::vector{1.0, 2.0}},
            {"sampled_range", std::string("matrix")},
            {"mixing", std::string("series")},
            {"fit_tolerance", 0.1},
            {"points_per_decade", std::int64_t{20}}};
  }
  /// The error message for a file without responses that is correct except for one attribute, and for an empty group.
  [[nodiscard]] std::string refusal_with(const std::string& attribute, const Hdf5Attribute& value,
                                         const std::string& group = {}) const {
    Hdf5Writer file(path);
    if (!group.empty()) file.create_group(group);
    for (const auto& [name, usual] : usual_attributes())
      file.write_attribute("/", name, name == attribute ? value : usual);
    file.commit();
    return refusal();
  }
  /// The error message for a file with a damaged response.
  template <class Damage>
  [[nodiscard]] std::string refusal_after(const Damage& damage) const {
    auto stored = two_responses();
    damage(stored.entries.back().response);
    write_responses(directory.path(), stored);
    return refusal();
  }

  test::TemporaryDirectory directory;
  std::filesystem::path path = directory.path() / "response.h5";
};

TEST_F(ResponseFile, IsReadAsItWasWritten) {
  const auto written = two_responses();
  write_responses(directory.path(), written);
  const auto read = read_responses(path);
  EXPECT_EQ(read.stage, "A");
  EXPECT_TRUE(std::holds_alternative<Material>(read.matrix));
  EXPECT_EQ(name_of(read.matrix), "binder");
  EXPECT_EQ(read.filler_density, 1850.0);
  EXPECT_EQ(read.filler_fraction, 0.65);
  EXPECT_EQ(read.side, 48e-6);
  EXPECT_EQ(read.deck_hash, "0123456789abcdef");
  EXPECT_EQ(read.fit_tolerance, 0.02);
  EXPECT_EQ(read.times, (TimeWindow{1e-8, 1e-2}));
  EXPECT_EQ(read.points_per_decade, 12);
  EXPECT_EQ(read.range, SampledRange::times);
  EXPECT_EQ(read.mixing, Mixing::points);
  ASSERT_EQ(read.entries.size(), 2U);
  EXPECT_EQ(read.entries[0].grid, TestGrid(24));
  EXPECT_EQ(read.entries[0].response.load, Load::shear);
  EXPECT_EQ(read.entries[0].response.boundary, Boundary::displacement);
  EXPECT_EQ(read.entries[0].response.modulus(Moduli{.bulk = 10.0, .shear = 7.0}), 3.0 + 2.0 * 7.0 + 10.0);
}

TEST_F(ResponseFile, IsRefusedWithAnyBitFlipped) {
  write_responses(directory.path(), two_responses());
  EXPECT_EQ(note_on_responses(path), std::nullopt);
  const auto whole = read_text(path);
  constexpr std::size_t flips = 200;
  for (std::size_t i = 0; i < flips; ++i) {
    const auto bit = i * (8 * whole.size() - 1) / (flips - 1);
    auto damaged = whole;
    damaged[bit / 8] = static_cast<char>(static_cast<unsigned char>(damaged[bit / 8]) ^ (1U << (bit % 8)));
    write_text(path, damaged);
    EXPECT_THAT(refusal(), AllOf(HasSubstr("response.h5: damaged: its checksum is"),
                                 HasSubstr("; resume its run, which computes it again")))
        << bit;
  }
}

TEST_F(ResponseFile, OfAnOlderVersionIsReadWithANote) {
  Hdf5Writer file(path);
  for (const auto& [name, value] : usual_attributes()) file.write_attribute("/", name, value);
  file.commit();
  EXPECT_EQ(read_responses(path).stage, "A");
  EXPECT_EQ(note_on_responses(path), path.string() +
                                         ": an older version of Breccia wrote it without a checksum, so that "
                                         "damage cannot be seen");
}

TEST_F(ResponseFile, KeepsEveryNumberInItsPlace) {
  const auto written = two_responses();
  write_responses(directory.path(), written);
  const auto read = read_responses(path);
  const auto& entry = read.entries.at(1);
  const auto& response = entry.response;
  const auto& original = written.entries[1].response;
  EXPECT_EQ(entry.grid, TestGrid(150));
  EXPECT_EQ(response.load, Load::bulk);
  EXPECT_EQ(response.boundary, Boundary::traction);
  EXPECT_EQ(response.constant, original.constant);
  EXPECT_EQ(response.part(ElasticModulus::shear), original.part(ElasticModulus::shear));
  EXPECT_EQ(response.part(ElasticModulus::bulk), original.part(ElasticModulus::bulk));
  EXPECT_EQ(response.load_forces, original.load_forces);
  EXPECT_EQ(response.residual_products, original.residual_products);
  EXPECT_EQ(response.residual_scale, 15.0);
  ASSERT_EQ(response.snapshots.size(), 2U);
  EXPECT_EQ(response.snapshots[1].moduli[0].bulk, 18.0);
  EXPECT_EQ(response.snapshots[1].moduli[0].shear, 19.0);
  EXPECT_EQ(response.snapshots[1].error_before, 1e-3);
  // HDF5 counts rows first.
  EXPECT_THAT(Hdf5Reader(path).read_numbers("/traction/bulk/150/filler_Pa"), ElementsAre(1.0, 1.0 / 3.0, 2.0, 4.0));
}

/// A stage whose coating varies in addition to the matrix.
StageResponses with_a_coating() {
  auto stored = two_responses();
  stored.entries.erase(stored.entries.begin());
  auto& response = stored.entries.front().response;
  response.parts.push_back({{"coating", ElasticModulus::shear}, Eigen::MatrixXd{{20.0, 21.0}, {22.0, 23.0}}});
  response.parts.push_back({{"coating", ElasticModulus::bulk}, Eigen::MatrixXd{{24.0, 25.0}, {26.0, 27.0}}});
  response.residual_products = Eigen::MatrixXd::Random(11, 11);
  response.snapshots[0].moduli.push_back({.bulk = 28.0, .shear = 29.0});
  response.snapshots[1].moduli.push_back({.bulk = 30.0, .shear = 31.0});
  stored.other_phases.emplace(
      "coating", Material{"interphase", 1200.0, PronySeries(32.0), PronySeries(33.0, {{34.0, 35.0}, {36.0, 37.0}})});
  return stored;
}

TEST_F(ResponseFile, KeepsThePhasesThatVaryBesideTheMatrix) {
  const auto written = with_a_coating();
  write_responses(directory.path(), written);
  const auto read = read_responses(path);
  EXPECT_EQ(read.other_phases, written.other_phases);
  const auto &response = read.entries.at(0).response, &original = written.entries[0].response;
  ASSERT_EQ(response.parts.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(response.parts[i].parameter, original.parts[i].parameter) << i;
    EXPECT_EQ(response.parts[i].stiffness, original.parts[i].stiffness) << i;
  }
  EXPECT_EQ(response.residual_products, original.residual_products);
  ASSERT_EQ(response.snapshots.at(1).moduli.size(), 2U);
  EXPECT_EQ(response.snapshots[1].moduli[1].bulk, 30.0);
  EXPECT_EQ(response.snapshots[1].moduli[1].shear, 31.0);
  EXPECT_EQ(response.snapshots[1].error_before, 1e-3);
}

// Older programs, which read the responses of a matrix alone, can still read them.
TEST_F(ResponseFile, HasTheOlderFormatWhereTheMatrixAloneVaries) {
  const auto format = [&] { return Hdf5Reader(path).attribute<std::int64_t>("/", "format_version"); };
  write_responses(directory.path(), two_responses());
  EXPECT_EQ(format(), 4);
  write_responses(directory.path(), with_a_coating());
  EXPECT_EQ(format(), 5);
}

TEST_F(ResponseFile, IsRefusedWhereItsPhasesAreNotWhole) {
  const auto refusal_of = [&](const auto& change) {
    auto stored = with_a_coating();
    change(stored);
    write_responses(directory.path(), stored);
    return refusal();
  };
  EXPECT_THAT(refusal_of([](auto& stored) { stored.other_phases.clear(); }),
              HasSubstr("expected a material for each phase of its responses"));
  EXPECT_THAT(refusal_of([](auto& stored) {
                auto material = stored.other_phases.extract("coating");
                material.key() = "shell";
                stored.other_phases.insert(std::move(material));
              }),
              HasSubstr("expected a material for each phase of its responses"));
  EXPECT_THAT(refusal_of([](auto& stored) { stored.entries[0].response.parts[3].stiffness.setZero(3, 3); }),
              HasSubstr("expected matrices of one size"));
}

TEST_F(ResponseFile, TellsAStageFromAMaterial) {
  auto stored = two_responses();
  stored.matrix = EarlierStage{"fine"};
  write_responses(directory.path(), stored);
  const auto read = read_responses(path);
  ASSERT_TRUE(std::holds_alternative<EarlierStage>(read.matrix));
  EXPECT_EQ(name_of(read.matrix), "fine");
}

TEST_F(ResponseFile, IsNotWrittenWithoutAResponse) {
  auto stored = two_responses();
  stored.entries.clear();
  write_responses(directory.path(), stored);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(ResponseFile, IsRefusedWhereItIsTornOrOfAnotherFormat) {
  EXPECT_THAT(refusal(), HasSubstr("response.h5: cannot open it (missing, damaged or no HDF5 file)"));
  directory.write("response.h5", "shear_Pa\n1\n");
  EXPECT_THAT(refusal(), HasSubstr("no HDF5 file"));
  write_responses(directory.path(), two_responses());
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_THAT(refusal(), HasSubstr("response.h5: cannot"));
  EXPECT_THAT(refusal_with("format_version", std::int64_t{2}),
              HasSubstr("response.h5: written in format 2; this program reads formats 4 and 5"));
  EXPECT_THAT(refusal_with("format_version", 3.0), HasSubstr("has another type"));
}

// With the times in a damaged file a calculation would never end.
TEST_F(ResponseFile, IsRefusedWhereItsStageCannotBe) {
  const std::vector<std::vector<double>> windows = {{1.0},           {0.0, 1.0}, {2.0, 1.0},
                                                    {1.0, INFINITY}, {NAN, 1.0}, {1.0, NAN}};
  for (const auto& times : windows) {
    EXPECT_THAT(refusal_with("times_s", times),
                AllOf(HasSubstr("response.h5: /: not a response that Breccia has written: "),
                      HasSubstr("expected two positive times that do not fall")));
  }
  for (const std::int64_t points : {0L, -1L, 1L << 40}) {
    EXPECT_THAT(refusal_with("points_per_decade", points), HasSubstr("expected a number of points per decade"));
  }
  for (const double side : {0.0, -1.0, static_cast<double>(INFINITY), static_cast<double>(NAN)}) {
    EXPECT_THAT(refusal_with("box_m", side), HasSubstr("expected the side of a box"));
  }
  EXPECT_THAT(refusal_with("sampled_range", std::string("all")), HasSubstr("expected a range that was sampled"));
}

TEST_F(ResponseFile, IsRefusedWhereItsMatricesDoNotFit) {
  const auto is_of_several_sizes = HasSubstr(
      "response.h5: /traction/bulk/150: not a response that Breccia has written: expected "
      "matrices of one size");
  EXPECT_THAT(refusal_after([](auto& response) { response.constant = Eigen::MatrixXd::Zero(1, 1); }),
              is_of_several_sizes);
  EXPECT_THAT(refusal_after([](auto& response) { response.load_forces = Eigen::VectorXd::Ones(3); }),
              is_of_several_sizes);
  EXPECT_THAT(refusal_after([](auto& response) { response.residual_products = Eigen::MatrixXd::Zero(7, 6); }),
              is_of_several_sizes);
  EXPECT_THAT(refusal_after([](auto& response) { response.parts[1].stiffness = Eigen::MatrixXd::Zero(2, 3); }),
              is_of_several_sizes);
  EXPECT_THAT(refusal_after([](auto& response) { response.constant(1, 0) = NAN; }),
              HasSubstr("expected filler_Pa to be of finite numbers"));
}

TEST_F(ResponseFile, IsRefusedWhereAGroupIsNotOfAGrid) {
  for (const auto* name : {"extrapolated", "many", "0"}) {
    EXPECT_THAT(refusal_with("stage", std::string("A"), std::string("/traction/shear/") + name),
                HasSubstr("/traction/shear: not a response that Breccia has written: expected numbers of cells"))
        << name;
  }
}

}  // namespace
}  // namespace breccia
