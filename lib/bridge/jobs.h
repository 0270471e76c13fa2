// The jobs of all clients: waiting, running, and ended ones that are still kept.
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

  // Adds a job. Returns null if the client has the max number of waiting jobs.
  Job* submit(std::shared_ptr<Client> client, JobPlan plan, uint64_t number);
  // Returns the number of the next job.
  uint64_t nextNumber() { return ++last_; }

  // Returns a job of this client, or null if it has none with that id.
  Job* find(const Client& client, const std::string& id);
  std::vector<Job*> of(const Client& client);

  void cancel(Job& job, const char* why);
  void cancelAll(const Client* client, const char* why);  // null for all clients
  // Cancels the jobs that have used up their processor time. Must be called every second.
  void boundTime();
  // Ends all jobs at once, when the bridge shuts down.
  void forgetAll();
  bool idle() const { return running_ == 0 && waiting_.empty(); }
  // Resolves once no job runs or waits.
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
  std::vector<uint64_t> waiting_;  // numbers of waiting jobs, in order of submission
  kj::Vector<kj::Own<kj::PromiseFulfiller<void>>> idleWaiters_;
  kj::Own<kj::TaskSet> tasks_;
};

}  // namespace obby::bridge
