// Tests of results of earlier runs that are damaged or were not written by this program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "page/study_report.hpp"
#include "page/sweep_report.hpp"
#include "results/hand_made_documents.hpp"
#include "results/sweep_result.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

class StoredResults : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal_of_curve(const std::string& row) const {
    directory.write("curves.csv", "stage,load,boundary,method,cells,time_s,modulus_Pa\n" + row + "\n");
    return test::message_of<FileError>([&] { static_cast<void>(read_curves(directory.path())); });
  }
  [[nodiscard]] std::string refusal_of_study(const nlohmann::ordered_json& record) const {
    directory.write("study.json", record.dump());
    return test::message_of<FileError>([&] { static_cast<void>(study_page_data(directory.path())); });
  }

  test::TemporaryDirectory directory;
};

TEST_F(StoredResults, CurvesAreOfGridsAndHaveNumbers) {
  directory.write("curves.csv",
                  "stage,load,boundary,method,cells,time_s,modulus_Pa\n"
                  "A,shear,traction,quasistatic,12,1,2\nA,shear,traction,quasistatic,extrapolated,1,3\n");
  EXPECT_EQ(read_curves(directory.path()).size(), 2U);
  for (const auto* row : {"A,shear,traction,quasistatic,many,1,1", "A,shear,traction,quasistatic,99999999999,1,1",
                          "A,shear,traction,quasistatic,12,0,1", "A,shear,traction,quasistatic,12,inf,1",
                          "A,shear,traction,quasistatic,12,1,inf"}) {
    EXPECT_THAT(refusal_of_curve(row), HasSubstr("curves.csv:2: not as `breccia run` writes it")) << row;
  }
}

TEST_F(StoredResults, ARecordNamesGridsByIntegers) {
  auto record = json_from(test::document_with("A", {TestEntry()}));
  record["stages"][0]["tests"][0]["cells"] = 1e300;
  EXPECT_THAT(refusal_of_study(record), HasSubstr("study.json: not as `breccia run` writes it: expected an integer"));
}

TEST_F(StoredResults, ANameThatNoFileCanHaveIsTreatedAsMissing) {
  write_study_document(directory.path(), test::document_with(std::string(300, 'a')));
  EXPECT_EQ(study_page_data(directory.path()).title, "t");
}

// A study.json from elsewhere must not make the page embed files that only its reader may read.
TEST_F(StoredResults, NamesThatLeadOutOfTheResultsAreRefused) {
  directory.write("microstructure.svg", "secret");
  directory.write("x-stress.svg", "secret");
  for (const auto* name : {"../A", "/etc", "A/..", "..", ".", "", "-A", R"(A\B)"}) {
    EXPECT_THAT(refusal_of_study(json_from(test::document_with(name))),
                HasSubstr("is not a name that `breccia run` gives"))
        << name;
  }
  for (const auto* picture : {"/etc/passwd", "../x-stress.svg", "fields/../../x-stress.svg", "microstructure.svg"}) {
    TestEntry test;
    test.fields = {{1.0, "fields.vtkhdf", picture, "fields-strain.svg"}};
    EXPECT_THAT(refusal_of_study(json_from(test::document_with("A", {test}))),
                HasSubstr("is not a name that `breccia run` gives"))
        << picture;
  }
  auto record = json_from(test::document_with("A", {TestEntry()}));
  record["stages"][0]["tests"][0]["load"] = "../x";
  EXPECT_THAT(refusal_of_study(record), HasSubstr("unknown word \"../x\""));
  directory.write("sweep.json", R"({"title": "", "keys": [], "tasks": [{"state": "done", "name": "../other"}]})");
  EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(sweep_page_data(directory.path())); }),
              HasSubstr("sweep.json: \"../other\" is not a name that `breccia run` gives to a task"));
}

TEST_F(StoredResults, TablesReachThePageUnchanged) {
  write_study_document(directory.path(), test::document_with("A"));
  directory.write("comparison.csv",
                  "measurement,stage,boundary,method,cells,time_s,modulus_Pa,measured_Pa,ratio\n"
                  "\"Bennett et al., \"\"1998\"\" </script>\",A,displacement,quasistatic,12,0.1,2,4,0.5\n");
  directory.write("prony.csv", "stage,load,boundary,relaxation_time_s,modulus_Pa\nA,shear,displacement,inf,3\n");
  const auto tables = nlohmann::json::parse(study_page_data(directory.path()).json).at("tables");
  const auto& comparison = tables.at("comparison.csv");
  EXPECT_EQ(comparison.at("measurement"), nlohmann::json({"Bennett et al., \"1998\" </script>"}));
  EXPECT_EQ(comparison.at("cells"), nlohmann::json({"12"}));
  EXPECT_EQ(comparison.at("time_s"), nlohmann::json({0.1}));
  EXPECT_EQ(tables.at("prony.csv").at("relaxation_time_s"), nlohmann::json({"inf"})) << "JSON has no infinity";
  EXPECT_FALSE(tables.contains("curves.csv"));
}

TEST_F(StoredResults, ADamagedTableIsRefused) {
  write_study_document(directory.path(), test::document_with("A"));
  directory.write("prony.csv", "stage,load,boundary,relaxation_time_s,modulus_Pa\nA,shear,displacement,1\n");
  EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(study_page_data(directory.path())); }),
              HasSubstr("prony.csv:2: expected 5 values"));
}

}  // namespace
}  // namespace breccia
