#include "calibrate/work.h"

#include <algorithm>
#include <thread>

namespace obby::calibrate {

void Account::enter(const char* task, Stretch stretch) {
  stretch_ = stretch;
  progress_.task = task;
  reach(stretch.from);
}

void Account::step(size_t done, size_t all) {
  reach(stretch_.of(0, double(done) / double(std::max<size_t>(all, 1))).to);
}

void Account::found(double loss) { progress_.loss = std::min(progress_.loss, loss); }

void Account::reach(double share) {
  progress_.share = std::max(progress_.share, share);
  tell();
}

void Account::tell() const {
  FitProgress now = progress_;
  now.evaluations = evaluations_;
  tell_(now);
}

void Work::run(int count, const std::function<void(int)>& task) const {
  if (pool_ == nullptr) {
    for (int i = 0; i < count && !stopped(); ++i) task(i);
    return;
  }
  const auto caller = std::this_thread::get_id();
  pool_->run(count, [&](int i) {
    if (stopped()) return;
    task(i);
    if (std::this_thread::get_id() == caller) account_->tell();
  });
}

}  // namespace obby::calibrate
