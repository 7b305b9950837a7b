#include "server/live_hub.hpp"

#include <chrono>

#include "server/status.hpp"

namespace rva {

LiveHub::LiveHub(asio::io_context& context, const ServerParts& parts)
    : context_(context),
      parts_(parts),
      pictures_(parts.camera, [this](std::shared_ptr<const LivePicture> picture) {
        asio::post(context_, [this, picture = std::move(picture)] { tell(picture); });
      }) {}

std::shared_ptr<LiveHub::Member> LiveHub::join(Person person) {
  members_.push_back(std::make_shared<Member>(context_, parts_, pictures_, std::move(person)));
  if (status_) members_.back()->conversation.offer(status_);
  return members_.back();
}

void LiveHub::tell(const std::shared_ptr<const LivePicture>& picture) {
  const std::chrono::duration<double> delay = std::chrono::system_clock::now() - picture->taken_at;
  parts_.traffic->add_picture(std::string(name_of(picture->stream)), delay.count());
  for (const auto& member : members_) {
    member->conversation.offer(picture);
    member->wake();
  }
}

void LiveHub::pass_on_pointing(Member& member) {
  const std::shared_ptr<const std::string> pointed = member.conversation.take_pointed();
  if (!pointed) return;
  for (const auto& other : members_) {
    other->conversation.offer_pointed(pointed);
    other->wake();
  }
}

asio::awaitable<void> LiveHub::tell_status() {
  constexpr int rounds_of_silence = 10;
  asio::steady_timer timer(context_);
  for (int round = 0; !ended_; ++round) {
    parts_.traffic->set_consoles(members_.size());
    std::string status = status_message(parts_, pictures_, members_.size());
    if (!status_ || *status_ != status || round % rounds_of_silence == 0)
      status_ = std::make_shared<const std::string>(std::move(status));
    for (const auto& member : members_) {
      member->conversation.offer(status_);
      member->wake();
    }
    timer.expires_after(std::chrono::milliseconds(100));
    co_await timer.async_wait(asio::use_awaitable);
  }
}

}  // namespace rva
