#include "page/report.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/results/curves.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "one_vector_response.hpp"
#include "page/study_report.hpp"
#include "results/hand_made_results.hpp"
#include "results/history_file.hpp"
#include "results/microstructure_files.hpp"
#include "results/provenance.hpp"
#include "results/response_file.hpp"
#include "study/identity.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const TestId dynamic{Load::shear, Boundary::displacement, Method::dynamic, TestGrid(12)};

/// The results of a study with a stage that has a dynamic test.
class Report : public testing::Test {
 protected:
  Report() {
    study.title = "one <scale>";
    study.provenance.hash = "0123456789abcdef";
    study.stages.pop_back();
    study.provenance.content = content_of(study);
    auto test = test::test_with(dynamic, {{1e-3, 2.0}, {1e-2, 1.0}});
    DynamicRecord record;
    record.domains.resize(2);
    for (auto& domain : record.domains) domain.seconds = 1.0;
    record.domains[0].history = {{-1.0, 0.0}, {1.0, 1.0 / 3.0}};
    test.record = std::move(record);
    auto done = test::stage_with("fine", {test});
    done.microstructure.box = Microstructure<2>{6e-3, Walls::hard, {{{1e-3, 1e-3}, 2e-3}}};
    const StudyResult result{{done}, 1.0};
    std::filesystem::create_directory(directory.path() / "fine");
    write_provenance(directory.path(), study, result);
    write_curves(directory.path(), result);
    write_microstructure(directory.path() / "fine", stage(), done.microstructure);
  }
  [[nodiscard]] const Stage& stage() const { return study.stages.front(); }
  /// Writes the history of the first time domain as that of a study with this hash.
  void write_history_of(const std::string& hash) const {
    auto other = study;
    other.provenance.hash = hash;
    TimeDomain domain;
    domain.history = {{-1.0, 0.0}, {1.0, 1.0 / 3.0}};
    write_history(directory.path() / "fine", other, stage(), dynamic, 1, domain);
  }
  void write_response_of(const std::string& hash) const {
    StageResponses responses;
    responses.stage = "fine";
    responses.matrix = test::binder;
    responses.side = 6e-3;
    responses.times = {1e-3, 1e-2};
    responses.deck_hash = hash;
    responses.entries = {{TestGrid(12), test::one_vector_response(Load::shear, Boundary::traction, {3.0, 2.0, 0.5},
                                                                  {{{{.bulk = 1e9, .shear = 1e6}}, 0.0}})}};
    write_responses(directory.path() / "fine", responses);
  }
  [[nodiscard]] json data() const { return json::parse(study_page_data(directory.path()).json); }
  [[nodiscard]] std::string refusal() const {
    return test::message_of<FileError>([&] { write_report(directory.path()); });
  }

  test::TemporaryDirectory directory;
  Study study = test::two_stages();
};

TEST_F(Report, HasWhatIsOnTheDisk) {
  write_history_of(study.provenance.hash);
  write_response_of(study.provenance.hash);
  const auto page = data();
  EXPECT_EQ(page.at("study").at("hash"), "0123456789abcdef");
  EXPECT_EQ(page.at("tables").at("curves.csv").at("modulus_Pa"), json({2.0, 1.0}));
  EXPECT_EQ(page.at("tables").at("curves.csv").at("cells"), json({"12", "12"})) << "text, for it may be extrapolated";
  EXPECT_EQ(page.at("pictures").at("fine"), read_text(directory.path() / "fine" / "microstructure.svg"));
  EXPECT_EQ(page.at("histories").at("fine"),
            json::parse(R"([{"load": "shear", "boundary": "displacement", "cells": 12, "domain": 0,
                             "time_s": [-1.0, 1.0], "value": [0.0, 0.333333]}])"))
      << "the second domain has left none";
  EXPECT_EQ(page.at("responses").at("fine"),
            json::parse(R"([{"load": "shear", "boundary": "traction", "cells": 12, "filler_Pa": [[3.0]],
                             "matrix_shear": [[2.0]], "matrix_bulk": [[0.5]], "load_forces": [1.0],
                             "snapshots": [{"shear_Pa": 1e6, "bulk_Pa": 1e9}]}])"));
}

TEST_F(Report, IsWrittenOfResultsThatAreNotComplete) {
  const auto page = data();
  EXPECT_TRUE(page.at("histories").at("fine").empty());
  EXPECT_FALSE(page.at("responses").contains("fine"));
  write_report(directory.path());
  EXPECT_THAT(read_text(directory.path() / "report.html"),
              AllOf(HasSubstr("one &lt;scale>"), Not(HasSubstr("<title>one <scale>")), HasSubstr("0123456789abcdef")));
}

TEST_F(Report, RefusesFilesOfAnotherStudy) {
  write_history_of("fedcba9876543210");
  EXPECT_THAT(refusal(), HasSubstr("shear-displacement-dynamic-12-1.h5: of another study (hash fedcba9876543210) than "
                                   "study.json (hash 0123456789abcdef)"));
  write_history_of(study.provenance.hash);
  write_response_of("fedcba9876543210");
  EXPECT_THAT(refusal(), HasSubstr("response.h5: of another study (hash fedcba9876543210)"));
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "report.html"));
}

TEST_F(Report, RefusesFilesThatAreTorn) {
  write_response_of(study.provenance.hash);
  const auto response = directory.path() / "fine" / "response.h5";
  std::filesystem::resize_file(response, std::filesystem::file_size(response) / 2);
  EXPECT_THAT(refusal(), HasSubstr("response.h5: cannot"));
  std::filesystem::remove(response);
  write_text(directory.path() / "curves.csv", "stage,load,boundary,method,cells,time_s,modulus_Pa\nfine,shear\n");
  EXPECT_THAT(refusal(), HasSubstr("curves.csv:2: expected 7 values"));
}

TEST_F(Report, IsOfTheSweepWhereThereIsOne) {
  directory.write("sweep.json", R"({"title": "many", "keys": [], "tasks": []})");
  write_report(directory.path());
  EXPECT_THAT(read_text(directory.path() / "report.html"), HasSubstr("many"));
}

TEST_F(Report, IsRefusedWithoutResults) {
  const test::TemporaryDirectory empty;
  EXPECT_THAT(test::message_of<InputError>([&] { write_report(empty.path()); }),
              HasSubstr("no study.json or sweep.json, which `breccia run` leaves with its results"));
  empty.write("study.json", R"({"title": "cut o)");
  EXPECT_THAT(test::message_of<FileError>([&] { write_report(empty.path()); }),
              HasSubstr("study.json: not as `breccia run` writes it"));
}

}  // namespace
}  // namespace breccia
