#include "tables/csv_records.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/trimmed.hpp"

namespace breccia::detail {

namespace {

/// Position of the double quote that closes the one at `opening`; npos if there is none.
std::size_t closing_quote(std::string_view text, std::size_t opening) {
  auto at = text.find('"', opening + 1);
  while (at != std::string_view::npos && text.substr(at).starts_with("\"\"")) at = text.find('"', at + 2);
  return at;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || std::isnan(number)) return std::nullopt;
  return number;
}

std::optional<CsvRecord> CsvRecords::next() {
  while (at_ < text_.size()) {
    const auto line = trimmed(text_.substr(at_, text_.find('\n', at_) - at_));
    if (!line.empty() && !line.starts_with('#')) break;
    skip_line();
  }
  if (at_ == text_.size()) return std::nullopt;
  CsvRecord record{line_, {}};
  record.fields.push_back(read_value());
  while (!is_at_end_of_line()) {
    ++at_;  // the separator
    record.fields.push_back(read_value());
  }
  skip_line();
  return record;
}

void CsvRecords::skip_line() {
  at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
  ++line_;
}

std::string CsvRecords::read_value() {
  const auto is_space = [&](char letter) { return (letter == ' ' || letter == '\t') && letter != separator_; };
  while (!is_at_end_of_line() && is_space(text_[at_])) ++at_;
  const bool has_quote = !is_at_end_of_line() && text_[at_] == '"';
  const auto closing = has_quote ? closing_quote(text_, at_) : std::string_view::npos;
  return closing == std::string_view::npos ? read_bare() : read_quoted(closing);
}

std::string CsvRecords::read_quoted(std::size_t closing) {
  std::string value;
  for (++at_; at_ < closing; ++at_) {
    if (text_[at_] == '"') ++at_;
    if (text_[at_] == '\n') ++line_;
    value += text_[at_];
  }
  ++at_;
  return value + read_bare();
}

std::string CsvRecords::read_bare() {
  const auto begin = at_;
  while (!is_at_end_of_line() && text_[at_] != separator_) ++at_;
  return std::string(trimmed(text_.substr(begin, at_ - begin)));
}

std::vector<CsvRecord> csv_records(std::string_view text, char separator) {
  std::vector<CsvRecord> all;
  CsvRecords records(text, separator);
  while (auto record = records.next()) all.push_back(*std::move(record));
  return all;
}

}  // namespace breccia::detail
