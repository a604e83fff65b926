#include "studio/request_guard.hpp"

#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace breccia::studio {
namespace {

const RequestGuard guard({.page = "secret", .results = "shown"}, 8123);

std::optional<std::string> admitted(const std::string& path, const std::string& host, const std::string& origin,
                                    const std::string& method = "GET") {
  return guard.admitted({.method = method, .path = path, .host = host, .origin = origin});
}

TEST(RequestGuard, AdmitsWhoKnowsTheAddress) {
  EXPECT_EQ(guard.address(), "http://127.0.0.1:8123/secret/");
  EXPECT_EQ(admitted("/secret/", "127.0.0.1:8123", ""), "");
  EXPECT_EQ(admitted("/secret/api/state", "localhost:8123", "http://127.0.0.1:8123"), "api/state");
  EXPECT_EQ(admitted("/secret/files/a/b.csv", "127.0.0.1:8123", "http://localhost:8123"), "files/a/b.csv");
}

TEST(RequestGuard, RefusesWithoutTheToken) {
  for (const auto* path : {"/", "", "/secret", "/secre/", "/secrets/", "/Secret/", "//secret/", "/other/secret/",
                           "secret/", "/api/state", "/secret%2Fapi"}) {
    EXPECT_EQ(admitted(path, "127.0.0.1:8123", ""), std::nullopt) << path;
  }
}

TEST(RequestGuard, RefusesOtherOrigins) {
  for (const auto* origin : {"null", "http://example.org", "https://127.0.0.1:8123", "http://127.0.0.1:8124",
                             "http://127.0.0.1:8123.example.org", "http://127.0.0.1", "file://"}) {
    EXPECT_EQ(admitted("/secret/", "127.0.0.1:8123", origin), std::nullopt) << origin;
  }
}

TEST(RequestGuard, RefusesOtherNamesOfThisMachine) {
  for (const auto* host : {"", "example.org", "example.org:8123", "127.0.0.1", "127.0.0.1:80", "0.0.0.0:8123"}) {
    EXPECT_EQ(admitted("/secret/", host, ""), std::nullopt) << host;
  }
}

TEST(RequestGuard, LetsResultsReadFilesAndNoMore) {
  EXPECT_EQ(admitted("/shown/files/results/a/report.html", "127.0.0.1:8123", ""), "files/results/a/report.html");
  EXPECT_EQ(admitted("/shown/preview/1/a.svg", "127.0.0.1:8123", ""), "preview/1/a.svg");
  for (const auto* path : {"/shown/", "/shown/api/state", "/shown/api/deck?name=a.toml", "/shown/studio.js"}) {
    EXPECT_EQ(admitted(path, "127.0.0.1:8123", ""), std::nullopt) << path;
  }
  EXPECT_EQ(admitted("/shown/files/a.csv", "127.0.0.1:8123", "", "POST"), std::nullopt);
}

TEST(RequestGuard, RefusesOtherSitesButForLinks) {
  const auto from = [](const char* site, const char* mode) {
    return guard.admitted({"GET", "/secret/api/state", "127.0.0.1:8123", "", site, mode}).has_value();
  };
  EXPECT_FALSE(from("cross-site", "no-cors"));
  EXPECT_FALSE(from("cross-site", "cors"));
  EXPECT_TRUE(from("cross-site", "navigate"));
  EXPECT_TRUE(from("same-origin", "cors"));
  EXPECT_TRUE(from("none", "navigate"));
}

TEST(RandomTokens, AreLongAndNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const auto [page, results] = random_tokens();
    tokens.insert(page);
    tokens.insert(results);
  }
  EXPECT_EQ(tokens.size(), 200U);
  for (const auto& token : tokens) {
    EXPECT_EQ(token.size(), 64U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  }
}

}  // namespace
}  // namespace breccia::studio
