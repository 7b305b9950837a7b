#include "server/frozen_pictures.hpp"

#include <utility>

namespace rva {

int FrozenPictures::add(FrozenPicture picture) {
  auto kept = std::make_shared<const FrozenPicture>(std::move(picture));
  const std::lock_guard lock(mutex_);
  kept_.push_back(std::move(kept));
  if (kept_.size() > most) kept_.pop_front();
  return ++last_;
}

std::shared_ptr<const FrozenPicture> FrozenPictures::find(int number) const {
  const std::lock_guard lock(mutex_);
  const int first = last_ - static_cast<int>(kept_.size()) + 1;
  if (number < first || number > last_) return nullptr;
  return kept_.at(static_cast<std::size_t>(number - first));
}

}  // namespace rva
