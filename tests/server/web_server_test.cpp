// The server over real sockets, and hostile clients.
#include "server/web_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "server/password.hpp"
#include "tests/server/served.hpp"

namespace rva {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using tcp = asio::ip::tcp;
using testing::HasSubstr;
using WebSocket = beast::websocket::stream<tcp::socket>;

class Web : public testing::Test {
 protected:
  Web() {
    std::filesystem::create_directories(served_.folder / "console/assets");
    write_file(served_.folder / "console/index.html", "<title>RVA</title>");
    write_file(served_.folder / "console/assets/main-1.js", "export {}");
    write_file(served_.folder / "console/assets/main-1.js.gz", "squeezed");
    write_file(served_.folder / "secret.txt", "secret");
    start(24);
  }
  ~Web() override { stop(); }

  void start(int connections, double write_limit_s = 30.0) {
    ServerOptions options;
    options.port = 0;
    options.connections = connections;
    options.write_limit_s = write_limit_s;
    options.console = (served_.folder / "console").string();
    server_ = std::make_unique<WebServer>(options, served_.parts(), [this](const Event& event) {
      const std::lock_guard lock(mutex_);
      if (event.name == "refused") log_.push_back(event.message);
    });
    thread_ = std::thread([this] { server_->run(); });
  }
  void stop() {
    server_->stop();
    thread_.join();
  }
  [[nodiscard]] std::vector<std::string> log() {
    const std::lock_guard lock(mutex_);
    return log_;
  }

  tcp::socket connect() {
    tcp::socket socket(io_, tcp::v4());
    if (receive_buffer_bytes_)
      socket.set_option(asio::socket_base::receive_buffer_size(*receive_buffer_bytes_));
    socket.connect({asio::ip::address_v4::loopback(), server_->port()});
    return socket;
  }
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(server_->port()); }

  // What comes back until the server closes, or the answer is complete.
  std::string say(const std::string& bytes) {
    tcp::socket socket = connect();
    boost::system::error_code failure;
    asio::write(socket, asio::buffer(bytes), failure);
    std::string answer;
    asio::read(socket, asio::dynamic_buffer(answer), failure);
    return answer;
  }
  std::string get(const std::string& target, const std::string& headers = "") {
    return say("GET " + target + " HTTP/1.1\r\nHost: " + host() + "\r\nConnection: close\r\n" + headers +
               "\r\n");
  }
  std::string post(const std::string& target, const std::string& body, const std::string& headers = "") {
    return say("POST " + target + " HTTP/1.1\r\nHost: " + host() +
               "\r\nConnection: close\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" + headers +
               "\r\n" + body);
  }

  std::unique_ptr<WebSocket> live(const std::string& origin = "") {
    auto socket = std::make_unique<WebSocket>(connect());
    const std::string from = origin.empty() ? "http://" + host() : origin;
    socket->set_option(beast::websocket::stream_base::decorator(
        [from](beast::websocket::request_type& request) { request.set(http::field::origin, from); }));
    socket->handshake(host(), "/api/live");
    return socket;
  }
  static void tell(WebSocket& socket, const std::string& text) { socket.write(asio::buffer(text)); }
  static std::string hear(WebSocket& socket) {
    beast::flat_buffer buffer;
    socket.read(buffer);
    return beast::buffers_to_string(buffer.data());
  }
  // Greets, and reads until there is a status.
  std::unique_ptr<WebSocket> console(const std::string& client) {
    auto socket = live();
    tell(*socket, R"({"type":"hello","protocol":1,"client":")" + client + R"(","name":"Ann"})");
    while (hear(*socket).find("\"status\"") == std::string::npos) {
    }
    return socket;
  }
  static std::string close_reason(WebSocket& socket) {
    boost::system::error_code failure;
    beast::flat_buffer buffer;
    while (!failure) {
      buffer.clear();
      socket.read(buffer, failure);
    }
    return {socket.reason().reason.data(), socket.reason().reason.size()};
  }

  test::Served served_;
  std::mutex mutex_;
  std::vector<std::string> log_;
  asio::io_context io_;
  std::optional<int> receive_buffer_bytes_;  // of new connections; set by the system where there is none
  std::unique_ptr<WebServer> server_;
  std::thread thread_;
};

TEST_F(Web, ServesTheConsoleWithAStrictPolicy) {
  const std::string page = get("/");
  EXPECT_THAT(page, HasSubstr("200 OK"));
  EXPECT_THAT(page, HasSubstr("<title>RVA"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'self'"));
  EXPECT_THAT(page, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(get("/assets/main-1.js"), HasSubstr("export {}"));
  EXPECT_THAT(get("/assets/main-1.js", "Accept-Encoding: gzip\r\n"), HasSubstr("squeezed"));
}

TEST_F(Web, NothingOutsideTheConsoleCanBeReached) {
  for (const char* const target :
       {"/../secret.txt", "/..%2fsecret.txt", "/%2e%2e/secret.txt", "//etc/passwd",
        "/assets/../../secret.txt", "/rva.db", "/assets/main-1.js.gz", "\\..\\secret.txt"})
    EXPECT_THAT(get(target), testing::Not(testing::AnyOf(HasSubstr("secret\n"), HasSubstr("200 OK"))))
        << target;
}

TEST_F(Web, MalformedAndOversizedRequestsAreRefusedAndLoggedOnce) {
  for (int i = 0; i < 20; ++i) EXPECT_THAT(say("nonsense\r\n\r\n"), HasSubstr("400"));
  EXPECT_THAT(say("GET / HTTP/1.1\r\nX: " + std::string(20000, 'a') + "\r\n\r\n"), HasSubstr("431"));
  EXPECT_THAT(post("/api/inspections", std::string(100000, ' '), "Content-Type: application/json\r\n"),
              HasSubstr("413"));
  int malformed = 0;
  for (const std::string& line : log()) malformed += line.find("bad method") != std::string::npos ? 1 : 0;
  EXPECT_EQ(malformed, 1);
  EXPECT_THAT(get("/"), HasSubstr("200 OK")) << "and others are served";
}

TEST_F(Web, OtherPagesCannotAsk) {
  const std::string json = "Content-Type: application/json\r\n";
  EXPECT_THAT(post("/api/inspections", R"({"person":"Ann"})", json), HasSubstr("201"));
  EXPECT_THAT(post("/api/inspections", R"({"person":"Ann"})", json + "Origin: http://evil.example\r\n"),
              HasSubstr("403"));
  EXPECT_THAT(post("/api/inspections", R"({"person":"Ann"})", "Content-Type: text/plain\r\n"),
              HasSubstr("415"));
  EXPECT_THAT(say("GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"), HasSubstr("421"));
  EXPECT_THROW(live("http://evil.example"), boost::system::system_error);
  EXPECT_THROW(live("null"), boost::system::system_error);
}

TEST_F(Web, AConsoleReceivesStatusAndPictures) {
  const auto socket = console("client-number-one");
  tell(*socket, R"({"type":"watch","stream":"depth"})");
  std::string message;
  do {
    message = hear(*socket);
  } while (!socket->got_binary());
  const auto length = static_cast<unsigned char>(message.at(0));
  EXPECT_THAT(message.substr(4, length), HasSubstr("\"stream\":\"depth\""));
  EXPECT_EQ(message.substr(4U + length, 2), "\xff\xd8") << "a JPEG";
}

TEST_F(Web, ABreachOfTheProtocolIsReportedAndOthersGoOn) {
  const auto good = console("client-number-one");
  auto other = live();
  tell(*other, R"({"type":"hello","protocol":99,"client":"0123456789abcdef"})");
  EXPECT_THAT(close_reason(*other), HasSubstr("another version"));
  auto large = console("client-number-two");
  tell(*large, std::string(5000, 'x'));
  close_reason(*large);
  auto binary = console("client-number-three");
  binary->binary(true);
  tell(*binary, "{}");
  EXPECT_THAT(close_reason(*binary), HasSubstr("not text"));
  // Raw bytes that are no frame.
  auto raw = console("client-number-four");
  asio::write(raw->next_layer(), asio::buffer(std::string(100, '\xff')));
  close_reason(*raw);
  tell(*good, R"({"type":"stop"})");
  EXPECT_THAT(hear(*good), HasSubstr("type"));
}

TEST_F(Web, AThousandConnectionsShutNobodyOut) {
  const auto good = console("client-number-one");
  std::vector<tcp::socket> idle;
  for (int i = 0; i < 1000; ++i) idle.push_back(connect());
  EXPECT_THAT(get("/"), HasSubstr("200 OK")) << "idle ones make room";
  EXPECT_THAT(hear(*good), HasSubstr("type"));
  int complaints = 0;
  for (const std::string& line : log())
    complaints += line.find("too many connections: idle") != std::string::npos ? 1 : 0;
  EXPECT_EQ(complaints, 1);
}

TEST_F(Web, ASlowReaderGetsFewerPicturesAndHoldsUpNobody) {
  const auto slow = console("client-number-one");
  tell(*slow, R"({"type":"watch","stream":"depth"})");
  const auto quick = console("client-number-two");
  tell(*quick, R"({"type":"watch","stream":"depth"})");
  int pictures = 0;
  while (pictures < 50) {
    hear(*quick);
    if (!quick->got_binary()) continue;
    ++pictures;
    tell(*quick, R"({"type":"shown"})");
  }
  int late = 0;
  for (int i = 0; i < 10; ++i) {
    hear(*slow);
    late += slow->got_binary() ? 1 : 0;
  }
  EXPECT_LE(late, 2) << "a client that does not confirm pictures gets no more";
}

// Confirms that pictures were shown, at the most often that is permitted, without reading them.
class WebWithAnImpatientServer : public Web {
 protected:
  WebWithAnImpatientServer() {
    stop();
    start(24, 0.5);
    receive_buffer_bytes_ = 2048;
    socket_ = console("client-number-one");
    tell(*socket_, R"({"type":"watch","stream":"depth"})");
  }
  [[nodiscard]] bool confirm() {
    boost::system::error_code failure;
    socket_->write(asio::buffer(std::string(R"({"type":"shown"})")), failure);
    std::this_thread::sleep_for(std::chrono::milliseconds(6));
    return !failure.failed();
  }
  std::unique_ptr<WebSocket> socket_;
};

TEST_F(WebWithAnImpatientServer, KeepsAConsoleThatReadsLateAndThenHasNothingToSay) {
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(confirm()) << i;
  const double quiet_from_s = steady_clock().now_s();
  while (steady_clock().now_s() - quiet_from_s < 1.5) EXPECT_FALSE(hear(*socket_).empty());
}

TEST_F(WebWithAnImpatientServer, DisconnectsAConsoleThatDoesNotRead) {
  EXPECT_TRUE(test::eventually([this] { return !confirm(); }))
      << "its pictures fill the buffers of the connection";
}

TEST_F(Web, AccountsKeepStrangersOut) {
  served_.records.set_account({"ann", PersonRole::viewer, hash_password("correct horse")});
  EXPECT_THAT(get("/api/inspections"), HasSubstr("401"));
  EXPECT_THROW(live(), boost::system::system_error);
  EXPECT_THAT(get("/"), HasSubstr("200 OK")) << "the page itself asks to sign in";
}

TEST_F(Web, WhatAPersonMaySeeIsKeptByNoBrowserAndNoOtherPage) {
  for (const char* const path : {"/api/session", "/api/inspections", "/api/findable.png"}) {
    EXPECT_THAT(get(path), HasSubstr("Cache-Control: no-store")) << path;
    EXPECT_THAT(get(path), HasSubstr("Cross-Origin-Resource-Policy: same-origin")) << path;
  }
}

TEST_F(Web, APortThatIsTakenIsReported) {
  ServerOptions options;
  options.port = server_->port();
  options.console = (served_.folder / "console").string();
  try {
    const WebServer second(options, served_.parts(), [](const Event&) {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("port"));
  }
}

TEST(WebServerOptions, OthersThanThisComputerNeedTlsAndAccounts) {
  test::Served served;
  std::filesystem::create_directories(served.folder / "console");
  write_file(served.folder / "console/index.html", "x");
  ServerOptions options;
  options.port = 0;
  options.address = "0.0.0.0";
  options.console = (served.folder / "console").string();
  const auto log = [](const Event&) {};
  EXPECT_THROW(WebServer(options, served.parts(), log), UsageError);
  options.tls_certificate = "only one of the two";
  EXPECT_THROW(WebServer(options, served.parts(), log), UsageError);
  options.tls_key = "missing.pem";
  EXPECT_THROW(WebServer(options, served.parts(), log), Error);
  options = {};
  options.address = "everywhere";
  EXPECT_THROW(WebServer(options, served.parts(), log), UsageError);
  options.address = "127.0.0.1";
  options.console = (served.folder / "nothing").string();
  EXPECT_THROW(WebServer(options, served.parts(), log), Error);
}

}  // namespace
}  // namespace rva
