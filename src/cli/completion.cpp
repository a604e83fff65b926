#include <memory>
#include <string>

#include <fmt/format.h>

#include "cli/bash_completion.hpp"
#include "cli/command.hpp"
#include "cli/zsh_completion.hpp"

namespace breccia::cli {

void add_completion(CLI::App& application) {
  auto* command = application.add_subcommand(
      "completion", "print the script by which a shell completes the commands, options and files of breccia");
  command->footer(
      "For this session of bash: source <(breccia completion bash); of zsh: source <(breccia completion zsh), after "
      "compinit. An installed breccia has these scripts where the shells look for them.");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "the shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}).description(""))
      ->type_name("bash|zsh");
  command->callback([&application, shell] {
    fmt::print("{}", *shell == "bash" ? bash_completion(application) : zsh_completion(application));
  });
}

}  // namespace breccia::cli
