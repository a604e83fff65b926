// Tests of the data that the page draws for stages in three dimensions, from files of results.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "page/study_report.hpp"
#include "rasters/base64.hpp"
#include "rasters/npy.hpp"
#include "results/film_field_files.hpp"
#include "results/hand_made_documents.hpp"
#include "results/volume_field_files.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// The bytes of a text of the page: base64 of a stream of zlib.
std::vector<std::uint8_t> unpacked(const json& text, std::size_t most = 100000) {
  const auto stream = decode_base64(text.get<std::string>()).value();
  std::vector<std::uint8_t> bytes(most);
  auto size = static_cast<uLongf>(most);
  EXPECT_EQ(uncompress(bytes.data(), &size, reinterpret_cast<const Bytef*>(stream.data()), stream.size()), Z_OK);
  bytes.resize(size);
  return bytes;
}

/// The numbers of a column.
std::vector<double> numbers(const json& column) {
  const auto bytes = unpacked(column.at("values"));
  const double from = column.at("from"), to = column.at("to");
  std::vector<double> values;
  for (std::size_t i = 0; i < bytes.size(); i += 2)
    values.push_back(from + (to - from) * (bytes[i] + 256 * bytes[i + 1]) / 65535.0);
  return values;
}

class SpaceViews : public testing::Test {
 protected:
  SpaceViews() { std::filesystem::create_directory(directory.path() / "A"); }
  /// Writes a study.json with one stage and its tests.
  void write_study(int dimensions, std::vector<TestEntry> tests = {}, const std::string& name = "A") const {
    auto document = test::document_with(name, std::move(tests));
    document.stages.front().dimensions = dimensions;
    write_study_document(directory.path(), document);
  }
  /// A test with a file of fields.
  [[nodiscard]] static TestEntry test_with(const std::string& file) {
    TestEntry test{.id = {Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(2)}};
    test.fields = {{1.0, file, "fields-stress.svg", "fields-strain.svg"}};
    return test;
  }
  [[nodiscard]] json data() const { return json::parse(study_page_data(directory.path()).json); }
  [[nodiscard]] json view() const { return data().at("views").at("stages").at("A"); }
  [[nodiscard]] std::string refusal() const {
    return test::message_of<FileError>([&] { static_cast<void>(study_page_data(directory.path())); });
  }

  test::TemporaryDirectory directory;
};

TEST_F(SpaceViews, OfTwoDimensionsThereAreNone) {
  write_study(2);
  directory.write("A/microstructure.csv", "x_m,y_m,diameter_m\n1,2,3\n");
  EXPECT_FALSE(study_page_data(directory.path()).has_views);
  EXPECT_FALSE(data().contains("views"));
}

TEST_F(SpaceViews, OfSpheresHoldTheirTable) {
  write_study(3);
  directory.write(
      "A/microstructure.csv",
      "# spheres\nx_m,y_m,z_m,diameter_m,filler\n0,0.5,0.1,0.02,0\n1,0.5,0.3,0.04,1\n0.25,0.5,0.2,0.03,1\n");
  EXPECT_TRUE(study_page_data(directory.path()).has_views);
  EXPECT_EQ(data().at("views").at("colours").get<std::string>().size(), 6 * 256U);
  const auto particles = view().at("microstructure").at("particles");
  EXPECT_EQ(particles.at("count"), 3);
  EXPECT_EQ(particles.at("listed"), 3);
  // The numbers are stored in 65535 steps from the smallest to the largest.
  using testing::DoubleNear;
  EXPECT_THAT(numbers(particles.at("columns").at("x_m")), ElementsAre(0.0, 1.0, DoubleNear(0.25, 1e-5)));
  EXPECT_THAT(numbers(particles.at("columns").at("y_m")), ElementsAre(0.5, 0.5, 0.5));
  EXPECT_THAT(numbers(particles.at("columns").at("z_m")), ElementsAre(0.1, 0.3, DoubleNear(0.2, 1e-5)));
  EXPECT_THAT(numbers(particles.at("columns").at("diameter_m")), ElementsAre(0.02, 0.04, DoubleNear(0.03, 1e-5)));
  EXPECT_THAT(numbers(particles.at("columns").at("filler")), ElementsAre(0.0, 1.0, 1.0));
}

TEST_F(SpaceViews, ShowTheLargestOfVeryManySpheres) {
  write_study(3);
  std::string table = "x_m,y_m,z_m,diameter_m\n";
  constexpr std::size_t listed = 200003;
  for (std::size_t i = 0; i < listed; ++i) table += fmt::format("{},0,0,{}\n", i, i < 3 ? 1 : 2);
  directory.write("A/microstructure.csv", table);
  const auto particles = view().at("microstructure").at("particles");
  EXPECT_EQ(particles.at("count"), 200000);
  EXPECT_EQ(particles.at("listed"), listed);
  EXPECT_EQ(particles.at("columns").at("x_m").at("from"), 3.0) << "the first three are the smallest";
}

// There are labels of 130 points along x, of which every second one is shown, and of 2 along y and z, of which the
// first is shown.
TEST_F(SpaceViews, OfVoxelsHoldTheirPhases) {
  write_study(3);
  std::vector<std::uint16_t> labels;
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 130; ++x) labels.push_back(static_cast<std::uint16_t>(x % 2 == 1 ? 9 : x / 2 + 70 * (z / 2)));
    }
  }
  write_npy(directory.path() / "A" / "labels.npy", std::array<std::size_t, 3>{130, 2, 4}, labels);
  const auto phases = view().at("microstructure").at("phases");
  EXPECT_EQ(phases.at("cells"), json({65, 1, 2}));
  std::vector<std::uint8_t> expected;
  expected.reserve(130);
  for (int place = 0; place < 130; ++place) expected.push_back(static_cast<std::uint8_t>(place + (place < 65 ? 0 : 5)));
  EXPECT_EQ(unpacked(phases.at("values")), expected);
}

TEST_F(SpaceViews, WithoutFilesAreEmpty) {
  write_study(3, {test_with("fields.vtkhdf")});
  EXPECT_TRUE(view().at("microstructure").is_null());
  EXPECT_TRUE(view().at("fields").empty());
  write_study(3, {}, std::string(300, 'a'));
  EXPECT_TRUE(data().at("views").at("stages").begin()->at("microstructure").is_null()) << "no file has such a name";
}

TEST_F(SpaceViews, RefuseWhatIsNotOfBreccia) {
  write_study(3, {test_with("../fields.vtkhdf")});
  EXPECT_THAT(refusal(), HasSubstr("\"../fields.vtkhdf\" is not a name that `breccia run` gives"));
  directory.write("A/fields.vtkhdf", "text");
  write_study(3, {test_with("fields.vtkhdf")});
  EXPECT_THAT(refusal(), HasSubstr("fields.vtkhdf: cannot open it"));
  write_study(3);
  directory.write("A/microstructure.csv", "x_m,y_m,z_m,diameter_m\n1,1,inf,1\n");
  EXPECT_THAT(refusal(), HasSubstr("is not finite"));
  directory.write("A/microstructure.csv", "x_m,y_m,z_m\n1,1,1\n");
  EXPECT_THAT(refusal(), HasSubstr("axis_1_m"));
}

/// Fields of a cube of cells, whose shear stress xy and strain xy follow functions of the place of a cell.
template <class Stress, class Strain>
void write_field(const std::filesystem::path& folder, int cells, const Stress& stress, const Strain& strain) {
  Discretisation<3> discretisation{{{cells, cells, cells}, 1e-3}};
  auto fields = zero_cell_fields(discretisation);
  discretisation.grid().for_each_cell([&](const Index<3>& cell) {
    const auto at = discretisation.grid().cell_index(cell);
    fields.stress[at][5] = stress(cell);
    fields.strain[at][5] = strain(cell);
    fields.phase[at] = static_cast<PhaseIndex>(cell[0] == 1 ? 1 : 0);
  });
  const auto study = test::two_stages();
  static_cast<void>(write_fields(folder, study, study.stages[0],
                                 {Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(cells)},
                                 GridFields<3>{discretisation.grid(), {{1e-3, fields}}}));
}

TEST_F(SpaceViews, OfFieldsHoldTheirColours) {
  write_study(3, {test_with("fields.vtkhdf")});
  // Stress rises along z from 1 to 3 MPa, strain along y from 0.5 to 2.
  write_field(
      directory.path() / "A", 3, [](const Index<3>& cell) { return 1e6 * (cell[2] + 1); },
      [](const Index<3>& cell) {
        return std::array{0.5, 1.0, 2.0}[static_cast<std::size_t>(cell[1])];
      });
  const auto field = view().at("fields").at("fields.vtkhdf");
  EXPECT_EQ(field.at("cells"), 3);
  const auto& stress = field.at("stress");
  EXPECT_EQ(stress.at("words"), "Shear stress over mean shear strain in MPa");
  EXPECT_EQ(stress.at("unit_size"), 1e6);
  EXPECT_EQ(stress.at("scale"), "linear");
  EXPECT_EQ(stress.at("from"), 1e6);
  EXPECT_EQ(stress.at("to"), 3e6);
  const auto& strain = field.at("strain");
  EXPECT_EQ(strain.at("scale"), "logarithmic");
  // The equivalent shear strain of pure shear is twice its component, on a mean angle of twice 3.5 / 3.
  EXPECT_NEAR(strain.at("from").get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(strain.at("to").get<double>(), 4.0, 1e-6);
  EXPECT_NEAR(strain.at("unit_size").get<double>(), 7.0 / 3.0, 1e-6);
  const auto stresses = unpacked(stress.at("values")), strains = unpacked(strain.at("values")),
             phases = unpacked(field.at("material").at("values"));
  constexpr std::array<int, 3> thirds = {0, 128, 255};
  for (std::size_t cell = 0; cell < 27; ++cell) {
    EXPECT_EQ(stresses.at(cell), thirds[cell / 9]);
    EXPECT_NEAR(strains.at(cell), thirds[cell / 3 % 3], 1.0);
    EXPECT_EQ(phases.at(cell), cell % 3 == 1 ? 1 : 0);
  }
}

// The blocks have two cells along each axis, and one at the ends.
TEST_F(SpaceViews, OfManyCellsHoldMeans) {
  write_study(3, {test_with("fields.vtkhdf")});
  write_field(
      directory.path() / "A", 65, [](const Index<3>& cell) { return cell[0] == 64 ? 66.0 : 1.0 + cell[0]; },
      [](const Index<3>& cell) { return cell[1] % 2 == 0 ? 1.0 : 3.0; });
  const auto field = view().at("fields").at("fields.vtkhdf");
  EXPECT_EQ(field.at("cells"), 33);
  const auto& stress = field.at("stress");
  EXPECT_EQ(stress.at("from"), 1.5);
  EXPECT_EQ(stress.at("to"), 66.0);
  const auto strains = unpacked(field.at("strain").at("values"));
  ASSERT_EQ(strains.size(), 33U * 33U * 33U);
  EXPECT_EQ(strains[0], strains[31 * 33]) << "the mean of 1 and 3";
  EXPECT_LT(strains[32 * 33], strains[0]) << "the last layer alone";
}

/// A periodic box of 6 mm, the side of the stage: two wedges of a grain fill it, and a film, a fifth of a cell of 125
/// thick, is above its bottom; in the half x > y it is a gap. A junction reaches through the box along its edge.
void write_film(const std::filesystem::path& folder) {
  constexpr double side = 6e-3, cell_side = side / 125.0;
  FilmFields<3> fields;
  const auto add_wedges = [&](double bottom, double top, std::array<FilmPart, 2> parts, double stress) {
    const auto first = fields.points.size();
    for (const double z : {top, bottom}) {
      for (const auto& [x, y] : {std::pair{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}) {
        fields.points.push_back({x, y, z});
      }
    }
    for (const std::size_t corner : {0U, 1U, 2U, 4U, 5U, 6U, 0U, 2U, 3U, 4U, 6U, 7U})
      fields.corners.push_back(first + corner);
    for (const auto part : parts) {
      FilmCell<3> cell{.part = part, .corners = 6, .content = 0.5 * side * side * (top - bottom)};
      cell.stress.back() = stress;
      cell.strain.back() = 0.5;
      fields.cells.push_back(cell);
    }
  };
  add_wedges(0.0, side, {FilmPart::grain, FilmPart::grain}, 3e6);
  add_wedges(0.4 * cell_side, 0.6 * cell_side, {FilmPart::gap, FilmPart::film}, 1e6);
  const auto first = fields.points.size();
  fields.points.insert(fields.points.end(),
                       {{0.0, 0.0, 0.0}, {cell_side, 0.0, 0.0}, {0.0, cell_side, 0.0}, {0.0, 0.0, side}});
  for (std::size_t corner = 0; corner < 4; ++corner) fields.corners.push_back(first + corner);
  fields.cells.push_back({.part = FilmPart::junction, .corners = 4, .strain = {0.0, 0.0, 0.0, 0.0, 0.0, 0.5}});
  fields.displacement.resize(fields.points.size());
  const auto study = test::two_stages();
  static_cast<void>(write_fields(folder, study, study.stages[0],
                                 {Load::shear, Boundary::displacement, Method::quasistatic, TestGrid::films()},
                                 NetworkFields<3>{{{1e-3, fields}}}));
}

// The film of a fifth of a cell is one cell thick in the view.
TEST_F(SpaceViews, OfGrainsAndFilmsShowThePieces) {
  auto test = test_with("fields.vtkhdf");
  test.id.grid = TestGrid::films();
  auto document = test::document_with("A", {test});
  document.stages.front().dimensions = 3;
  document.stages.front().side = 6e-3;
  write_study_document(directory.path(), document);
  write_film(directory.path() / "A");
  const auto field = view().at("fields").at("fields.vtkhdf");
  constexpr std::size_t along = 125;  // three bytes a cell, up to 6 MB
  EXPECT_EQ(field.at("cells"), along);
  const auto phases = unpacked(field.at("material").at("values"), along * along * along);
  ASSERT_EQ(phases.size(), along * along * along);
  const auto at = [&](std::size_t x, std::size_t y, std::size_t z) { return phases[(z * along + y) * along + x]; };
  EXPECT_EQ(at(100, 20, 0), 2) << "the gap";
  EXPECT_EQ(at(20, 100, 0), 0) << "the film";
  EXPECT_EQ(at(20, 100, 60), 1);
  EXPECT_EQ(at(100, 20, 124), 1);
  EXPECT_EQ(field.at("stress").at("words"), "Shear stress over mean shear strain in MPa");
  const auto stresses = unpacked(field.at("stress").at("values"), along * along * along);
  EXPECT_LT(stresses[100 * along + 20], stresses[(60 * along + 100) * along + 20]) << "in the film and in the grain";
  EXPECT_NEAR(field.at("strain").at("unit_size").get<double>(), 1.0, 1e-12) << "the mean by volume";
}

}  // namespace
}  // namespace breccia
