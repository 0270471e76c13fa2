// The jobs of all clients: who waits, who runs, who can still be asked about.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bridge/job.h"

namespace obby::bridge {

class Jobs : private kj::TaskSet::ErrorHandler {
 public:
  Jobs(Loop& loop, const Limits& limits, std::function<void(const Job&)> forgotten);

  // Nothing: as many of this client's jobs wait as may.
  Job* submit(std::shared_ptr<Client> client, JobPlan plan, uint64_t number);
  // The number that the next job has.
  uint64_t nextNumber() { return ++last_; }

  // A job of this client; null: it has none of that id.
  Job* find(const Client& client, const std::string& id);
  std::vector<Job*> of(const Client& client);

  void cancel(Job& job, const char* why);
  void cancelAll(const Client* client, const char* why);  // null: everybody's
  // Cancels those that have used up their processor time. To be called each second.
  void boundTime();
  // Ends all at once: for the end of the bridge.
  void forgetAll();
  bool idle() const { return running_ == 0 && waiting_.empty(); }
  // Once nothing runs or waits.
  kj::Promise<void> whenIdle();

 private:
  void startMore();
  void forgetOld(const Client& client);
  void taskFailed(kj::Exception&& exception) override;

  Loop& loop_;
  const Limits& limits_;
  std::function<void(const Job&)> forgotten_;
  uint64_t last_ = 0;
  uint32_t running_ = 0;
  std::map<uint64_t, std::unique_ptr<Job>> jobs_;
  std::vector<uint64_t> waiting_;  // in order
  kj::Vector<kj::Own<kj::PromiseFulfiller<void>>> idleWaiters_;
  kj::Own<kj::TaskSet> tasks_;
};

}  // namespace obby::bridge
