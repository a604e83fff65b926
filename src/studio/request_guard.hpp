#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breccia::studio {

/// What a request says of where it comes from and what it asks for.
struct RequestLine {
  std::string method = {};      ///< "GET", "POST"
  std::string path = {};        ///< "/TOKEN/api/state"
  std::string host = {};        ///< header `Host`
  std::string origin = {};      ///< header `Origin`; empty without one
  std::string fetch_site = {};  ///< header `Sec-Fetch-Site`; empty without one
  std::string fetch_mode = {};  ///< header `Sec-Fetch-Mode`; empty without one
};

/// The secrets of a session, of which the addresses have one each.
struct Tokens {
  std::string page = {};  ///< of the page, which may do everything
  /// Of results that are shown in a frame or a tab of their own. Their scripts can read their own address, so that it
  /// lets them read files, and no more.
  std::string results = {};
};

/// Decides which requests the studio answers: those that know its token, a secret of this session in the address. So
/// neither another user of the machine nor a page of another origin in the same browser can use it: the one cannot know
/// the token, the other is refused by its origin or, where it has made its name lead to this machine (DNS rebinding),
/// by the name of the host.
class RequestGuard {
 public:
  /// For a server at this port of 127.0.0.1.
  RequestGuard(Tokens tokens, int port);

  /// The path below the token, "api/state" or "" for the page itself; nothing for a request that is refused.
  [[nodiscard]] std::optional<std::string> admitted(const RequestLine& request) const;
  /// The address of the page.
  [[nodiscard]] std::string address() const;

 private:
  Tokens tokens_;
  int port_;
};

/// Tokens of 256 random bits each from the system, as 64 hexadecimal digits. Throws FileError if it has none.
Tokens random_tokens();

}  // namespace breccia::studio
