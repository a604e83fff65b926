#include "results/stored_document.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "results/hand_made_documents.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

const std::string binder = R"({"name": "binder", "density_kg_per_m3": 1000.0,
  "bulk": {"equilibrium_Pa": 2e9, "terms": []},
  "shear": {"equilibrium_Pa": 0.0, "terms": [{"relaxation_time_s": 3.0, "modulus_Pa": 1e6}]})";
const std::string law =
    R"(, "temperature_shift": {"c1": 10.0, "c2_K": 100.0, "reference_K": 300.0, "temperature_K": 320.0})";

class StoredDocument : public testing::Test {
 protected:
  [[nodiscard]] std::vector<ShiftedMaterial> read(const std::string& materials) const {
    auto document = test::document_with("A");
    auto record = json_from(document);
    record["materials"] = nlohmann::ordered_json::parse("[" + materials + "]");
    directory.write("study.json", record.dump());
    return materials_of(read_study_document(directory.path()));
  }

  test::TemporaryDirectory directory;
};

TEST_F(StoredDocument, HasMaterialsThatAreShiftedFromTheTemperatureOfTheStudy) {
  const auto stored = read(binder + law + "}");
  ASSERT_EQ(stored.size(), 1U);
  // log10 a_T is -10 x 20 / 120 at 320 K and 10 x 20 / 80 at 280 K.
  const auto cold = at_temperature(stored.front(), 280.0).material;
  ASSERT_EQ(cold.shear.terms().size(), 1U);
  EXPECT_NEAR(std::log10(cold.shear.terms().front().relaxation_time / 3.0), 200.0 / 80.0 + 200.0 / 120.0, 1e-12);
  EXPECT_EQ(cold.shear.terms().front().modulus, 1e6);
  EXPECT_EQ(at_temperature(stored.front(), 320.0).material, stored.front().material);
}

TEST_F(StoredDocument, HasMaterialsThatAreShiftedByATable) {
  const auto stored = read(binder + R"(, "temperature_shift": {"temperatures_K": [280.0, 300.0, 340.0],
    "log10_shift_factors": [2.0, 0.0, -1.0], "reference_K": 300.0, "temperature_K": 320.0}})");
  const auto cold = at_temperature(stored.front(), 290.0).material;
  EXPECT_NEAR(std::log10(cold.shear.terms().front().relaxation_time / 3.0), 1.5, 1e-12);
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(at_temperature(stored.front(), 270.0)); }),
              HasSubstr("the table of shift factors reaches from 280 K"));
}

TEST_F(StoredDocument, HasMaterialsThatNeedAShiftLawIfTheyRelaxAndATemperatureInItsRange) {
  const auto without = read(binder + "}").front();
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(at_temperature(without, 280.0)); }),
              HasSubstr("binder has no temperature_shift in the deck"));
  const auto with = read(binder + law + "}").front();
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(at_temperature(with, 200.0)); }),
              HasSubstr("the shift law has no meaning at or below"));
  auto elastic = without;
  elastic.material.shear = PronySeries(1e6);
  EXPECT_EQ(at_temperature(elastic, 280.0).material, elastic.material);
}

TEST_F(StoredDocument, IsRefusedInFilesThatTheProgramHasNotWritten) {
  for (const auto* materials :
       {"1", R"({"name": 1})",
        R"({"name": "a", "density_kg_per_m3": 1, "bulk": {"equilibrium_Pa": -1, "terms": []}})"}) {
    EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(read(materials)); }),
                HasSubstr("not as `breccia run` writes it"))
        << materials;
  }
  directory.write("study.json", "[");
  EXPECT_THROW(static_cast<void>(read_study_document(directory.path())), FileError);
}

}  // namespace
}  // namespace breccia
