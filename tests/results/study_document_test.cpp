#include "results/study_document.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::Gt;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

/// Random values of all types of the document, from their descriptions.
class RandomValues {
 public:
  explicit RandomValues(std::uint64_t seed) : engine_(seed) {}

  template <class Value>
  Value value() {
    Value one{};
    fill(one);
    return one;
  }

 private:
  std::uint64_t below(std::uint64_t bound) { return engine_() % bound; }

  void fill(bool& value) { value = below(2) == 1; }
  void fill(int& value) { value = static_cast<int>(below(1000)); }
  void fill(std::int64_t& value) { value = static_cast<std::int64_t>(below(std::uint64_t{1} << 62)); }
  void fill(std::uint64_t& value) { value = engine_(); }
  void fill(double& value) {
    value = std::ldexp(static_cast<double>(engine_() >> 11) - 0x1p52, static_cast<int>(below(1000)) - 550);
  }
  void fill(std::string& text) {
    constexpr std::array<const char*, 8> pieces = {"a", "\"", "\\", "\n", "µ", " ", "7", "/"};
    for (auto length = below(6); length > 0; --length) text += pieces[below(pieces.size())];
  }
  template <HasWords Enum>
  void fill(Enum& value) {
    value = words<Enum>[below(words<Enum>.size())].second;
  }
  template <class Value>
  void fill(std::optional<Value>& value) {
    if (below(2) == 0) fill(value.emplace());
  }
  template <class Value>
  void fill(std::vector<Value>& values) {
    for (auto size = below(4); size > 0; --size) values.push_back(value<Value>());
  }
  void fill(std::vector<TestGrid>& grids) {
    for (auto size = below(4); size > 0; --size) grids.push_back(grid());
  }
  template <HasFields Struct>
  void fill(Struct& value) {
    std::apply([&](const auto&... field) { (fill(value.*field.member), ...); }, fields<Struct>);
  }
  void fill(TimeWindow& window) { window = {value<double>(), value<double>()}; }
  void fill(MaxwellTerm& term) { term = {std::abs(value<double>()) + 1e-300, std::abs(value<double>())}; }
  void fill(PronySeries& series) { series = PronySeries(std::abs(value<double>()), value<std::vector<MaxwellTerm>>()); }
  void fill(std::optional<TemperatureShift>& shift) {
    if (below(3) == 0) return;
    const double temperature = 300.0 + value<int>();
    if (below(2) == 0) {
      shift = {WilliamsLandelFerry{1.0 + value<int>(), 50.0, 290.0}, temperature};
    } else {
      shift = {ShiftTable({280.0, 300.0, 340.0}, {2.0, 0.0, -1.0 - value<int>() % 50}, 300.0), temperature};
    }
  }
  TestGrid grid() {
    const auto kind = below(4);
    return kind == 0 ? TestGrid::films() : kind == 1 ? TestGrid::extrapolated() : TestGrid(1 + value<int>());
  }
  void fill(LinearEffort& effort) {
    effort.is_direct = value<bool>();
    std::apply([&](const auto&... field) { (fill(effort.*field.member), ...); }, fields<LinearEffort>);
  }
  void fill(std::vector<PhaseModuli>& phases) {
    for (const auto* phase : {"filler", "coating of ap"}) phases.push_back({phase, value<Moduli>()});
  }
  void fill(FieldRecord& files) {
    const auto name = "fields-" + std::to_string(below(9));
    files = {value<double>(), name + ".vtkhdf", name + "-stress.svg", name + "-strain.svg",
             below(2) == 0 ? "" : name + "-work.svg"};
  }
  void fill(std::vector<FileHash>& files) {
    for (const auto* name : {"p.csv", "sizes \"of\" ap.csv"}) files.push_back({name, value<std::string>()});
  }
  void fill(TestEntry& test) {
    test.id = {value<Load>(), value<Boundary>(), value<Method>(), grid()};
    switch (below(4)) {
      case 0:
        test.record = value<QuasistaticEntry>();
        break;
      case 1:
        test.record = value<DynamicEntry>();
        break;
      case 2:
        test.record = value<ExtrapolationRecord>();
        break;
      default:
        break;
    }
    fill(test.fields);
  }
  void fill(std::vector<StageEntry>& stages) {
    for (auto size = below(4); size > 0; --size) {
      stages.push_back(value<StageEntry>());
      stages.back().name = "A-" + std::to_string(size);
    }
  }

  std::mt19937_64 engine_;
};

// Equality of all values of the document, by their descriptions.

template <class Value>
bool are_equal(const Value& one, const Value& other);
template <class Value>
bool are_equal(const std::vector<Value>& some, const std::vector<Value>& others);

template <class Value>
bool are_equal(const std::optional<Value>& one, const std::optional<Value>& other) {
  return one.has_value() == other.has_value() && (!one || are_equal(*one, *other));
}

template <class Value>
bool are_equal(const std::vector<Value>& some, const std::vector<Value>& others) {
  return std::ranges::equal(some, others, [](const Value& one, const Value& other) { return are_equal(one, other); });
}

template <class Value>
bool are_equal(const Value& one, const Value& other) {
  if constexpr (std::equality_comparable<Value>) {
    return one == other;
  } else if constexpr (HasFields<Value>) {
    const auto equal = [&](const auto& field) { return are_equal(one.*field.member, other.*field.member); };
    return std::apply([&](const auto&... field) { return (equal(field) && ...); }, fields<Value>);
  } else {
    return json_from(one) == json_from(other);
  }
}

class StudyDocumentFile : public testing::Test {
 protected:
  [[nodiscard]] StudyDocument read_back(const StudyDocument& document) const {
    write_study_document(directory.path(), document);
    return read_study_document(directory.path());
  }
  [[nodiscard]] std::string refusal_of(const std::string& text) const {
    directory.write("study.json", text);
    return test::message_of<FileError>([&] { static_cast<void>(read_study_document(directory.path())); });
  }

  test::TemporaryDirectory directory;
};

TEST_F(StudyDocumentFile, IsReadBackAsItWasWritten) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto document = RandomValues(seed).value<StudyDocument>();
    const auto found = read_back(document);
    const auto text = read_text(directory.path() / "study.json");
    ASSERT_TRUE(are_equal(found, document)) << "seed " << seed << ":\n" << text;
    write_study_document(directory.path(), found);
    ASSERT_EQ(read_text(directory.path() / "study.json"), text) << "seed " << seed;
  }
}

// K = (K + G/3) - G/3 of a stage in plane strain.
TEST_F(StudyDocumentFile, HasTheNegativeModuliOfAStageButOfNoMaterial) {
  const auto series = PronySeries::difference(PronySeries(1.0, {{2.0, 3.0}}), PronySeries(2.0, {{5.0, 0.1}}));
  StudyDocument document;
  document.stages.push_back({.name = "A"});
  document.stages.back().materials.push_back({.material = {"A", 1e3, series, PronySeries(1.0)}});
  EXPECT_EQ(read_back(document).stages.at(0).materials.at(0).material.bulk, series);
  document.materials.push_back({"binder", 1e3, series, PronySeries(1.0)});
  write_study_document(directory.path(), document);
  EXPECT_THAT(refusal_of(read_text(directory.path() / "study.json")), HasSubstr("must be finite and not negative"));
}

// An older or a newer format: the user learns of which version it is, and what helps.
TEST_F(StudyDocumentFile, OfAnotherVersionIsRefusedWithTheWayOutWhereItCannotBeRead) {
  StudyDocument document;
  document.program = "breccia";
  for (const auto* version : {"0.0.1", "9.0.0"}) {
    document.version = version;
    EXPECT_EQ(read_back(document).version, version) << "in the same format";
    const auto text = read_text(directory.path() / "study.json");
    directory.write("study.json", test::replaced(text, "times_s", "window_s"));
    try {
      static_cast<void>(read_study_document(directory.path()));
      ADD_FAILURE() << "read without a key";
    } catch (const OtherFormat& error) {
      EXPECT_EQ(error.directory(), directory.path());
      EXPECT_THAT(error.what(),
                  AllOf(HasSubstr("study.json: not as `breccia run` writes it"),
                        HasSubstr(fmt::format("it is of version {} of Breccia, this is version {}: read it by that "
                                              "version, or run the study again and replace these results",
                                              version, BRECCIA_VERSION))));
    }
  }
  EXPECT_THAT(refusal_of(R"({"program": "breccia", "format": 7})"), HasSubstr("it is of another version of Breccia"));
  EXPECT_THAT(refusal_of(R"({"program": "breccia", "version": ")" BRECCIA_VERSION R"("})"), Not(HasSubstr("it is of")));
  EXPECT_THAT(refusal_of(R"({"program": "other", "version": "9.0.0"})"), Not(HasSubstr("it is of")));
}

TEST_F(StudyDocumentFile, HasNullForNumbersThatAreNotFinite) {
  StudyDocument document;
  document.stages.push_back({.name = "A"});
  TestEntry test;
  test.record = QuasistaticEntry{.error_estimate = std::numeric_limits<double>::quiet_NaN()};
  document.stages.back().tests.push_back(test);
  const auto found = read_back(document);
  EXPECT_THAT(read_text(directory.path() / "study.json"), HasSubstr("\"error_estimate\": null"));
  EXPECT_FALSE(std::get<QuasistaticEntry>(found.stages.at(0).tests.at(0).record).error_estimate);
}

TEST_F(StudyDocumentFile, IsRefusedWithANullForANumberThatIsAlwaysKnown) {
  StudyDocument document;
  document.materials.push_back({"binder", 1e3, PronySeries(1.0), PronySeries(1.0)});
  auto record = json_from(document);
  record["materials"][0]["density_kg_per_m3"] = nullptr;
  EXPECT_THAT(refusal_of(record.dump()), HasSubstr("not as `breccia run` writes it"));
}

/// The keys of a struct and of all structs in its fields.
template <class Value>
void add_keys(std::set<std::string>& keys) {
  if constexpr (HasFields<Value>) {
    const auto add = [&]<class Struct, class Member>(const Field<Struct, Member>& field) {
      keys.insert(field.key);
      add_keys<Member>(keys);
    };
    std::apply([&](const auto&... field) { (add(field), ...); }, fields<Value>);
  } else if constexpr (requires { typename Value::value_type; }) {
    if constexpr (!std::is_same_v<Value, std::string>) add_keys<typename Value::value_type>(keys);
  }
}

TEST(StudyDocumentKeys, AreExplainedInTheReference) {
  std::set<std::string> keys;
  add_keys<StudyDocument>(keys);
  add_keys<TestId>(keys);
  for (const auto& add : {add_keys<QuasistaticEntry>, add_keys<DynamicEntry>, add_keys<ExtrapolationRecord>,
                          add_keys<SeriesEntry>, add_keys<ShiftEntry>, add_keys<FieldRecord>}) {
    add(keys);
  }
  ASSERT_THAT(keys, SizeIs(Gt(100)));
  const auto reference = read_text(BRECCIA_DOCUMENTATION "/results.md");
  for (const auto& key : keys) EXPECT_THAT(reference, HasSubstr("`" + key + "`"));
}

TEST_F(StudyDocumentFile, IsRefusedWhereAKeyIsMissingOrOfAnotherType) {
  write_study_document(directory.path(), RandomValues(7).value<StudyDocument>());
  const auto whole = nlohmann::ordered_json::parse(read_text(directory.path() / "study.json"));
  for (const auto& [key, value] : whole.items()) {
    auto record = whole;
    record.erase(key);
    const bool is_optional = key == "frequencies_Hz";
    if (!is_optional) {
      EXPECT_THAT(refusal_of(record.dump()), HasSubstr("study.json: not as `breccia run` writes it")) << key;
    }
    record = whole;
    record[key] = nlohmann::ordered_json::array({nlohmann::ordered_json::array({true})});
    EXPECT_THAT(refusal_of(record.dump()), HasSubstr("not as `breccia run` writes it")) << key;
  }
  for (const auto* text : {"", "[", "[]", "7", "{}"}) {
    EXPECT_THAT(refusal_of(text), HasSubstr("not as `breccia run` writes it")) << text;
  }
}

TEST_F(StudyDocumentFile, IsRefusedWithNamesThatLeadOutOfTheResults) {
  StudyDocument document;
  document.stages.push_back({.name = "../A"});
  write_study_document(directory.path(), document);
  EXPECT_THAT(refusal_of(read_text(directory.path() / "study.json")),
              HasSubstr("\"../A\" is not a name that `breccia run` gives"));
  document.stages.back().name = "A";
  document.stages.back().tests.emplace_back().fields.push_back({1.0, "../fields.vtkhdf", "a", "b"});
  write_study_document(directory.path(), document);
  EXPECT_THAT(refusal_of(read_text(directory.path() / "study.json")), HasSubstr("\"../fields.vtkhdf\" is not a name"));
}

}  // namespace
}  // namespace breccia
