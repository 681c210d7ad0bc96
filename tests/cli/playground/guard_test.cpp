#include "cli/playground/guard.h"

#include <gtest/gtest.h>

namespace af2::playground {
namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";

RequestHead ofPage(const std::string& method) {
  return {method, "/" + kToken + "/file", "127.0.0.1:8000", "http://127.0.0.1:8000", "text/plain"};
}

int statusOf(const RequestHead& request) {
  const auto refusal = Guard(kToken, 8000).refuse(request);
  return refusal ? refusal->status : 200;
}

TEST(Guard, AnswersItsOwnPage) {
  EXPECT_EQ(statusOf(ofPage("GET")), 200);
  EXPECT_EQ(statusOf(ofPage("POST")), 200);
  RequestHead local = ofPage("POST");
  local.host = "localhost:8000";
  local.origin = "http://localhost:8000";
  EXPECT_EQ(statusOf(local), 200);
}

TEST(Guard, RefusesOtherNamesOfTheMachine) {
  RequestHead request = ofPage("GET");
  for (const char* host :
       {"", "127.0.0.1", "127.0.0.1:80", "example.org:8000", "127.0.0.1:8000.example.org"}) {
    request.host = host;
    EXPECT_EQ(statusOf(request), 403) << host;
  }
}

TEST(Guard, RefusesAddressesWithoutTheToken) {
  RequestHead request = ofPage("GET");
  for (const std::string& path :
       {std::string("/"), std::string(), "/" + kToken, "/x" + kToken + "/",
        "/" + kToken.substr(1) + "0/", "/../" + kToken + "/"}) {
    request.path = path;
    EXPECT_EQ(statusOf(request), 403) << path;
  }
}

TEST(Guard, RefusesTextsFromOtherPages) {
  RequestHead request = ofPage("POST");
  for (const char* origin :
       {"", "null", "http://example.org", "https://127.0.0.1:8000", "http://localhost:8000"}) {
    request.origin = origin;
    EXPECT_EQ(statusOf(request), 403) << origin;
  }
}

TEST(Guard, RefusesFormsAndBodiesOfUnknownLength) {
  RequestHead request = ofPage("POST");
  request.contentType = "multipart/form-data";
  EXPECT_EQ(statusOf(request), 415);
  request = ofPage("POST");
  request.isEncoded = true;
  EXPECT_EQ(statusOf(request), 411);
  EXPECT_EQ(statusOf(ofPage("PUT")), 405);
}

TEST(Guard, TokensDiffer) {
  EXPECT_EQ(newToken().size(), 32U);
  EXPECT_NE(newToken(), newToken());
}

}  // namespace
}  // namespace af2::playground
