#include "bridge/ring.h"

#include "io/json_writer.h"

namespace obby::bridge {

void Ring::push(uint64_t job, std::string_view object) {
  const std::string_view members = object.substr(1, object.size() - 2);
  io::JsonWriter text;
  text.open('{').field("number", next_).raw(members);
  messages_.push_back({next_++, job, text.finish()});
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
