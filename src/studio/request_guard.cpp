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

}  // namespace

RequestGuard::RequestGuard(std::string token, int port) : token_(std::move(token)), port_(port) {}

std::optional<std::string> RequestGuard::admitted(const RequestLine& request) const {
  const auto is_here = [&](std::string_view host) {
    return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
  };
  constexpr std::string_view scheme = "http://";
  const std::string_view origin = request.origin;
  if (!is_here(request.host)) return std::nullopt;
  if (!origin.empty() && !(origin.starts_with(scheme) && is_here(origin.substr(scheme.size())))) return std::nullopt;
  const std::string_view path = request.path;
  const auto end = path.find('/', 1);
  if (!path.starts_with("/") || end == std::string_view::npos) return std::nullopt;
  if (!are_same(path.substr(1, end - 1), token_)) return std::nullopt;
  return std::string(path.substr(end + 1));
}

std::string RequestGuard::address() const {
  return fmt::format("http://127.0.0.1:{}/{}/", port_, token_);
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

}  // namespace breccia::studio
