#include "deck/sweep_names.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace breccia {

namespace {

/// The text with dashes in place of all characters that file names cannot have on all operating systems.
std::string safe(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const bool is_sign = letter == '.' || letter == '-' || letter == '_';
    const bool is_allowed = is_sign || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    const bool is_repeated = !is_allowed && result.ends_with('-');
    if (!is_repeated) result += is_allowed ? letter : '-';
  }
  return result;
}

/// The text of a value, with a minus sign as the word "minus" ("minus 40 degC"), since dashes join words in names.
std::string with_sign_in_words(const std::string& text) {
  const bool is_negative =
      text.size() > 1 && text[0] == '-' && (std::isdigit(static_cast<unsigned char>(text[1])) != 0 || text[1] == '.');
  return is_negative ? "minus " + text.substr(1) : text;
}

/// The last steps of a path.
std::string ending(const std::vector<std::string>& steps, std::size_t length) {
  std::string result;
  for (std::size_t i = steps.size() - std::min(length, steps.size()); i < steps.size(); ++i) {
    if (!result.empty()) result += '-';
    result += steps[i] == "*" ? "all" : safe(steps[i]);
  }
  return result;
}

/// Whether a step has no meaning by itself: "*", or the index of an element.
bool is_element(const std::string& step) {
  return step == "*" || step.find_first_not_of("0123456789") == std::string::npos;
}

/// The name of a file without directory and extension, "binder" for "../data/binder.csv"; other values unchanged.
std::string without_directory(const std::string& text) {
  const std::filesystem::path path(text);
  return path.has_extension() && path.has_parent_path() ? path.stem().string() : text;
}

bool are_good(const std::vector<std::string>& labels) {
  constexpr std::size_t longest = 40;
  const std::set<std::string> different(labels.begin(), labels.end());
  return different.size() == labels.size() &&
         std::ranges::all_of(labels, [](const auto& label) { return !label.empty() && label.size() <= longest; });
}

}  // namespace

std::vector<std::string> labels_of_keys(const std::vector<std::string>& paths) {
  std::vector<std::vector<std::string>> all_steps;
  all_steps.reserve(paths.size());
  for (const auto& path : paths) all_steps.push_back(split_path(path).value_or(std::vector{path}));
  std::vector<std::string> labels;
  for (const auto& steps : all_steps) {
    const auto is_shared = [&](std::size_t length) {
      return std::ranges::count(all_steps, ending(steps, length),
                                [&](const auto& others) { return ending(others, length); }) > 1;
    };
    std::size_t length = is_element(steps.back()) ? 2 : 1;
    while (length < steps.size() && is_shared(length)) ++length;
    labels.push_back(ending(steps, length));
  }
  return labels;
}

std::vector<std::string> labels_of_values(const std::vector<Scalar>& values) {
  std::vector<std::string> short_labels, full_labels, numbers;
  for (const auto& value : values) {
    const auto text = with_sign_in_words(plain_text(value));
    short_labels.push_back(safe(without_directory(text)));
    full_labels.push_back(safe(text));
    numbers.push_back(std::to_string(numbers.size() + 1));
  }
  if (are_good(short_labels)) return short_labels;
  return are_good(full_labels) ? full_labels : numbers;
}

}  // namespace breccia
