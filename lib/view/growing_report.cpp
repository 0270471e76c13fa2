#include "view/growing_report.h"

namespace obby::view {

Status GrowingReport::add(const io::Record& record) {
  std::unique_lock lock(mutex_);
  // With a mutex alone, a fast stream could starve the other thread.
  turn_.wait(lock, [this] { return !wanted_ || closed_; });
  OBBY_RETURN_IF_ERROR(collector_.add(record));
  changed_ = true;
  return collector_.update();
}

Status GrowingReport::end(StreamState state, const std::vector<std::string>& notes) {
  const std::lock_guard lock(mutex_);
  for (const std::string& note : notes) collector_.note(note);
  Status chosen = collector_.checkChosen();
  if (!chosen) collector_.note(chosen.error().text());
  state_ = chosen ? state : StreamState::broken;
  changed_ = true;
  return chosen;
}

Status GrowingReport::use(const std::function<Status(const Report&)>& use) {
  const std::lock_guard lock(mutex_);
  return use(collector_.report());
}

bool GrowingReport::look(const std::function<void(const Report&, StreamState)>& look) {
  if (!changed_) return false;
  wanted_ = true;
  std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return false;
  wanted_ = false;
  changed_ = false;
  look(collector_.report(), state_);
  lock.unlock();
  turn_.notify_all();
  return true;
}

void GrowingReport::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  turn_.notify_all();
}

}  // namespace obby::view
