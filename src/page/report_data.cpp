#include "page/report_data.hpp"

#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"

namespace breccia {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

PageData page_data(const std::filesystem::path& record, const std::function<TitledData()>& make) {
  try {
    const auto [title, data] = make();
    return {title, data.dump(-1, ' ', false, Json::error_handler_t::replace), data.contains("views")};
  } catch (const InputError& error) {
    // The table is a result of Breccia, so its mistakes are not those of a user.
    throw FileError(error.what());
  } catch (const Json::exception& error) {
    throw FileError(fmt::format("{}: not as `breccia run` writes it: {}", record.string(), error.what()));
  }
}

PageData read_page_data(const std::filesystem::path& record, const std::function<Json(Json)>& data_of) {
  auto json = Json::parse(read_text(record), nullptr, false);
  if (!json.is_object()) throw FileError(fmt::format("{}: not as `breccia run` writes it", record.string()));
  return page_data(record, [&]() -> TitledData {
    auto title = json.at("title").get<std::string>();
    return {std::move(title), data_of(std::move(json))};
  });
}

bool is_there(const std::filesystem::path& file) {
  std::error_code is_no_name_of_a_file;
  return std::filesystem::is_regular_file(file, is_no_name_of_a_file);
}

std::vector<double> rounded(std::vector<double> numbers) {
  for (auto& number : numbers) {
    if (number == 0.0 || !std::isfinite(number)) continue;
    const double unit = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(number))));
    // The factor overflows for very small (subnormal) numbers, which have fewer digits anyway.
    if (std::isfinite(unit)) number = std::round(number * unit) / unit;
  }
  return numbers;
}

}  // namespace breccia
