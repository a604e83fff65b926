#include "command.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <sys/wait.h>

namespace breccia::test {

namespace {

/// An argument in single quotes for the shell.
std::string quoted(const std::string& argument) {
  std::string text(1, '\'');
  for (const char letter : argument) {
    if (letter == '\'') text += "'\\'";
    text += letter;
  }
  text += '\'';
  return text;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Outcome run_breccia(const std::filesystem::path& directory, const std::vector<std::string>& arguments) {
  const auto output = directory / "stdout";
  const auto errors = directory / "stderr";
  auto command = fmt::format("cd {} && {}", quoted(directory.string()), quoted(BRECCIA_COMMAND));
  for (const auto& argument : arguments) command += fmt::format(" {}", quoted(argument));
  command += fmt::format(" > {} 2> {}", quoted(output.string()), quoted(errors.string()));
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): the arguments are the test's own
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(output), content(errors)};
}

}  // namespace breccia::test
