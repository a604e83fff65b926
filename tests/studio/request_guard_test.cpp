#include "studio/request_guard.hpp"

#include <set>

#include <gtest/gtest.h>

namespace breccia::studio {
namespace {

const RequestGuard guard("secret", 8123);

TEST(RequestGuard, AdmitsWhoKnowsTheAddress) {
  EXPECT_EQ(guard.address(), "http://127.0.0.1:8123/secret/");
  EXPECT_EQ(guard.admitted({"/secret/", "127.0.0.1:8123", ""}), "");
  EXPECT_EQ(guard.admitted({"/secret/api/state", "localhost:8123", "http://127.0.0.1:8123"}), "api/state");
  EXPECT_EQ(guard.admitted({"/secret/files/a/b.csv", "127.0.0.1:8123", "http://localhost:8123"}), "files/a/b.csv");
}

TEST(RequestGuard, RefusesWithoutTheToken) {
  for (const auto* path : {"/", "", "/secret", "/secre/", "/secrets/", "/Secret/", "//secret/", "/other/secret/",
                           "secret/", "/api/state", "/secret%2Fapi"}) {
    EXPECT_EQ(guard.admitted({path, "127.0.0.1:8123", ""}), std::nullopt) << path;
  }
}

TEST(RequestGuard, RefusesOtherOrigins) {
  for (const auto* origin : {"null", "http://example.org", "https://127.0.0.1:8123", "http://127.0.0.1:8124",
                             "http://127.0.0.1:8123.example.org", "http://127.0.0.1", "file://"}) {
    EXPECT_EQ(guard.admitted({"/secret/", "127.0.0.1:8123", origin}), std::nullopt) << origin;
  }
}

TEST(RequestGuard, RefusesOtherNamesOfThisMachine) {
  for (const auto* host : {"", "example.org", "example.org:8123", "127.0.0.1", "127.0.0.1:80", "0.0.0.0:8123"}) {
    EXPECT_EQ(guard.admitted({"/secret/", host, ""}), std::nullopt) << host;
  }
}

TEST(RandomToken, IsLongAndNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(random_token());
  EXPECT_EQ(tokens.size(), 100U);
  for (const auto& token : tokens) {
    EXPECT_EQ(token.size(), 64U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  }
}

}  // namespace
}  // namespace breccia::studio
