#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include "breccia/error.hpp"

#include "cli/model_deck.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "studio/studio_server.hpp"
#include "temporary_directory.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

/// The model composite under a title that a page must not run.
const std::string deck = test::replaced(std::string(test::model_deck), "Model composite", "<script>alert(1)</script>");

/// A studio in a folder of its own, and a browser in front of it.
class Studio : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    write_text(temporary_.path() / "outside.csv", "outside");
    write_text(folder_ / "a.toml", deck);
    session_ = std::make_unique<Session>(Places{.program = BRECCIA_COMMAND,
                                                .examples = BRECCIA_EXAMPLES_DIRECTORY,
                                                .folder = folder_,
                                                .results_at = fmt::format("../{}/", tokens_.results)});
    std::promise<std::string> address;
    server_ = std::jthread([this, &address] {
      serve(
          *session_, {.tokens = tokens_}, [&](const std::string& it) { address.set_value(it); },
          [this] { return is_to_stop_.load(); });
    });
    const auto whole = address.get_future().get();
    const auto slash = whole.find('/', whole.find("//") + 2);
    base_ = whole.substr(slash);
    port_ = std::stoi(whole.substr(whole.rfind(':', slash) + 1));
    browser_ = std::make_unique<httplib::Client>("127.0.0.1", port_);
    browser_->set_read_timeout(std::chrono::minutes(10));
  }
  void TearDown() override {
    is_to_stop_ = true;
    server_.join();
  }

  /// Gets an address relative to the page, which may be one of another token.
  httplib::Result get(const std::string& path, const httplib::Headers& headers = {}) {
    const bool is_of_results = path.starts_with("../");
    return browser_->Get((is_of_results ? path.substr(2) : base_ + path).c_str(), headers);
  }
  httplib::Result post(const std::string& path, const std::string& body, const httplib::Headers& headers = {}) {
    return browser_->Post((base_ + path).c_str(), headers, body, "application/json");
  }
  /// The answer of a request that is met.
  Json answer(const std::string& path, const Json& request) {
    const auto result = post(path, request.dump());
    EXPECT_EQ(result->status, 200) << result->body;
    return Json::parse(result->body);
  }

  Tokens tokens_ = random_tokens();
  test::TemporaryDirectory temporary_;
  fs::path folder_ = temporary_.path() / "work";
  std::unique_ptr<Session> session_;
  std::atomic<bool> is_to_stop_ = false;
  std::string base_;  ///< "/TOKEN/"
  int port_ = 0;
  std::unique_ptr<httplib::Client> browser_;
  std::jthread server_;
};

TEST_F(Studio, ServesThePageThatLoadsNothingElse) {
  const auto page = get("");
  ASSERT_EQ(page->status, 200);
  EXPECT_NE(page->body.find("studio.js"), std::string::npos);
  const auto policy = page->get_header_value("Content-Security-Policy");
  EXPECT_NE(policy.find("default-src 'none'; script-src 'self';"), std::string::npos);
  EXPECT_EQ(policy.find("unsafe"), std::string::npos);
  EXPECT_EQ(page->get_header_value("Referrer-Policy"), "no-referrer");
  EXPECT_EQ(page->body.find("http://"), std::string::npos);
  EXPECT_EQ(page->body.find("https://"), std::string::npos);
  for (const auto* file : {"studio.js", "studio.css", "decks.md"}) EXPECT_EQ(get(file)->status, 200) << file;
  EXPECT_EQ(get("no.js")->status, 404);
}

TEST_F(Studio, RefusesWhoDoesNotKnowTheAddress) {
  for (const auto* path : {"/", "/api/state", "/0000/api/state", "/files/a.toml"}) {
    EXPECT_EQ(browser_->Get(path)->status, 403) << path;
    EXPECT_EQ(browser_->Post(path, "{}", "application/json")->status, 403) << path;
  }
  const httplib::Headers foreign = {{"Origin", "http://example.org"}}, opaque = {{"Origin", "null"}};
  EXPECT_EQ(get("api/state", foreign)->status, 403);
  EXPECT_EQ(get("api/state", opaque)->status, 403);
  EXPECT_EQ(post("api/run", R"({"name": "a.toml"})", opaque)->status, 403);
  EXPECT_EQ(get("api/state", {{"Host", "example.org"}})->status, 403);
  EXPECT_EQ(get("api/state", {{"Origin", fmt::format("http://127.0.0.1:{}", port_)}})->status, 200);
  EXPECT_TRUE(session_->run_status().is_null());
}

TEST_F(Studio, TakesNoRequestFromTheBodyOfOneThatItRefuses) {
  const auto hidden = fmt::format(
      "POST {}api/upload?name=smuggled.csv HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n"
      "Content-Length: 1\r\n\r\nx",
      base_, port_);
  browser_->set_keep_alive(true);
  for (const auto* path : {"/", "/wrong/api/upload?name=a.csv"}) {
    const auto result = browser_->Post(path, hidden, "text/plain");
    EXPECT_TRUE(!result || result->status == 403) << path;
  }
  EXPECT_EQ(get("api/state")->status, 200);
  EXPECT_FALSE(fs::exists(folder_ / "smuggled.csv"));
}

TEST_F(Studio, ShowsResultsBelowATokenThatOnlyReadsThem) {
  const auto shown = fmt::format("/{}/", tokens_.results);
  EXPECT_EQ(browser_->Get((shown + "files/a.toml").c_str())->status, 200);
  for (const auto* path : {"", "api/state", "api/deck?name=a.toml", "studio.js"}) {
    EXPECT_EQ(browser_->Get((shown + path).c_str())->status, 403) << path;
  }
  EXPECT_EQ(browser_->Post((shown + "api/run").c_str(), R"({"name": "a.toml"})", "application/json")->status, 403);
  EXPECT_EQ(get("files/a.toml", {{"Range", "bytes=0-3"}})->status, 400);
}

TEST_F(Studio, ListensToThisMachineAlone) {
  httplib::Client elsewhere("127.0.0.2", port_);  // another address of this machine
  EXPECT_FALSE(elsewhere.Get((base_ + "api/state").c_str()));
  EXPECT_THROW(serve(
                   *session_, {.port = port_, .tokens = tokens_}, [](const std::string&) {}, [] { return true; }),
               InputError);
}

TEST_F(Studio, HasNoFileOutsideTheFolder) {
  EXPECT_EQ(get("files/a.toml")->body, deck);
  EXPECT_NE(get("files/a.toml")->get_header_value("Content-Security-Policy").find("sandbox"), std::string::npos);
  for (const auto* path :
       {"files/../outside.csv", "files/%2e%2e/outside.csv", "files/..%2foutside.csv", "files//etc/passwd",
        "files/%2fetc%2fpasswd", "files/", "preview/../x", "preview/1/../../x", "files/a.toml%00.csv"}) {
    const auto result = get(path);
    EXPECT_NE(result->status, 200) << path;
    EXPECT_NE(result->body, "outside") << path;
  }
  for (const auto* name : {"../outside.csv", ".hidden.csv", "x.toml", ""}) {
    EXPECT_EQ(post(std::string("api/upload?name=") + name, "1")->status, 400) << name;
  }
  EXPECT_EQ(post("api/check", R"({"name": "../outside.csv"})")->status, 400);
  EXPECT_EQ(post("api/fit", R"({"file": "../outside.csv"})")->status, 400);
  EXPECT_EQ(post("api/compare", R"({"results": ["--help", "results/a"]})")->status, 400);
  EXPECT_EQ(read_text(temporary_.path() / "outside.csv"), "outside");
}

TEST_F(Studio, AnswersRequestsThatAreNone) {
  for (const auto* body : {"", "[]", "{", "null", "1", R"({"name": 1})", R"({"name": null})", "{}"}) {
    for (const auto* path :
         {"api/check", "api/pack", "api/fit", "api/run", "api/new", "api/deck", "api/edit", "api/compare"}) {
      EXPECT_EQ(post(path, body)->status, 400) << path << " " << body;
    }
  }
  EXPECT_EQ(post("api/run", R"({"name": "a.toml", "options": {"seeds": "many"}})")->status, 400);
  EXPECT_EQ(post("api/fit", R"({"file": "a.toml", "options": 1})")->status, 400);
  EXPECT_EQ(get("api/deck")->status, 400);
  EXPECT_EQ(get("api/deck?name=b.toml")->status, 400);
  EXPECT_EQ(post("api/no", "{}")->status, 404);
}

TEST_F(Studio, MakesADeckChecksAndRunsIt) {
  const auto before = Json::parse(get("api/state")->body);
  EXPECT_EQ(before["decks"][0]["title"], "<script>alert(1)</script>");
  EXPECT_EQ(before["job"], nullptr);
  EXPECT_GT(before["examples"].size(), 20U);

  auto deck_now = Json::parse(get("api/deck?name=a.toml")->body);
  const auto edited = answer("api/edit", {{"text", deck_now["text"]},
                                          {"name", "a.toml"},
                                          {"changes", {{{"path", {"stages", 0, "box"}}, {"value", "\"6.2 mm\""}}}}});
  EXPECT_EQ(edited["command"], "breccia run a.toml --set 'stages.A.box=\"6.2 mm\"'");
  EXPECT_NE(edited["text"].get<std::string>().find("box     = \"6.2 mm\"\n"), std::string::npos);
  deck_now["text"] = edited["text"];
  const auto saved = answer("api/deck", deck_now);
  EXPECT_EQ(read_text(folder_ / "a.toml"), edited["text"].get<std::string>());
  EXPECT_EQ(post("api/deck", deck_now.dump())->status, 200);  // the same text is no conflict
  deck_now["text"] = "title = 1";
  const auto refused = post("api/deck", deck_now.dump());
  EXPECT_EQ(refused->status, 409);
  EXPECT_EQ(Json::parse(refused->body)["version"], saved["version"]);
  EXPECT_NE(saved["version"], deck_now["version"]);

  const auto checked = answer("api/check", {{"name", "a.toml"}});
  EXPECT_EQ(checked["command"], "breccia check a.toml");
  EXPECT_EQ(checked["exit"], 0) << checked;
  const auto packed = answer("api/pack", {{"name", "a.toml"}});
  ASSERT_EQ(packed["stages"].size(), 1U) << packed;
  EXPECT_EQ(packed["stages"][0]["name"], "A");
  const auto picture = get(packed["stages"][0]["picture"].get<std::string>());  // "../TOKEN/preview/..."
  EXPECT_EQ(picture->status, 200);
  EXPECT_EQ(picture->get_header_value("Content-Type"), "image/svg+xml");
  EXPECT_FALSE(fs::exists(folder_ / "results"));

  EXPECT_EQ(answer("api/run-command", {{"name", "a.toml"}, {"options", {{"seeds", 3}}}})["command"],
            "breccia run a.toml --seeds 3 --out results/a-3-seeds --resume");
  EXPECT_TRUE(session_->run_status().is_null());
  EXPECT_EQ(answer("api/run", {{"name", "a.toml"}})["command"], "breccia run a.toml --resume");
  Json run;
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    run = Json::parse(get("api/job")->body);
  } while (run["state"] == "running");
  EXPECT_EQ(run["state"], "done") << run;
  const auto page = get(run["report"].get<std::string>());
  EXPECT_EQ(page->status, 200);
  const auto policy = page->get_header_value("Content-Security-Policy");
  EXPECT_TRUE(policy.starts_with("sandbox allow-scripts allow-downloads allow-popups; default-src 'none';")) << policy;
  const auto after = Json::parse(get("api/state")->body);
  ASSERT_EQ(after["results"].size(), 1U);
  EXPECT_EQ(after["results"][0]["path"], "results/a");
  EXPECT_EQ(after["results"][0]["complete"], true);
  EXPECT_EQ(after["results"][0]["command"], "xdg-open results/a/report.html");
}

TEST_F(Studio, ShowsMistakesWithTheirLines) {
  write_text(folder_ / "bad.toml", "title = \"x\"\nfoo = 1\n");
  const auto checked = answer("api/check", {{"name", "bad.toml"}});
  EXPECT_EQ(checked["exit"], 2);
  ASSERT_GE(checked["mistakes"].size(), 2U);
  EXPECT_EQ(checked["mistakes"].back()["line"], 2);
  write_text(folder_ / "torn.toml", "title = \n");
  const auto torn = Json::parse(get("api/deck?name=torn.toml")->body);
  EXPECT_EQ(torn["tree"], nullptr);
  EXPECT_EQ(torn["mistakes"][0]["line"], 1);
}

TEST_F(Studio, FitsMeasuredData) {
  const auto data = read_text(fs::path(BRECCIA_EXAMPLES_DIRECTORY) / ".." / "data" / "synthetic_dma.csv");
  EXPECT_EQ(post("api/upload?name=dma%201.csv", data)->status, 200);
  EXPECT_EQ(read_text(folder_ / "dma 1.csv"), data);
  EXPECT_EQ(post("api/upload?name=dma%201.csv", "other")->status, 409);
  const auto fitted = answer("api/fit", {{"file", "dma 1.csv"}, {"options", {{"reference_temperature", "19 degC"}}}});
  EXPECT_EQ(fitted["command"], "breccia fit 'dma 1.csv' --reference-temperature '19 degC' --overwrite");
  EXPECT_EQ(fitted["exit"], 0) << fitted;
  EXPECT_EQ(get(fitted["page"].get<std::string>())->status, 200);
  EXPECT_EQ(answer("api/fit", {{"file", "dma 1.csv"}})["exit"], 2);
}

}  // namespace
}  // namespace breccia::studio
