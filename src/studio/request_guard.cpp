#include "studio/request_guard.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <sys/random.h>

#include "breccia/error.hpp"

namespace breccia::studio {
namespace {

/// Whether two texts are the same, in a time that does not depend on where they differ.
bool are_same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  int difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= a[i] ^ b[i];
  return difference == 0;
}

/// Whether an address below a token is that of a file, which results may be shown from.
bool is_file(std::string_view path) {
  return path.starts_with("files/") || path.starts_with("preview/");
}

std::string random_token() {
  constexpr std::size_t count = 32;
  std::array<unsigned char, count> bytes = {};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw FileError("the system has no random numbers for the token of the studio");
  }
  std::string token;
  for (const unsigned byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

}  // namespace

RequestGuard::RequestGuard(Tokens tokens, int port) : tokens_(std::move(tokens)), port_(port) {}

std::optional<std::string> RequestGuard::admitted(const RequestLine& request) const {
  const auto is_here = [&](std::string_view host) {
    return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
  };
  constexpr std::string_view scheme = "http://";
  const std::string_view origin = request.origin;
  if (!is_here(request.host)) return std::nullopt;
  if (!origin.empty() && !(origin.starts_with(scheme) && is_here(origin.substr(scheme.size())))) return std::nullopt;
  // A page of another site may follow a link, which shows what the user could see anyway.
  if (request.fetch_site == "cross-site" && request.fetch_mode != "navigate") return std::nullopt;
  const std::string_view path = request.path;
  const auto end = path.find('/', 1);
  if (!path.starts_with("/") || end == std::string_view::npos) return std::nullopt;
  const auto token = path.substr(1, end - 1);
  const auto rest = path.substr(end + 1);
  const bool reads_results = request.method == "GET" && is_file(rest) && are_same(token, tokens_.results);
  if (!are_same(token, tokens_.page) && !reads_results) return std::nullopt;
  return std::string(rest);
}

std::string RequestGuard::address() const {
  return fmt::format("http://127.0.0.1:{}/{}/", port_, tokens_.page);
}

Tokens random_tokens() {
  return {.page = random_token(), .results = random_token()};
}

}  // namespace breccia::studio
