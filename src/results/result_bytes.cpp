#include "results/result_bytes.hpp"

#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/study_document.hpp"

namespace breccia {

/// Curves as lists of their times and values.
template <class Pairs>
struct JsonColumns {
  static nlohmann::ordered_json write(const Pairs& pairs) {
    std::vector<double> first, second;
    for (const auto& [one, other] : pairs) {
      first.push_back(one);
      second.push_back(other);
    }
    return {first, second};
  }
  static Pairs read(const nlohmann::ordered_json& json) {
    const auto first = json.at(0).get<std::vector<double>>(), second = json.at(1).get<std::vector<double>>();
    Pairs pairs;
    for (std::size_t i = 0; i < first.size(); ++i) pairs.push_back({first[i], second.at(i)});
    return pairs;
  }
};
template <>
struct JsonForm<Curve> : JsonColumns<Curve> {};
template <>
struct JsonForm<Creep> : JsonColumns<Creep> {};

template <>
inline constexpr auto fields<ModulusError> = std::tuple(field("grid", &ModulusError::grid),
                                                        field("sample", &ModulusError::sample),
                                                        field("solver", &ModulusError::solver),
                                                        field("matrix", &ModulusError::matrix));

template <>
inline constexpr auto fields<ComplexSample> = std::tuple(field("angular_frequency", &ComplexSample::angular_frequency),
                                                         field("storage", &ComplexSample::storage),
                                                         field("loss", &ComplexSample::loss),
                                                         field("error", &ComplexSample::error));

template <>
TestResult blank_value() {
  return {.id = blank_value<TestId>()};
}
template <>
inline constexpr auto fields<TestResult> = std::tuple(
    field("id", &TestResult::id), field("modulus", &TestResult::modulus), field("compliance", &TestResult::compliance),
    field("series", &TestResult::series), field("error_estimate", &TestResult::error_estimate),
    field("half_bands", &TestResult::half_bands), field("errors", &TestResult::errors),
    field("in_frequency", &TestResult::in_frequency), field("seconds", &TestResult::seconds));

template <>
inline constexpr auto fields<Material> = std::tuple(field("name", &Material::name),
                                                    field("density", &Material::density),
                                                    field("bulk", &Material::bulk), field("shear", &Material::shear));

template <>
inline constexpr auto fields<HomogenisedMaterial> = std::tuple(field("material", &HomogenisedMaterial::material),
                                                               field("fitted", &HomogenisedMaterial::fitted),
                                                               field("shear_error", &HomogenisedMaterial::shear_error),
                                                               field("bulk_error", &HomogenisedMaterial::bulk_error));

template <>
inline constexpr auto fields<StageMaterial> = std::tuple(field("boundary", &StageMaterial::boundary),
                                                         field("method", &StageMaterial::method),
                                                         field("result", &StageMaterial::result));

template <>
inline constexpr auto fields<ComparedSample> = std::tuple(field("time", &ComparedSample::time),
                                                          field("modulus", &ComparedSample::modulus),
                                                          field("measured", &ComparedSample::measured),
                                                          field("error", &ComparedSample::error));

template <>
inline constexpr auto fields<ComparedComplexSample> = std::tuple(
    field("angular_frequency", &ComparedComplexSample::angular_frequency),
    field("storage", &ComparedComplexSample::storage), field("loss", &ComparedComplexSample::loss),
    field("measured_storage", &ComparedComplexSample::measured_storage),
    field("measured_loss", &ComparedComplexSample::measured_loss), field("error", &ComparedComplexSample::error));

template <>
Comparison blank_value() {
  return {{}, blank_value<TestId>(), {}};
}
template <>
inline constexpr auto fields<Comparison> = std::tuple(field("measurement", &Comparison::measurement),
                                                      field("test", &Comparison::test),
                                                      field("samples", &Comparison::samples),
                                                      field("in_frequency", &Comparison::in_frequency),
                                                      field("kind", &Comparison::kind));

template <>
inline constexpr auto fields<ExpansionSample> = std::tuple(field("time", &ExpansionSample::time),
                                                           field("expansion", &ExpansionSample::expansion),
                                                           field("error", &ExpansionSample::error));

template <>
inline constexpr auto fields<StiffnessSample> = std::tuple(field("time", &StiffnessSample::time),
                                                           field("constants", &StiffnessSample::constants),
                                                           field("error", &StiffnessSample::error));

template <>
StageStiffness blank_value() {
  return {blank_value<TestId>(), {}};
}
template <>
inline constexpr auto fields<StageStiffness> = std::tuple(field("test", &StageStiffness::test),
                                                          field("samples", &StageStiffness::samples));

template <>
StageExpansion blank_value() {
  return {blank_value<TestId>(), {}};
}
template <>
inline constexpr auto fields<StageExpansion> = std::tuple(field("test", &StageExpansion::test),
                                                          field("samples", &StageExpansion::samples));

template <>
inline constexpr auto fields<ErrorRules> = std::tuple(field("one_grid", &ErrorRules::one_grid),
                                                      field("sample", &ErrorRules::sample),
                                                      field("effective_particles", &ErrorRules::effective_particles));

template <>
inline constexpr auto fields<StageAccuracy> = std::tuple(field("summary", &StageAccuracy::summary),
                                                         field("grid_error", &StageAccuracy::grid_error),
                                                         field("rules", &StageAccuracy::rules));

template <>
inline constexpr auto fields<StageFindings> =
    std::tuple(field("name", &StageFindings::name), field("cells", &StageFindings::cells),
               field("dimensions", &StageFindings::dimensions), field("points", &StageFindings::points),
               field("point_fraction", &StageFindings::point_fraction), field("tests", &StageFindings::tests),
               field("materials", &StageFindings::materials), field("comparisons", &StageFindings::comparisons),
               field("expansions", &StageFindings::expansions), field("stiffness", &StageFindings::stiffness),
               field("accuracy", &StageFindings::accuracy), field("warnings", &StageFindings::warnings));

template <>
inline constexpr auto fields<ShiftedMaterial> = std::tuple(field("material", &ShiftedMaterial::material),
                                                           field("shift", &ShiftedMaterial::shift),
                                                           field("expansion", &ShiftedMaterial::thermal_expansion));

template <>
inline constexpr auto fields<StageContent> = std::tuple(field("name", &StageContent::name),
                                                        field("matrix", &StageContent::matrix),
                                                        field("dimensions", &StageContent::dimensions),
                                                        field("shares", &StageContent::shares));

template <>
inline constexpr auto fields<StudyContent> = std::tuple(field("title", &StudyContent::title),
                                                        field("times", &StudyContent::times),
                                                        field("by_frequency", &StudyContent::by_frequency),
                                                        field("stages", &StudyContent::stages),
                                                        field("materials", &StudyContent::materials));

namespace {

template <class Value>
std::string packed(const Value& value) {
  std::string bytes;
  nlohmann::ordered_json::to_msgpack(json_from(value), bytes);
  return bytes;
}

template <class Value>
Value unpacked(const std::string& bytes) {
  try {
    return value_from<Value>(nlohmann::ordered_json::from_msgpack(bytes));
  } catch (const nlohmann::ordered_json::exception& error) {
    throw FileError(fmt::format("these bytes are no result of Breccia: {}", error.what()));
  } catch (const InputError& error) {
    throw FileError(fmt::format("these bytes are no result of Breccia: {}", error.what()));
  }
}

}  // namespace

std::string bytes_of(const TestResult& test) {
  return packed(test);
}

std::string bytes_of(const StageFindings& stage) {
  return packed(stage);
}

std::string bytes_of(const StudyContent& content) {
  return packed(content);
}

TestResult test_from_bytes(const std::string& bytes) {
  return unpacked<TestResult>(bytes);
}

StageFindings stage_from_bytes(const std::string& bytes) {
  return unpacked<StageFindings>(bytes);
}

StudyContent content_from_bytes(const std::string& bytes) {
  return unpacked<StudyContent>(bytes);
}

}  // namespace breccia
