#include "server/lease.hpp"

namespace rva {

bool Lease::is_held(double now_s) const {
  return holder_ && now_s - used_s_ < idle_limit_s && !(gone_s_ && now_s - *gone_s_ >= gone_limit_s);
}

bool Lease::take(const Holder& who, bool take_over, double now_s) {
  const std::lock_guard lock(mutex_);
  if (is_held(now_s) && holder_->client != who.client && !take_over) return false;
  holder_ = who;
  used_s_ = now_s;
  gone_s_.reset();
  return true;
}

void Lease::release(const std::string& client) {
  const std::lock_guard lock(mutex_);
  if (holder_ && holder_->client == client) holder_.reset();
}

bool Lease::use(const std::string& client, double now_s) {
  const std::lock_guard lock(mutex_);
  if (!is_held(now_s) || holder_->client != client) return false;
  used_s_ = now_s;
  return true;
}

void Lease::arrive(const std::string& client) {
  const std::lock_guard lock(mutex_);
  ++connections_[client];
  if (holder_ && holder_->client == client) gone_s_.reset();
}

bool Lease::leave(const std::string& client, double now_s) {
  const std::lock_guard lock(mutex_);
  const auto known = connections_.find(client);
  if (known != connections_.end() && --known->second > 0) return false;
  connections_.erase(client);
  if (holder_ && holder_->client == client) gone_s_ = now_s;
  return true;
}

std::optional<Lease::Holder> Lease::holder(double now_s) const {
  const std::lock_guard lock(mutex_);
  return is_held(now_s) ? holder_ : std::nullopt;
}

}  // namespace rva
