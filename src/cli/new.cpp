#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "cli/command.hpp"
#include "cli/help.hpp"
#include "cli/starter_deck.hpp"
#include "io/text_file.hpp"

namespace breccia::cli {
namespace {

void write_starter_deck(const std::filesystem::path& deck) {
  const auto name = deck.string();
  if (deck.extension() != ".toml") throw InputError(fmt::format("{}: expected a name that ends in .toml", name));
  if (std::filesystem::exists(std::filesystem::symlink_status(deck))) {
    throw InputError(fmt::format("{}: the file exists and is not overwritten; choose another name", name));
  }
  write_text(deck, starter_deck());
  fmt::print("{} is a deck to begin with. Next:\n  breccia check {}\n  breccia run {}\n", name, name, name);
}

}  // namespace

void add_new(CLI::App& application) {
  auto* command = application.add_subcommand("new", "write a deck to begin with, in which every line is explained");
  command->footer(where_to_begin());
  auto deck = std::make_shared<std::filesystem::path>();
  command->add_option("NAME.toml", *deck, "the new deck; an existing file is not overwritten")
      ->required()
      ->type_name("");
  command->callback([deck] { write_starter_deck(*deck); });
}

}  // namespace breccia::cli
