#include "server/http_answer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "core/file.hpp"
#include "server/password.hpp"
#include "tests/server/served.hpp"

namespace rva {
namespace {

using testing::HasSubstr;
using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

class HttpAnswer : public testing::Test {
 protected:
  HttpAnswer() {
    std::filesystem::create_directories(served_.folder / "console/assets");
    write_file(served_.folder / "console/index.html", "<title>RVA</title>");
    write_file(served_.folder / "console/assets/main-1.js", "export {}");
    write_file(served_.folder / "console/assets/main-1.js.gz", "compressed");
    write_file(served_.folder / "secret.txt", "secret");
    files_ = std::make_unique<ConsoleFiles>(served_.folder / "console");
  }

  [[nodiscard]] HttpCaller caller(bool tls = false, bool loopback = true) const {
    return {api_, *files_, tls, loopback, "127.0.0.1"};
  }
  static Request get(const std::string& target, http::verb method = http::verb::get) {
    Request request(method, target, 11);
    request.set(http::field::host, "localhost:8080");
    return request;
  }
  static Request post(const std::string& target, const std::string& body) {
    Request request = get(target, http::verb::post);
    request.set(http::field::content_type, "application/json");
    request.body() = body;
    return request;
  }
  static std::string code(const Response& response) { return Json::parse(response.body())["error"]["code"]; }
  static std::string text(const Response& response, const std::string& name) {
    return std::string(response[name]);
  }

  test::Served served_;
  Api api_{served_.parts(), false};
  std::unique_ptr<ConsoleFiles> files_;
};

TEST_F(HttpAnswer, IsForNamesOfThisComputerOnly) {
  for (const char* const host : {"localhost", "localhost:8080", "127.0.0.1:1", "[::1]", "[::1]:8080"}) {
    Request request = get("/");
    request.set(http::field::host, host);
    EXPECT_EQ(http_answer(request, caller()).result_int(), 200U) << host;
  }
  for (const char* const host :
       {"", "rebound.example", "localhost.rebound.example", "127.0.0.1.rebound.example:80", "192.168.0.1",
        "[::2]", "localhost:80:80", "127.0.0.1@rebound.example"}) {
    Request request = get("/api/session");
    request.set(http::field::host, host);
    const Response refused = http_answer(request, caller());
    EXPECT_EQ(refused.result_int(), 421U) << host;
    EXPECT_EQ(code(refused), "wrong-host");
    EXPECT_EQ(http_answer(request, caller(false, false)).result_int(), 200U) << "a server in a network";
  }
}

TEST_F(HttpAnswer, HasSecurityHeadersWhateverItIs) {
  Request to_another_host = get("/");
  to_another_host.set(http::field::host, "rebound.example");
  for (const Request& request : {get("/"), get("/nothing"), get("/api/session"), to_another_host,
                                 get("/", http::verb::delete_), get("/api/session", http::verb::put)}) {
    for (const bool tls : {false, true}) {
      const Response response = http_answer(request, caller(tls));
      EXPECT_EQ(text(response, "X-Content-Type-Options"), "nosniff");
      EXPECT_EQ(text(response, "X-Frame-Options"), "DENY");
      EXPECT_THAT(text(response, "Content-Security-Policy"), HasSubstr("default-src 'self'"));
      EXPECT_THAT(text(response, "Content-Security-Policy"), HasSubstr("frame-ancestors 'none'"));
      EXPECT_EQ(response.count("Strict-Transport-Security"), tls ? 1U : 0U);
    }
  }
  EXPECT_EQ(text(http_answer(get("/api/session"), caller()), "Cache-Control"), "no-store");
}

TEST_F(HttpAnswer, FilesAreThoseOfTheConsole) {
  const Response page = http_answer(get("/?inspection=1"), caller());
  EXPECT_EQ(page.body(), "<title>RVA</title>");
  EXPECT_EQ(text(page, "Content-Type"), "text/html; charset=utf-8");
  EXPECT_EQ(text(page, "Cache-Control"), "no-cache");
  const Response script = http_answer(get("/assets/main-1.js"), caller());
  EXPECT_EQ(script.body(), "export {}");
  EXPECT_THAT(text(script, "Cache-Control"), HasSubstr("immutable"));
  for (const char* const target :
       {"/../secret.txt", "/%2e%2e/secret.txt", "//secret.txt", "/assets/main-1.js.gz", "/assets", "", "*"})
    EXPECT_EQ(http_answer(get(target), caller()).result_int(), 404U) << target;
  EXPECT_EQ(http_answer(post("/", "{}"), caller()).result_int(), 405U);
}

TEST_F(HttpAnswer, FilesAreCompressedForThoseWhoAcceptIt) {
  Request request = get("/assets/main-1.js");
  request.set(http::field::accept_encoding, "br, gzip");
  const Response compressed = http_answer(request, caller());
  EXPECT_EQ(compressed.body(), "compressed");
  EXPECT_EQ(text(compressed, "Content-Encoding"), "gzip");
  EXPECT_EQ(text(compressed, "Vary"), "Accept-Encoding");
  request.set(http::field::accept_encoding, "br");
  const Response plain = http_answer(request, caller());
  EXPECT_EQ(plain.count("Content-Encoding"), 0U);
  EXPECT_EQ(text(plain, "Vary"), "Accept-Encoding") << "a cache must keep both apart";
}

TEST_F(HttpAnswer, FilesAreCompressedAsTheWeightsOfCodingsAllow) {
  const auto is_compressed = [&](const char* accepted) {
    Request request = get("/assets/main-1.js");
    request.set(http::field::accept_encoding, accepted);
    return http_answer(request, caller()).count("Content-Encoding") > 0;
  };
  for (const char* const accepted :
       {"gzip;q=1", "GZIP", "br;q=0, gzip ; q=0.001", "*", "identity;q=0, *;q=0.5", "*;q=0, gzip"})
    EXPECT_TRUE(is_compressed(accepted)) << accepted;
  for (const char* const refused :
       {"gzip;q=0", "gzip;Q=0.000", "br, gzip ; q=0.0", "gzip;q=0, *", "*;q=0", "not-gzip", "br;gzip", ""})
    EXPECT_FALSE(is_compressed(refused)) << refused;
}

TEST_F(HttpAnswer, ToHeadIsThatToGetWithoutTheContent) {
  const Response head = http_answer(get("/", http::verb::head), caller());
  EXPECT_EQ(head.result_int(), 200U);
  EXPECT_EQ(head.body(), "");
  EXPECT_EQ(text(head, "Content-Length"), "18");
}

TEST_F(HttpAnswer, KeepsTheConnectionAsAsked) {
  Request request = get("/");
  EXPECT_TRUE(http_answer(request, caller()).keep_alive());
  request.keep_alive(false);
  EXPECT_FALSE(http_answer(request, caller()).keep_alive());
}

TEST_F(HttpAnswer, ChangesNeedJsonOfOurPage) {
  const std::string body = R"({"person":"Ann"})";
  EXPECT_EQ(http_answer(post("/api/inspections", body), caller()).result_int(), 201U) << "a program";
  Request form = post("/api/inspections", body);
  form.set(http::field::content_type, "text/plain");
  EXPECT_EQ(code(http_answer(form, caller())), "not-json");
  Request ours = post("/api/inspections", body);
  ours.set(http::field::origin, "http://localhost:8080");
  EXPECT_EQ(http_answer(ours, caller()).result_int(), 201U);
  EXPECT_EQ(code(http_answer(ours, caller(true))), "wrong-origin") << "a page without TLS beside one with it";
  for (const char* const origin :
       {"http://rebound.example", "https://localhost:8080", "http://localhost", "null", ""}) {
    ours.set(http::field::origin, origin);
    EXPECT_EQ(code(http_answer(ours, caller())), "wrong-origin") << origin;
  }
  EXPECT_EQ(served_.records.inspections().size(), 2U) << "refused requests have begun nothing";
}

TEST_F(HttpAnswer, TheSessionIsInItsCookieOnly) {
  const auto token = [](const std::string& cookies) {
    Request request = get("/");
    request.set(http::field::cookie, cookies);
    return session_token(request);
  };
  EXPECT_EQ(token("rva_session=abc"), "abc");
  EXPECT_EQ(token("a=1; rva_session=abc; b=2"), "abc");
  EXPECT_EQ(token("a=1;   rva_session=abc"), "abc");
  EXPECT_EQ(token("rva_session="), "");
  for (const char* const cookies : {"", ";", "; ;", "xrva_session=abc", "rva_sessions=abc",
                                    "a=rva_session=abc", "RVA_SESSION=abc", "rva_session"})
    EXPECT_EQ(token(cookies), "") << cookies;
  EXPECT_EQ(session_token(get("/")), "");
}

class LiveConnection : public HttpAnswer {
 protected:
  static Request live(const std::string& origin = "http://localhost:8080") {
    Request request = get("/api/live");
    request.set(http::field::origin, origin);
    return request;
  }
  [[nodiscard]] int status(const Request& request, bool tls = false) const {
    const auto answer = who_talks(request, caller(tls));
    return std::holds_alternative<Person>(answer) ? 101 : std::get<ApiResponse>(answer).status;
  }
};

TEST_F(LiveConnection, IsAPageOfThisServer) {
  EXPECT_EQ(status(live()), 101);
  EXPECT_EQ(status(live("https://localhost:8080"), true), 101);
  EXPECT_EQ(status(live("http://localhost:8080"), true), 403);
  EXPECT_EQ(status(live("http://rebound.example")), 403);
  EXPECT_EQ(status(get("/api/live")), 403) << "browsers state their page";
  Request rebound = live("http://rebound.example");
  rebound.set(http::field::host, "rebound.example");
  EXPECT_EQ(status(rebound), 403);
  Request elsewhere = live();
  elsewhere.target("/api/session");
  EXPECT_EQ(status(elsewhere), 404);
}

TEST_F(LiveConnection, IsSignedInWhereThereAreAccounts) {
  served_.records.set_account({"ann", PersonRole::operator_, hash_password("correct horse")});
  EXPECT_EQ(status(live()), 401);
  const Response signed_in =
      http_answer(post("/api/sign-in", R"({"name":"ann","password":"correct horse"})"), caller());
  ASSERT_EQ(signed_in.result_int(), 200U);
  Request request = live();
  const std::string cookie = text(signed_in, "Set-Cookie");
  request.set(http::field::cookie, cookie.substr(0, cookie.find(';')));
  const auto answer = who_talks(request, caller());
  ASSERT_TRUE(std::holds_alternative<Person>(answer));
  EXPECT_EQ(std::get<Person>(answer).name, "ann");
  EXPECT_EQ(std::get<Person>(answer).role, PersonRole::operator_);
}

}  // namespace
}  // namespace rva
