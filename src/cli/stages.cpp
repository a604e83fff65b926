#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "cli/command.hpp"
#include "deck/size_rows.hpp"
#include "deck/size_table.hpp"
#include "homogenisation/staging.hpp"
#include "io/percentage.hpp"
#include "io/units.hpp"

namespace breccia::cli {
namespace {

struct StagesArguments {
  std::filesystem::path sizes;
  std::string fraction;
  std::vector<std::string> cuts;
  std::string from, to;
};

/// Reads the values of options and collects all mistakes in them.
class OptionReader {
 public:
  double length(const std::string& option, const std::string& text) {
    try {
      return option_quantity(option, text, Dimension::length, Range::positive());
    } catch (const InputError& error) {
      mistakes_.emplace_back(error.what());
      return 0.0;
    }
  }

  double fraction(const std::string& option, const std::string& text) {
    auto share = parse_percentage(text);
    if (!share) {
      // A plain number, 0.94, is read as "0.94 %" and multiplied by 100.
      share = parse_percentage(text + "%");
      if (share) *share *= 100.0;
    }
    if (share && accepts(Range::between(0.0, 1.0), *share)) return *share;
    mistakes_.push_back(
        fmt::format(R"({}: expected a number between 0 and 1, or per cent as in "94 %", got "{}")", option, text));
    return 0.0;
  }

  /// Throws InputError with all mistakes, if there are any.
  void finish() const {
    if (!mistakes_.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes_, "\n")));
  }

 private:
  std::vector<std::string> mistakes_;
};

/// Throws InputError if the diameters at which stages begin and end do not rise.
void require_rising(const std::vector<double>& bounds, const StagesArguments& arguments) {
  if (std::ranges::is_sorted(bounds, std::ranges::less_equal())) return;
  throw InputError(fmt::format(R"(--at: expected rising diameters above {} and below {}, got "{}")",
                               readable(bounds.front(), Dimension::length), readable(bounds.back(), Dimension::length),
                               fmt::join(arguments.cuts, R"(" ")")));
}

void run_stages(const StagesArguments& arguments) {
  OptionReader options;
  const double fraction = options.fraction("--fraction", arguments.fraction);
  std::vector<double> bounds;
  for (const auto& cut : arguments.cuts) bounds.push_back(options.length("--at", cut));
  std::optional<double> from, to;
  if (!arguments.from.empty()) from = options.length("--from", arguments.from);
  if (!arguments.to.empty()) to = options.length("--to", arguments.to);
  options.finish();
  const auto table = with_known_ends(read_size_table(arguments.sizes), from, to);
  bounds.insert(bounds.begin(), from.value_or(table.diameters.front()));
  bounds.push_back(to.value_or(table.diameters.back()));
  require_rising(bounds, arguments);
  const auto sizes = SizeDistribution::tabulated(table.diameters, table.cumulative_volume_fractions);
  const auto stages = divide_into_stages(sizes, bounds, fraction);
  fmt::print("each stage is the matrix of the next\n");
  for (const auto& stage : stages) {
    fmt::print("  fraction = {:.4f}, from = \"{}\", to = \"{}\"    # {:.1f} % of the filler\n", stage.fraction,
               readable(stage.smallest, Dimension::length), readable(stage.largest, Dimension::length),
               100.0 * stage.share);
  }
}

}  // namespace

void add_stages(CLI::App& application) {
  auto* command =
      application.add_subcommand("stages", "divide a table of sizes into stages and print the fraction of each");
  auto arguments = std::make_shared<StagesArguments>();
  command->add_option("SIZES", arguments->sizes, "a table of sizes, as for `sizes` of a filler")
      ->required()
      ->type_name("");
  command
      ->add_option("--fraction", arguments->fraction,
                   R"(volume fraction of all filler in the whole, such as 0.94 or "94 %")")
      ->required()
      ->type_name("SHARE");
  command->add_option("--at", arguments->cuts, R"(diameters between the stages, such as "14 um" "100 um")")
      ->required()
      ->type_name("LENGTH");
  command->add_option("--from", arguments->from, "the smallest diameter (default: that of the table)")
      ->type_name("LENGTH");
  command->add_option("--to", arguments->to, "the largest diameter (default: that of the table)")->type_name("LENGTH");
  command->callback([arguments] { run_stages(*arguments); });
}

}  // namespace breccia::cli
