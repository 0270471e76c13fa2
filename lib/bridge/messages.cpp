#include "bridge/messages.h"

#include "io/json_writer.h"
#include "io/utf8.h"

namespace obby::bridge {
namespace {

constexpr uint64_t kFrame = 200;  // max bytes of a message in addition to its text

// Splits text into pieces of whole characters, each at most `limit` bytes as a JSON string. In JSON
// a control character takes six bytes, and a quote or backslash two.
std::vector<std::string_view> pieces(std::string_view text, uint64_t limit) {
  std::vector<std::string_view> out;
  size_t begin = 0, at = 0;
  uint64_t size = 0;
  while (at < text.size()) {
    const size_t length = std::max<size_t>(io::utf8Length(text.substr(at, 4)), 1);
    const uint8_t c = uint8_t(text[at]);
    const uint64_t cost = c < 0x20 || c == 0x7f ? 6 : c == '"' || c == '\\' ? 2 : length;
    if (size + cost > limit) {
      out.push_back(text.substr(begin, at - begin));
      begin = at;
      size = 0;
    }
    size += cost;
    at += length;
  }
  out.push_back(text.substr(begin));
  return out;
}

}  // namespace

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
    if (held && bytes_ <= max_) return;
    bytes_ -= messages_.front().text.size();
    messages_.pop_front();
  }
}

const Message* Ring::after(uint64_t cursor) const {
  const uint64_t first = next_ - messages_.size();
  if (cursor >= last()) return nullptr;
  return &messages_[cursor + 1 - first];
}

std::vector<std::string> recordMessages(std::string_view job, std::string_view record,
                                        uint64_t limit) {
  io::JsonWriter json;
  if (record.size() + kFrame <= limit) {
    json.open('{').field("job", job).field("type", "record").key("record").raw(record);
    return {json.finish()};
  }
  std::vector<std::string> out;
  const auto parts = pieces(record, limit - kFrame);
  for (const std::string_view part : parts) {
    json.open('{').field("job", job).field("type", "fragment").field("index", out.size());
    out.push_back(json.field("count", parts.size()).field("text", part).finish());
  }
  return out;
}

}  // namespace obby::bridge
