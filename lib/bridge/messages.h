// Messages to a client: the last ones are kept and numbered, so that the client can resume, and
// records of any size become messages of bounded size.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace obby::bridge {

struct Message {
  uint64_t number = 0;
  uint64_t job = 0;
  std::string text;  // `{"number":7,...}`
};

class Ring {
 public:
  // Keeps this many bytes of messages, and up to `unsent` bytes of held ones (below) if that is
  // more.
  explicit Ring(uint64_t bytes, uint64_t unsent = 0)
      : limit_(bytes), max_(std::max(bytes, unsent)) {}

  // Adds a JSON object about that job, with its number as the first member. The oldest messages are
  // dropped when the ring is full.
  void push(uint64_t job, std::string_view object);

  // Notes that a carrier, which takes all messages in order, has the messages up to `cursor`. Later
  // ones are held until the next call, or until release().
  void hold(uint64_t cursor);
  void release() { hold(kNobody); }

  uint64_t last() const { return next_ - 1; }  // number of the newest message so far; 0 for none
  // Returns true if all messages after `cursor` are still here.
  bool reaches(uint64_t cursor) const { return cursor + 1 >= next_ - messages_.size(); }
  // Returns the first message after `cursor`, or null if there is none yet. Requires
  // reaches(cursor).
  const Message* after(uint64_t cursor) const;
  uint64_t bytes() const { return bytes_; }
  bool halfFull() const { return bytes_ > limit_ / 2; }

 private:
  static constexpr uint64_t kNobody = ~uint64_t(0);  // no carrier, so nothing is held

  void forgetOld();

  uint64_t limit_, max_, bytes_ = 0, next_ = 1;
  // Number of the last message that the carrier has; later messages are held.
  uint64_t taken_ = kNobody;
  std::deque<Message> messages_;
};

// Returns the messages that carry one record of a job, in order. Normally that is one message
// `{"job":"j1","type":"record","record":{...}}`. If it would be longer than `limit` bytes, there
// are several `{"job":"j1","type":"fragment","index":0,"count":3,"text":"..."}` whose joined texts
// are the record's JSON. `record` is JSON; limit >= 1024.
std::vector<std::string> recordMessages(std::string_view job, std::string_view record,
                                        uint64_t limit);

}  // namespace obby::bridge
