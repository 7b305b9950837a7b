#include "server/conversation.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

#include "core/clock.hpp"
#include "core/json_object.hpp"
#include "inspect/person_name.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

constexpr std::uint64_t most_under_way = 2;
constexpr std::size_t most_replies = 50;

double unix_ms(std::chrono::system_clock::time_point moment) {
  return std::chrono::duration<double, std::milli>(moment.time_since_epoch()).count();
}

// A binary message: length of the description (4 bytes, little endian), description as JSON, JPEG.
Message message_of(const LivePicture& picture) {
  Json head{{"stream", name_of(picture.stream)},
            {"number", picture.number},
            {"width", picture.width},
            {"height", picture.height},
            {"taken_ms", unix_ms(picture.taken_at)}};
  if (picture.scale_m) head["scale_m"] = {picture.scale_m->low, picture.scale_m->high};
  const std::string text = json_text(head);
  Message message{true, {}};
  message.bytes.reserve(4 + text.size() + picture.jpeg.size());
  for (unsigned shift = 0; shift < 32; shift += 8)
    message.bytes += static_cast<char>((text.size() >> shift) & 0xFFU);
  message.bytes += text;
  message.bytes.append(reinterpret_cast<const char*>(picture.jpeg.data()), picture.jpeg.size());
  return message;
}

// Others see the name of the person who is driving, so an illegible one is dropped.
std::string legible_name(const std::string& name) { return is_legible_name(name) ? name : ""; }

// A point of a picture, as shares of its width and height.
Json share_in(const Json& message, const char* key) {
  const auto found = message.find(key);
  if (found == message.end() || !found->is_object())
    throw ApiError(400, "bad-request", key, "is missing", "see docs/api.md");
  const double x = number_field(*found, "x");
  const double y = number_field(*found, "y");
  if (x < 0.0 || x > 1.0 || y < 0.0 || y > 1.0)
    throw ApiError(400, "bad-request", key, "is outside of the picture", "see docs/api.md");
  return {{"x", x}, {"y", y}};
}

Json parse(std::string_view text) {
  try {
    return parse_body(std::string(text));
  } catch (const Error& error) {
    throw ProtocolError(error.what());
  }
}

}  // namespace

Conversation::Conversation(const ServerParts& parts, LivePictures& pictures, Person person)
    : parts_(parts), pictures_(pictures), person_(std::move(person)) {}

Conversation::~Conversation() {
  if (watched_) pictures_.watch(*watched_, -1);
  if (client_.empty()) return;
  const double now_s = steady_clock().now_s();
  const auto holder = parts_.lease.holder(now_s);
  const bool gone = parts_.lease.leave(client_, now_s);
  if (parts_.drive == nullptr || !gone || !holder || holder->client != client_) return;
  if (!parts_.drive->state().lent) parts_.drive->halt();
}

void Conversation::set_role(PersonRole role) {
  person_.role = role;
  const auto holder = parts_.lease.holder(steady_clock().now_s());
  if (role >= PersonRole::operator_ || !holder || holder->client != client_) return;
  if (parts_.drive != nullptr && !parts_.drive->state().lent) parts_.drive->halt();
  parts_.lease.release(client_);
}

// Permitted in every role. Stops the robot, and the capture, which would move it again.
void Conversation::stop() {
  parts_.inspector.stop_capture();
  if (parts_.drive != nullptr) parts_.drive->halt();
}

void Conversation::hear(std::string_view text, double now_s) {
  limit_rate(now_s);
  const Json message = parse(text);
  const auto found = message.find("type");
  const std::string type = found != message.end() && found->is_string() ? found->get<std::string>() : "";
  if (client_.empty() && type != "hello") throw ProtocolError("the first message is not a hello");
  try {
    if (type == "hello") return greet(message);
    if (type == "watch") return watch(message);
    if (type == "shown") return shown(message);
    if (type == "drive") return drive(message, now_s);
    if (type == "lease") return lease(message, now_s);
    if (type == "stop") return stop();
    if (type == "pointing") return point(message, now_s);
  } catch (const ApiError& error) {
    if (client_.empty()) throw ProtocolError(error.what());  // nothing is answered before a hello
    return refuse(error.code(), error.what());
  }
  throw ProtocolError("unknown message");
}

// Permitted in every role: it is shown to all consoles for some seconds and never stored.
void Conversation::point(const Json& message, double now_s) {
  const std::optional<Stream> stream = value_of<Stream>(text_field(message, "stream"));
  const std::optional<PointingShape> shape = value_of<PointingShape>(text_field(message, "shape"));
  if (!stream || !shape)
    throw ApiError(400, "bad-request", "pointing", "needs a stream and a shape", "see docs/api.md");
  constexpr double most_at_once = 2.0 * most_pointed_per_s;
  pointing_allowance_ =
      std::min(most_at_once, pointing_allowance_ + (now_s - pointed_s_) * most_pointed_per_s);
  pointed_s_ = now_s;
  if (pointing_allowance_ < 1.0) return refuse("too-many", "pointing: you point too often; wait a moment");
  pointing_allowance_ -= 1.0;
  Json shown{{"type", "pointed"}, {"name", name_}, {"stream", name_of(*stream)}, {"shape", name_of(*shape)}};
  shown["from"] = share_in(message, "from");
  shown["to"] = share_in(message, *shape == PointingShape::tap ? "from" : "to");
  pointed_ = std::make_shared<const std::string>(json_text(shown));
}

void Conversation::offer_pointed(const std::shared_ptr<const std::string>& pointed) {
  constexpr std::size_t most_to_show = 20;
  if (to_show_.size() == most_to_show) to_show_.pop_front();
  to_show_.push_back(pointed);
}

// A token bucket: short bursts pass, floods do not.
void Conversation::limit_rate(double now_s) {
  allowance_ = std::min(most_messages_per_s, allowance_ + (now_s - heard_s_) * most_messages_per_s);
  heard_s_ = now_s;
  allowance_ -= 1.0;
  if (allowance_ < 0.0) throw ProtocolError("too many messages");
}

void Conversation::greet(const Json& message) {
  const auto version = message.find("protocol");
  if (version == message.end() || *version != protocol)
    throw ProtocolError("this console has another version than the server; reload the page");
  if (!client_.empty()) throw ProtocolError("a second hello");
  const std::string client = text_field(message, "client");
  name_ = person_.name.empty() ? legible_name(text_field(message, "name")) : person_.name;
  constexpr std::size_t least_client_bytes = 16;
  if (client.size() < least_client_bytes) throw ProtocolError("the console's id is missing or too short");
  client_ = client;
  parts_.lease.arrive(client_);
}

void Conversation::watch(const Json& message) {
  const std::optional<Stream> wanted = value_of<Stream>(text_field(message, "stream"));
  if (watched_) pictures_.watch(*watched_, -1);
  watched_ = wanted;
  if (watched_) pictures_.watch(*watched_, 1);
  picture_.reset();
}

void Conversation::shown(const Json& /*message*/) { shown_ = std::min(shown_ + 1, sent_); }

// A delayed message reports how the sticks were, not how they are. It is ignored, since the robot stops when
// there are no messages. The console's clock has another origin, so the smallest delay so far counts as none;
// clocks that drift apart by less than 1 in 5000 are tolerated.
bool Conversation::is_fresh(double stamp_s, double now_s) {
  constexpr double most_late_s = 0.3;
  constexpr double drift = 2e-4;
  const double delay_s = now_s - stamp_s;
  const double forgiven_s =
      least_delay_s_ ? *least_delay_s_ + drift * std::max(0.0, now_s - stamped_s_) : delay_s;
  stamped_s_ = now_s;
  least_delay_s_ = std::min(delay_s, forgiven_s);
  return delay_s - *least_delay_s_ <= most_late_s;
}

void Conversation::drive(const Json& message, double now_s) {
  if (parts_.drive == nullptr) return;
  const Deflection deflection{number_field(message, "pan"), number_field(message, "tilt")};
  const bool fresh = is_fresh(number_field(message, "stamp_ms") / 1000.0, now_s);
  const bool held = deflection != Deflection{};
  const auto holder = parts_.lease.holder(now_s);
  if (person_.role < PersonRole::operator_ || !holder || holder->client != client_) {
    if (held) refuse("not-driving", "robot: you do not have the controls; take the controls first");
    return;
  }
  if (held && !parts_.lease.use(client_, now_s)) return;
  if (fresh || !held) parts_.drive->steer(deflection);  // letting go is never too late
}

void Conversation::lease(const Json& message, double now_s) {
  if (person_.role < PersonRole::operator_)
    throw ApiError(403, "not-allowed", "robot", "your role only permits viewing and stopping it",
                   "ask an operator to drive");
  const std::string action = text_field(message, "action");
  if (action == "release") {
    const auto holder = parts_.lease.holder(now_s);
    if (parts_.drive != nullptr && holder && holder->client == client_ && !parts_.drive->state().lent)
      parts_.drive->halt();
    return parts_.lease.release(client_);
  }
  if (action != "take" && action != "take-over") throw ProtocolError("unknown action");
  const std::string name = legible_name(text_field(message, "name"));
  if (person_.name.empty() && !name.empty()) name_ = name;
  const auto before = parts_.lease.holder(now_s);
  if (!parts_.lease.take({client_, name_}, action == "take-over", now_s))
    return refuse("somebody-drives", "robot: somebody else is driving; take over, or wait");
  if (parts_.drive != nullptr && before && before->client != client_ && !parts_.drive->state().lent)
    parts_.drive->halt();
}

void Conversation::refuse(const std::string& code, const std::string& message) {
  if (replies_.size() == most_replies) replies_.pop_front();
  replies_.push_back(json_text(Json{{"type", "refused"}, {"code", code}, {"message", message}}));
}

void Conversation::offer(const std::shared_ptr<const LivePicture>& picture) {
  if (watched_ == picture->stream) picture_ = picture;
}

std::optional<Message> Conversation::lease_news(double now_s) {
  const auto holder = parts_.lease.holder(now_s);
  Json news{{"type", "lease"}, {"yours", holder && holder->client == client_}};
  if (holder) news["holder"] = holder->name;
  std::string text = json_text(news);
  if (text == sent_lease_) return std::nullopt;
  sent_lease_ = text;
  return Message{false, std::move(text)};
}

std::optional<Message> Conversation::next(double now_s) {
  if (client_.empty()) return std::nullopt;
  if (!replies_.empty()) {
    Message message{false, std::move(replies_.front())};
    replies_.pop_front();
    return message;
  }
  if (std::optional<Message> news = lease_news(now_s)) return news;
  if (!to_show_.empty()) {
    Message message{false, *to_show_.front()};
    to_show_.pop_front();
    return message;
  }
  if (status_ && status_ != sent_status_) {
    sent_status_ = status_;
    return Message{false, *status_};
  }
  if (picture_ && sent_ - shown_ < most_under_way) {
    ++sent_;
    return message_of(*std::exchange(picture_, nullptr));
  }
  return std::nullopt;
}

}  // namespace rva
