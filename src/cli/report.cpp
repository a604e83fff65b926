#include "page/report.hpp"

#include <memory>

#include <fmt/format.h>

#include "cli/command.hpp"

namespace breccia::cli {

void add_report(CLI::App& application) {
  auto* command = application.add_subcommand(
      "report", "write report.html, a page for the browser, anew from the results of a run or a sweep");
  auto results = std::make_shared<std::filesystem::path>();
  command->add_option("DIR", *results, "the results of `breccia run`")->required()->type_name("");
  command->callback([results] {
    write_report(*results);
    fmt::print("{}\n", (*results / "report.html").string());
  });
}

}  // namespace breccia::cli
