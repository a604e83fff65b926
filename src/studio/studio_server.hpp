#pragma once

#include <functional>
#include <string>

#include "studio/request_guard.hpp"
#include "studio/session.hpp"

namespace breccia::studio {

/// How the studio is reached.
struct ServerOptions {
  int port = 0;  ///< 0: any free one
  Tokens tokens = {};
};

/// Serves the page of the studio to the browsers of this machine that know its address, until `is_to_stop` returns
/// true, which is asked a few times a second. `greet` is called with the address once it is served. Throws InputError
/// if the port is not free.
void serve(Session& session, const ServerOptions& options, const std::function<void(const std::string&)>& greet,
           const std::function<bool()>& is_to_stop);

}  // namespace breccia::studio
