// What an earlier run has left, damaged or not of this program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "study/report_data.hpp"
#include "study/sweep_results.hpp"
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
  [[nodiscard]] std::string refusal_of_study(const std::string& json) const {
    directory.write("study.json", json);
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
  EXPECT_THAT(refusal_of_study(R"({"title": "", "hash": "", "stages": [{"name": "A", "tests": [
                               {"load": "shear", "boundary": "traction", "cells": 1e300, "time_domains": [1]}]}]})"),
              HasSubstr("study.json: not as `breccia run` writes it"));
}

TEST_F(StoredResults, ANameThatNoFileCanHaveIsOfNone) {
  const std::string name(300, 'a');
  directory.write("study.json", R"({"title": "t", "hash": "", "stages": [{"name": ")" + name + R"(", "tests": []}]})");
  EXPECT_EQ(study_page_data(directory.path()).title, "t");
}

}  // namespace
}  // namespace breccia
