#include "report_data.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"

namespace breccia {

using Json = nlohmann::ordered_json;

void write_page(const std::filesystem::path& directory, const std::string& record,
                const std::function<std::string(std::string_view title, std::string_view data)>& page,
                const std::function<Json(Json)>& data_of) {
  const auto file = directory / record;
  auto json = Json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) throw FileError(fmt::format("{}: not as `breccia run` writes it", file.string()));
  std::string title;
  Json data;
  try {
    title = json.at("title").get<std::string>();
    data = data_of(std::move(json));
  } catch (const Json::exception& error) {
    throw FileError(fmt::format("{}: not as `breccia run` writes it: {}", file.string(), error.what()));
  }
  write_text(directory / "report.html", page(title, data.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

std::vector<double> rounded(std::vector<double> numbers) {
  for (auto& number : numbers) {
    if (number == 0.0 || !std::isfinite(number)) continue;
    const double unit = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(number))));
    // Where the unit is no finite number, the number has fewer digits than that.
    if (std::isfinite(unit)) number = std::round(number * unit) / unit;
  }
  return numbers;
}

}  // namespace breccia
