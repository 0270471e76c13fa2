// The last messages to a client, numbered, so that it can go on from where it was.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>

namespace obby::bridge {

struct Message {
  uint64_t number = 0;
  uint64_t job = 0;
  std::string text;  // `{"number":7,...}`
};

class Ring {
 public:
  // Keeps so many bytes of messages; of held ones (below) up to `unsent`, if that is more.
  explicit Ring(uint64_t bytes, uint64_t unsent = 0)
      : limit_(bytes), most_(std::max(bytes, unsent)) {}

  // Keeps `{"number":N,<members>}` about that job; the oldest messages go when the ring is full.
  void push(uint64_t job, const std::string& members);

  // Somebody takes all messages in their order, and has those up to `cursor`: the others are held
  // until the next call, or until release().
  void hold(uint64_t cursor);
  void release() { hold(kNobody); }

  uint64_t last() const { return next_ - 1; }  // number of the newest message ever; 0: none
  // Whether all messages after `cursor` are still here.
  bool reaches(uint64_t cursor) const { return cursor + 1 >= next_ - messages_.size(); }
  // The first message after `cursor`; null: there is none yet. Only if reaches(cursor).
  const Message* after(uint64_t cursor) const;
  uint64_t bytes() const { return bytes_; }
  bool halfFull() const { return bytes_ > limit_ / 2; }

 private:
  static constexpr uint64_t kNobody = ~uint64_t(0);  // as if all were taken

  void forgetOld();

  uint64_t limit_, most_, bytes_ = 0, next_ = 1;
  uint64_t taken_ = kNobody;  // held are those after it
  std::deque<Message> messages_;
};

}  // namespace obby::bridge
