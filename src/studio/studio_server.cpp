#include "studio/studio_server.hpp"

#include <chrono>
#include <cstddef>
#include <exception>
#include <map>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <httplib.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "studio/deck_changes.hpp"
#include "studio/request_guard.hpp"
#include "studio/studio_page.hpp"

namespace breccia::studio {
namespace {

constexpr int bad_request = 400, forbidden = 403, not_found = 404, conflict = 409, internal_failure = 500;
constexpr std::size_t largest_upload = 64U << 20U;  ///< [B]

/// What the page itself may load: its own files, nothing of other origins, no scripts within its text.
constexpr auto policy_of_page =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
/// Results are pages and pictures with scripts and texts of decks: they get an origin of their own, and load nothing.
constexpr auto policy_of_results =
    "sandbox allow-scripts allow-downloads allow-popups; default-src 'none'; script-src 'unsafe-inline'; style-src "
    "'unsafe-inline'; img-src data: blob:; font-src data:; form-action 'none'; base-uri 'none'";

const char* type_of(const std::filesystem::path& file) {
  static const std::map<std::string, const char*, std::less<>> types = {{".html", "text/html; charset=utf-8"},
                                                                        {".svg", "image/svg+xml"},
                                                                        {".png", "image/png"},
                                                                        {".csv", "text/plain; charset=utf-8"},
                                                                        {".txt", "text/plain; charset=utf-8"},
                                                                        {".toml", "text/plain; charset=utf-8"},
                                                                        {".json", "application/json"}};
  const auto type = types.find(file.extension().string());
  return type == types.end() ? "application/octet-stream" : type->second;
}

void send(httplib::Response& response, std::string_view text, const char* type) {
  response.set_content(text.data(), text.size(), type);
}

void send_page(httplib::Response& response, std::string_view text, const char* type) {
  response.set_header("Content-Security-Policy", policy_of_page);
  send(response, text, type);
}

void send_json(httplib::Response& response, const Json& json) {
  // Bytes of decks and of terminals that are not UTF-8 become question marks.
  send(response, json.dump(-1, ' ', false, Json::error_handler_t::replace), "application/json");
}

void send_file(httplib::Response& response, const std::filesystem::path& file) {
  response.set_header("Content-Security-Policy", policy_of_results);
  send(response, read_text(file), type_of(file));
}

Json body_of(const httplib::Request& request) {
  auto body = Json::parse(request.body, nullptr, false);
  if (!body.is_object()) throw InputError("expected a JSON object");
  return body;
}

std::string parameter(const httplib::Request& request, const char* name) {
  if (!request.has_param(name)) throw InputError(fmt::format("{}: missing", name));
  return request.get_param_value(name);
}

/// Answers a request for an address below the token; returns false if there is no such address.
class Answers {
 public:
  explicit Answers(Session& session) : session_(session) {}

  bool get(const std::string& path, const httplib::Request& request, httplib::Response& response) const {
    if (path.empty()) {
      send_page(response, page_document(), "text/html; charset=utf-8");
    } else if (path == "studio.js") {
      send_page(response, page_script(), "text/javascript; charset=utf-8");
    } else if (path == "studio.css") {
      send_page(response, page_style(), "text/css; charset=utf-8");
    } else if (path == "decks.md") {
      send_page(response, key_reference(), "text/plain; charset=utf-8");
    } else if (path == "api/state") {
      send_json(response, session_.state());
    } else if (path == "api/job") {
      send_json(response, session_.run_status());
    } else if (path == "api/deck") {
      send_json(response, session_.deck(parameter(request, "name")));
    } else if (path.starts_with("files/") || path.starts_with("preview/")) {
      send_file(response, session_.file(path));
    } else {
      return false;
    }
    return true;
  }

  bool post(const std::string& path, const httplib::Request& request, httplib::Response& response) const {
    using Action = Json (Session::*)(const Json&);
    static const std::map<std::string, Action, std::less<>> actions = {
        {"api/new", &Session::add_deck},    {"api/deck", &Session::save_deck},
        {"api/check", &Session::check},     {"api/pack", &Session::pack},
        {"api/fit", &Session::fit},         {"api/run", &Session::start_run},
        {"api/compare", &Session::compare}, {"api/run-command", &Session::run_command}};
    if (const auto action = actions.find(path); action != actions.end()) {
      send_json(response, (session_.*action->second)(body_of(request)));
    } else if (path == "api/edit") {
      send_json(response, edited_deck(body_of(request)));
    } else if (path == "api/stop") {
      send_json(response, session_.stop_run());
    } else if (path == "api/upload") {
      send_json(response, session_.upload(parameter(request, "name"), request.body));
    } else {
      return false;
    }
    return true;
  }

 private:
  Session& session_;
};

void send_error(httplib::Response& response, int status, const std::string& message) {
  response.status = status;
  send_json(response, {{"error", message}});
}

/// Calls an action; what it throws becomes the answer.
template <class Action>
void answer(httplib::Response& response, const Action& action) {
  try {
    action();
  } catch (const ChangedDeck& error) {
    response.status = conflict;
    send_json(response, {{"error", error.what()}, {"version", error.version()}});
  } catch (const Conflict& error) {
    send_error(response, conflict, error.what());
  } catch (const InputError& error) {
    send_error(response, bad_request, error.what());
  } catch (const nlohmann::json::exception&) {
    send_error(response, bad_request, "the request is not as docs/studio.md has it");
  } catch (const std::exception& error) {
    send_error(response, internal_failure, error.what());
  }
}

/// Answers all requests that the guard admits, and refuses the others.
void answer_requests(httplib::Server& server, const Answers& answers, const RequestGuard& guard) {
  server.set_default_headers({{"Referrer-Policy", "no-referrer"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Cache-Control", "no-store"},
                              {"Cross-Origin-Resource-Policy", "same-origin"}});
  server.set_pre_routing_handler([&](const httplib::Request& request, httplib::Response& response) {
    const auto header = [&](const char* name) { return request.get_header_value(name); };
    const auto path = guard.admitted({request.method, request.path, header("Host"), header("Origin"),
                                      header("Sec-Fetch-Site"), header("Sec-Fetch-Mode")});
    if (path && request.ranges.empty()) return httplib::Server::HandlerResponse::Unhandled;
    if (path) {
      send_error(response, bad_request, "parts of files are not served");
    } else {
      send_error(response, forbidden, "not the address that `breccia studio` has printed");
    }
    return httplib::Server::HandlerResponse::Handled;
  });
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.body.empty()) send_error(response, response.status, "the request is too large, or none of HTTP");
  });
  const auto below_token = [](const httplib::Request& request) {
    return request.path.substr(request.path.find('/', 1) + 1);
  };
  const auto refuse_unknown = [](httplib::Response& response, bool is_known) {
    if (!is_known) send_error(response, not_found, "no such address");
  };
  server.Get("/.*", [=](const httplib::Request& request, httplib::Response& response) {
    answer(response, [&] { refuse_unknown(response, answers.get(below_token(request), request, response)); });
  });
  server.Post("/.*", [=](const httplib::Request& request, httplib::Response& response) {
    answer(response, [&] { refuse_unknown(response, answers.post(below_token(request), request, response)); });
  });
}

/// Limits what a connection can do. One request each: the body of a request that is refused is not read, and would be
/// taken for the next request. Threads for many, so that slow ones do not keep the others waiting.
void limit_connections(httplib::Server& server) {
  constexpr std::size_t threads = 64;
  constexpr std::chrono::seconds patience(3);
  server.set_keep_alive_max_count(1);
  server.set_read_timeout(patience);
  server.set_payload_max_length(largest_upload);
  server.new_task_queue = [] { return new httplib::ThreadPool(threads); };  // which the server deletes
}

/// Binds the server to a port of this machine alone, and returns the port.
int bound_port(httplib::Server& server, const ServerOptions& options) {
  constexpr auto this_machine = "127.0.0.1";
  // The option that is set by default lets a second server take the same port.
  server.set_socket_options([](socket_t socket) {
    int yes = 1;
    (void)::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  if (options.port == 0) return server.bind_to_any_port(this_machine);
  if (server.bind_to_port(this_machine, options.port)) return options.port;
  throw InputError(fmt::format("--port: {} is in use, or not open to this user; without the option a free one is taken",
                               options.port));
}

}  // namespace

void serve(Session& session, const ServerOptions& options, const std::function<void(const std::string&)>& greet,
           const std::function<bool()>& is_to_stop) {
  httplib::Server server;
  const int port = bound_port(server, options);
  const RequestGuard guard(options.tokens, port);
  limit_connections(server);
  answer_requests(server, Answers(session), guard);
  const std::jthread watcher([&](const std::stop_token& stop) {
    constexpr std::chrono::milliseconds pause(100);
    while (!stop.stop_requested() && !is_to_stop()) std::this_thread::sleep_for(pause);
    session.end();
    server.stop();
  });
  greet(guard.address());
  if (!server.listen_after_bind() && !is_to_stop()) throw FileError("the studio cannot listen to its port");
}

}  // namespace breccia::studio
