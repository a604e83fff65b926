#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace breccia::cli {

/// What every subcommand that reads a deck takes.
struct DeckArguments {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
};

/// Adds DECK and --set to a subcommand. The arguments must live as long as the application.
void add_deck_arguments(CLI::App& command, DeckArguments& arguments);

/// The subcommands: each adds itself to the application, and does its work in a callback.
void add_check(CLI::App& application);

}  // namespace breccia::cli
