#include "bridge/ring.h"

#include <fmt/format.h>

namespace obby::bridge {

void Ring::push(uint64_t job, const std::string& members) {
  messages_.push_back({next_, job, fmt::format("{{\"number\":{},{}}}", next_, members)});
  next_++;
  bytes_ += messages_.back().text.size();
  forgetOld();
}

void Ring::hold(uint64_t cursor) {
  taken_ = cursor;
  forgetOld();
}

void Ring::forgetOld() {
  while (bytes_ > limit_ && messages_.size() > 1) {
    const bool held = messages_.front().number > taken_;
    if (held && bytes_ <= most_) return;
    bytes_ -= messages_.front().text.size();
    messages_.pop_front();
  }
}

const Message* Ring::after(uint64_t cursor) const {
  const uint64_t first = next_ - messages_.size();
  if (cursor >= last()) return nullptr;
  return &messages_[cursor + 1 - first];
}

}  // namespace obby::bridge
