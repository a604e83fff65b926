#include "studio/session.hpp"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "studio/example_decks.hpp"
#include "studio/replaced_parts.hpp"
#include "studio/result_list.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

FinishedCommand finished(std::optional<FinishedCommand> command) {
  if (!command) throw Conflict("a later request has taken its place");
  return std::move(*command);
}

std::string without_suffix(const std::string& name) {
  return fs::path(name).stem().string();
}

Json list_of(const std::vector<ListedDeck>& decks) {
  auto json = Json::array();
  for (const auto& deck : decks) json.push_back({{"name", deck.name}, {"title", deck.title}});
  return json;
}

Json list_of(const std::vector<ExampleDeck>& decks) {
  auto json = Json::array();
  for (const auto& deck : decks) {
    json.push_back({{"name", deck.name}, {"title", deck.title}, {"about", deck.about}});
  }
  return json;
}

/// The results, whose pages are below an address.
Json list_of(const std::vector<ListedResult>& results, const std::string& results_at) {
  auto json = Json::array();
  for (const auto& result : results) {
    Json one = {{"path", result.path},         {"title", result.title},
                {"deck", result.deck},         {"deck_text", result.deck_text},
                {"date", result.date},         {"complete", result.is_complete},
                {"is_sweep", result.is_sweep}, {"seconds", nullptr},
                {"report", nullptr},           {"command", nullptr}};
    if (result.seconds) one["seconds"] = *result.seconds;
    if (result.has_page) {
      one["report"] = fmt::format("{}files/{}/report.html", results_at, result.path);
      one["command"] = opening_command(result.path + "/report.html");
    }
    json.push_back(std::move(one));
  }
  return json;
}

/// Adds an option with the value that the page has for it, if it has one. Throws InputError for a value that would be
/// another option.
void add_option(Command& command, const std::string& option, const std::string& value) {
  if (value.empty()) return;
  if (value.starts_with("--"))
    throw InputError(fmt::format("{}: expected a value, got {}", option, shown_value(value)));
  command.arguments.push_back(option);
  command.arguments.push_back(value);
}

}  // namespace

Session::Session(const Places& places)
    : places_(places),
      folder_(places.folder),
      preview_files_(previews_.path()),
      checks_(program()),
      packings_(program()),
      fits_(program()),
      comparisons_(program()),
      run_(program()) {}

Program Session::program() const {
  return {places_.program, folder_.path()};
}

Json Session::state() {
  const auto run = run_status();
  return {{"folder", folder_.path().string()},
          {"version", BRECCIA_VERSION},
          {"cores", std::thread::hardware_concurrency()},
          {"decks", list_of(folder_.decks())},
          {"tables", folder_.files(table_suffixes)},
          {"pictures", folder_.files(picture_suffixes)},
          {"examples", list_of(example_decks(places_.examples))},
          {"results", list_of(results_in(folder_), places_.results_at)},
          {"opened", places_.opened.empty() ? Json(nullptr) : Json(places_.opened)},
          {"job", run}};
}

Json Session::deck(const std::string& name) const {
  return json_of(folder_.deck(name));
}

Json Session::add_deck(const Json& request) {
  const auto example = optional_text(request, "example");
  const auto deck = copy_example(places_.examples, example.empty() ? "starter.toml" : example, folder_,
                                 required_text(request, "name"));
  auto json = json_of(deck);
  json["command"] = example.empty() ? shown({.arguments = {"new", deck.name}})
                                    : copying_command((places_.examples / example).string(), deck.name);
  return json;
}

Json Session::save_deck(const Json& request) {
  return json_of(folder_.save_deck(
      {required_text(request, "name"), required_text(request, "text"), required_text(request, "version")}));
}

Json Session::upload(const std::string& name, std::string_view bytes) {
  folder_.add_data(name, bytes);
  return {{"name", name}, {"command", copying_command(name, folder_.path().string())}};
}

Json Session::check(const Json& request) {
  const auto name = folder_.deck(required_text(request, "name")).name;
  const Command command = {.arguments = {"check", name}};
  const auto answer = finished(checks_.run(name, command));
  auto json = json_of(command, answer);
  auto mistakes = mistakes_in(answer.output, name);
  // What is a mistake of no single line, such as a lack of memory.
  if (answer.exit_code != 0 && mistakes.empty()) mistakes.push_back({.message = failure_in(answer.output)});
  json["mistakes"] = json_of(mistakes);
  return json;
}

Json Session::pack(const Json& request) {
  const auto name = folder_.deck(required_text(request, "name")).name;
  const auto place = previews_.next();
  const Command command = {.arguments = {"pack", name}, .hidden = {"--out", place.string()}};
  auto answer = finished(packings_.run(name, command));
  answer.output = replaced(std::move(answer.output), place.string(), "results/" + without_suffix(name));
  auto json = json_of(command, answer);
  json["stages"] = Json::array();
  for (const auto& picture : pictures_below(place)) {
    json["stages"].push_back({{"name", fs::path(picture).parent_path().filename().string()}, {"picture", picture}});
  }
  return json;
}

Json Session::fit(const Json& request) {
  const auto file = required_text(request, "file");
  (void)folder_.file(file);
  const auto options = request.value("options", Json::object());
  Command command = {.arguments = {"fit", file}};
  add_option(command, "--modulus", optional_text(options, "modulus"));
  add_option(command, "--reference-temperature", optional_text(options, "reference_temperature"));
  for (const auto& column : options.value("columns", std::vector<std::string>())) {
    add_option(command, "--columns", column);
  }
  command.arguments.emplace_back("--overwrite");
  const auto answer = finished(fits_.run(file, command));
  auto json = json_of(command, answer);
  const auto page = fmt::format("results/{}-fit/report.html", without_suffix(file));
  const bool has_page = answer.exit_code == 0 && fs::exists(folder_.path() / page);
  json["failure"] = answer.exit_code == 0 ? "" : failure_in(answer.output);
  json["page"] = has_page ? Json(places_.results_at + "files/" + page) : Json(nullptr);
  return json;
}

Json Session::compare(const Json& request) {
  const auto results = request.value("results", std::vector<std::string>());
  if (results.size() < 2) throw InputError("results: expected two or more");
  Command command = {.arguments = {"compare"}};
  for (const auto& result : results) {
    (void)folder_.file(result + "/study.json");
    command.arguments.push_back(result);
  }
  const auto place = previews_.next();
  command.hidden = {"--out", place.string()};
  auto answer = finished(comparisons_.run("", command));
  answer.output = replaced(std::move(answer.output), place.string(), "a preview");
  auto json = json_of(command, answer);
  json["pictures"] = pictures_below(place);
  return json;
}

Session::PlannedRun Session::planned_run(const Json& request) const {
  const auto deck = folder_.deck(required_text(request, "name"));
  const auto options = request.value("options", Json::object());
  const int seeds = options.value("seeds", 0);
  const auto stem = without_suffix(deck.name);
  const auto name = seeds > 0 ? fmt::format("{}-{}-seeds", stem, seeds) : stem;
  PlannedRun run = {.deck = deck.name};
  run.results =
      options.value("anew", false) ? new_directory_for(folder_, name) : directory_for(folder_, name, deck.text);
  run.command.arguments = {"run", deck.name};
  if (seeds > 0) add_option(run.command, "--seeds", std::to_string(seeds));
  if (run.results != "results/" + stem) add_option(run.command, "--out", run.results);
  run.command.arguments.emplace_back("--resume");
  return run;
}

Json Session::run_command(const Json& request) {
  return {{"command", shown(planned_run(request).command)}};
}

Json Session::start_run(const Json& request) {
  const auto run = planned_run(request);
  if (!run_.start(run.command, run.deck, run.results)) throw Conflict("a run is under way: wait for it, or stop it");
  return run_status();
}

Json Session::run_status() const {
  const auto run = run_.status();
  if (!run) return nullptr;
  auto json = json_of(*run);
  const auto page = (run->results / "report.html").generic_string();
  if (run->state == RunState::done && fs::exists(folder_.path() / page)) {
    json["report"] = places_.results_at + "files/" + page;
  }
  return json;
}

Json Session::stop_run() {
  run_.stop();
  return run_status();
}

std::vector<std::string> Session::pictures_below(const fs::path& place) const {
  std::vector<std::string> pictures;
  std::error_code failure;
  for (const auto& entry : fs::recursive_directory_iterator(place, failure)) {
    if (entry.path().extension() != ".svg") continue;
    pictures.push_back(places_.results_at + "preview/" +
                       entry.path().lexically_relative(previews_.path()).generic_string());
  }
  std::ranges::sort(pictures);
  return pictures;
}

fs::path Session::file(std::string_view path) const {
  constexpr std::string_view of_folder = "files/", of_previews = "preview/";
  if (path.starts_with(of_folder)) return folder_.file(path.substr(of_folder.size()));
  if (path.starts_with(of_previews)) return preview_files_.file(path.substr(of_previews.size()));
  throw InputError("no such address");
}

void Session::end() {
  for (auto* commands : {&checks_, &packings_, &fits_, &comparisons_}) commands->end();
  run_.stop();
}

}  // namespace breccia::studio
