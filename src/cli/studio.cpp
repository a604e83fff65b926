#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "cli/browser.hpp"
#include "cli/command.hpp"
#include "cli/installation.hpp"
#include "cli/interruption.hpp"
#include "studio/private_directory.hpp"
#include "studio/studio_server.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  fs::path deck;
  int port = 0;
  bool stays_closed = false;
};

/// Where the studio works: in the folder that was given, or that of the deck, or here.
studio::Places places_for(const fs::path& deck) {
  studio::Places places = {.program = program_path(), .examples = installed_examples(), .folder = fs::current_path()};
  if (deck.empty()) return places;
  if (fs::is_directory(deck)) {
    places.folder = deck;
    return places;
  }
  if (!fs::is_regular_file(deck) || deck.extension() != ".toml") {
    throw InputError(fmt::format("{}: expected a deck, NAME.toml, or a folder", deck.string()));
  }
  places.folder = fs::absolute(deck).parent_path();
  places.opened = deck.filename().string();
  return places;
}

void open_studio(const Arguments& arguments) {
  // The end of a command is waited for, whatever the program that has started this one does.
  (void)std::signal(SIGCHLD, SIG_DFL);
  const auto tokens = studio::random_tokens();
  auto places = places_for(arguments.deck);
  places.results_at = fmt::format("../{}/", tokens.results);
  studio::Session session(places);
  const studio::PrivateDirectory directory;
  watch_for_interruption();
  const auto greet = [&](const std::string& address) {
    fmt::print(
        "Breccia studio: {}\nThe address is for you alone: whoever knows it can use the studio. Ctrl-C ends it.\n",
        address);
    std::fflush(stdout);
    if (!arguments.stays_closed) show_in_browser(address, directory.path());
  };
  studio::serve(session, {.port = arguments.port, .tokens = tokens}, greet, interruption_requested);
}

}  // namespace

void add_studio(CLI::App& application) {
  auto* command = application.add_subcommand(
      "studio", "open a page in the browser on which decks are made, run and compared without typing them");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("DECK", arguments->deck, "the deck to begin with, or a folder of decks (default: this folder)")
      ->type_name("");
  command->add_option("--port", arguments->port, "port of this machine (default: any free one)")
      ->check(CLI::Range(1, 65535).description(""))
      ->type_name("N");
  command->add_flag("--no-browser", arguments->stays_closed, "print the address, and open no browser");
  command->callback([arguments] { open_studio(*arguments); });
}

}  // namespace breccia::cli
