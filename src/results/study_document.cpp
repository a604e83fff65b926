#include "results/study_document.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/printable.hpp"
#include "io/safe_name.hpp"
#include "io/text_file.hpp"
#include "results/field_files.hpp"

namespace breccia {
namespace {

using Json = nlohmann::ordered_json;

ShiftEntry entry_of(const WilliamsLandelFerry& law) {
  return {.c1 = law.c1, .c2 = law.c2, .reference = law.reference_temperature};
}

ShiftEntry entry_of(const ShiftTable& table) {
  return {.temperatures = table.temperatures(),
          .log10_factors = table.log10_factors(),
          .reference = table.reference_temperature()};
}

ShiftLaw law_of(ShiftEntry entry) {
  if (entry.c1 && entry.c2) return WilliamsLandelFerry{*entry.c1, *entry.c2, entry.reference};
  if (!entry.temperatures || !entry.log10_factors) throw InputError("a temperature shift without a law");
  return ShiftTable(*std::move(entry.temperatures), *std::move(entry.log10_factors), entry.reference);
}

/// Throws InputError if study.json contains a name that no run writes: it could refer to any file that the user of the
/// results can read.
void require_written(const std::string& name, bool is_as_written) {
  if (!is_as_written) {
    throw InputError(fmt::format("\"{}\" is not a name that `breccia run` gives", printable(name)));
  }
}

void require_safe_names(const StudyDocument& document) {
  for (const auto& stage : document.stages) {
    require_written(stage.name, is_safe_name(stage.name));
    for (const auto& test : stage.tests) {
      for (const auto& files : test.fields) {
        for (const auto& name : files.names()) require_written(name, is_of_fields(name));
      }
    }
  }
}

/// Throws InputError for a material of the deck with a negative modulus.
void require_positive_moduli(const StudyDocument& document) {
  for (const auto& material : document.materials) {
    for (const auto* series : {&material.bulk, &material.shear}) {
      static_cast<void>(PronySeries(series->equilibrium(), series->terms()));
    }
  }
}

}  // namespace

ErrorRules rules_in(const QualityEntry& quality) {
  return {quality.expected_grid_error, quality.sample.value_or(SampleKind::unknown),
          quality.effective_particles.value_or(0.0)};
}

PronySeries JsonForm<PronySeries>::read(const Json& json) {
  const auto entry = value_from<SeriesEntry>(json);
  std::vector<MaxwellTerm> positive, negative;
  for (const auto& [time, modulus] : entry.terms) {
    (modulus < 0.0 ? negative : positive).push_back({time, std::abs(modulus)});
  }
  PronySeries whole(std::max(entry.equilibrium, 0.0), std::move(positive));
  if (entry.equilibrium >= 0.0 && negative.empty()) return whole;
  return PronySeries::difference(whole, PronySeries(std::max(-entry.equilibrium, 0.0), std::move(negative)));
}

Json JsonForm<TemperatureShift>::write(const TemperatureShift& shift) {
  auto entry = std::visit([](const auto& law) { return entry_of(law); }, shift.law);
  entry.temperature = shift.temperature;
  return json_from(entry);
}

TemperatureShift JsonForm<TemperatureShift>::read(const Json& json) {
  const auto entry = value_from<ShiftEntry>(json);
  return {law_of(entry), entry.temperature};
}

Json JsonForm<TestGrid>::write(const TestGrid& grid) {
  const auto cells = grid.cells();
  return cells ? Json(*cells) : Json(name_of(grid));
}

TestGrid JsonForm<TestGrid>::read(const Json& json) {
  if (!json.is_string()) return TestGrid(value_from<int>(json));
  if (const auto grid = grid_named(json.get<std::string>()); grid && !grid->cells()) return *grid;
  throw InputError(fmt::format("expected a grid in place of {}", json.dump()));
}

Json JsonForm<LinearEffort>::write(const LinearEffort& effort) {
  Json json = {{"method", effort.is_direct ? "direct" : "iterative"}};
  add_fields(json, effort);
  return json;
}

LinearEffort JsonForm<LinearEffort>::read(const Json& json) {
  LinearEffort effort;
  effort.is_direct = json.at("method") == "direct";
  read_fields(json, effort);
  return effort;
}

Json JsonForm<std::vector<PhaseModuli>>::write(const std::vector<PhaseModuli>& phases) {
  auto json = Json::object();
  for (const auto& [phase, moduli] : phases) json[phase] = json_from(moduli);
  return json;
}

std::vector<PhaseModuli> JsonForm<std::vector<PhaseModuli>>::read(const Json& json) {
  std::vector<PhaseModuli> phases;
  for (const auto& [phase, moduli] : json.items()) phases.push_back({phase, value_from<Moduli>(moduli)});
  return phases;
}

Json JsonForm<FieldRecord>::write(const FieldRecord& files) {
  auto json = Json::object();
  add_fields(json, files);
  if (!files.work_picture.empty()) json["work_picture"] = files.work_picture;
  return json;
}

FieldRecord JsonForm<FieldRecord>::read(const Json& json) {
  FieldRecord files;
  read_fields(json, files);
  files.work_picture = json.value("work_picture", "");
  return files;
}

namespace {

/// Adds the fields of a record to those of its test.
struct AddRecord {
  Json& test;

  void operator()(std::monostate /*unknown*/) const {}
  template <class Record>
  void operator()(const Record& record) const {
    add_fields(test, record);
  }
};

}  // namespace

Json JsonForm<TestEntry>::write(const TestEntry& test) {
  auto json = json_from(test.id);
  std::visit(AddRecord{json}, test.record);
  if (!test.fields.empty()) json["fields"] = json_from(test.fields);
  return json;
}

TestEntry JsonForm<TestEntry>::read(const Json& json) {
  TestEntry test;
  read_fields(json, test.id);
  if (json.contains("solver")) {
    test.record = value_from<QuasistaticEntry>(json);
  } else if (json.contains("time_domains")) {
    test.record = value_from<DynamicEntry>(json);
  } else if (json.contains("from_cells")) {
    test.record = value_from<ExtrapolationRecord>(json);
  } else if (json.contains("mean_of")) {
    test.record = value_from<MeanEntry>(json);
  }
  if (json.contains("fields")) test.fields = value_from<std::vector<FieldRecord>>(json.at("fields"));
  return test;
}

Json JsonForm<std::vector<FileHash>>::write(const std::vector<FileHash>& files) {
  auto json = Json::object();
  for (const auto& [name, hash] : files) json[name] = hash;
  return json;
}

std::vector<FileHash> JsonForm<std::vector<FileHash>>::read(const Json& json) {
  std::vector<FileHash> files;
  for (const auto& [name, hash] : json.items()) files.push_back({name, hash.get<std::string>()});
  return files;
}

namespace {

/// The version of Breccia that has written a record, in words, if it is another one than this.
std::optional<std::string> other_version(const Json& json) {
  if (!json.is_object() || json.value("program", Json()) != "breccia") return std::nullopt;
  const auto version = json.value("version", Json());
  if (!version.is_string()) return "another version";
  if (version == BRECCIA_VERSION) return std::nullopt;
  return "version " + version.get<std::string>();
}

}  // namespace

StudyDocument read_study_document(const std::filesystem::path& directory) {
  const auto file = directory / "study.json";
  const auto json = Json::parse(read_text(file), nullptr, false);
  const auto refuse = [&](const std::string& reason) {
    const auto problem = fmt::format("{}: not as `breccia run` writes it{}", file.string(), reason);
    const auto other = other_version(json);
    if (!other) throw FileError(problem);
    throw OtherFormat(directory, fmt::format("{}; it is of {} of Breccia, this is version {}: read it by that version, "
                                             "or run the study again and replace these results",
                                             problem, *other, BRECCIA_VERSION));
  };
  if (!json.is_object()) refuse("");
  StudyDocument document;
  try {
    document = value_from<StudyDocument>(json);
    require_safe_names(document);
    require_positive_moduli(document);
  } catch (const Json::exception& error) {
    refuse(fmt::format(": {}", error.what()));
  } catch (const InputError& error) {
    refuse(fmt::format(": {}", error.what()));
  }
  return document;
}

void write_study_document(const std::filesystem::path& directory, const StudyDocument& document) {
  const auto json = json_from(document);
  write_text(directory / "study.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace breccia
