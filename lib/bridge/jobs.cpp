#include "bridge/jobs.h"

#include <algorithm>
#include <set>

namespace obby::bridge {

Jobs::Jobs(Loop& loop, const Limits& limits, std::function<void(const Job&)> forgotten)
    : loop_(loop),
      limits_(limits),
      forgotten_(std::move(forgotten)),
      tasks_(kj::heap<kj::TaskSet>(static_cast<kj::TaskSet::ErrorHandler&>(*this))) {}

Job* Jobs::submit(std::shared_ptr<Client> client, JobPlan plan, uint64_t number) {
  const auto waits = std::count_if(waiting_.begin(), waiting_.end(), [&](uint64_t n) {
    return &jobs_.at(n)->client() == client.get();
  });
  if (waits >= int64_t(limits_.waiting)) return nullptr;
  auto job = std::make_unique<Job>(number, std::move(client), std::move(plan), limits_);
  Job* out = job.get();
  jobs_.emplace(number, std::move(job));
  waiting_.push_back(number);
  startMore();
  return out;
}

Job* Jobs::find(const Client& client, const std::string& id) {
  for (const auto& [number, job] : jobs_) {
    if (&job->client() == &client && job->id() == id) return job.get();
  }
  return nullptr;
}

std::vector<Job*> Jobs::of(const Client& client) {
  std::vector<Job*> out;
  for (const auto& [number, job] : jobs_) {
    if (&job->client() == &client) out.push_back(job.get());
  }
  return out;
}

void Jobs::startMore() {
  // Some may have been cancelled before their turn.
  std::erase_if(waiting_, [this](uint64_t number) { return jobs_.at(number)->ended(); });
  while (running_ < limits_.jobs && !waiting_.empty()) {
    Job& job = *jobs_.at(waiting_.front());
    waiting_.erase(waiting_.begin());
    running_++;
    tasks_->add(job.start(loop_).then([this, &job] {
      running_--;
      forgetOld(job.client());
      startMore();
    }));
  }
  if (!idle()) return;
  auto waiters = kj::mv(idleWaiters_);
  idleWaiters_ = {};
  for (auto& waiter : waiters) waiter->fulfill();
}

// Forgets the jobs that ended first, not those that began first, because a client asks about a long
// job when it ends. Keeps jobs whose answer another job has yet to read.
void Jobs::forgetOld(const Client& client) {
  std::vector<Job*> ended = of(client);
  std::set<uint64_t> read;
  for (const Job* job : ended) {
    if (!job->ended()) read.insert(job->warm());
  }
  std::erase_if(ended, [](const Job* job) { return !job->ended(); });
  std::sort(ended.begin(), ended.end(),
            [](const Job* a, const Job* b) { return a->lastCursor() < b->lastCursor(); });
  for (size_t i = 0; i + limits_.keptJobs < ended.size(); i++) {
    if (read.contains(ended[i]->number())) continue;
    forgotten_(*ended[i]);
    jobs_.erase(ended[i]->number());
  }
}

void Jobs::cancel(Job& job, const char* why) {
  const Client& client = job.client();
  job.cancel(why);
  startMore();
  forgetOld(client);
}

void Jobs::cancelAll(const Client* client, const char* why) {
  for (const auto& [number, job] : jobs_) {
    if (!client || &job->client() == client) job->cancel(why);
  }
  startMore();
}

void Jobs::boundTime() {
  for (const auto& [number, job] : jobs_) job->boundTime();
}

void Jobs::forgetAll() {
  tasks_ = nullptr;
  for (const auto& [number, job] : jobs_) forgotten_(*job);
  jobs_.clear();
  waiting_.clear();
}

kj::Promise<void> Jobs::whenIdle() {
  if (idle()) return kj::READY_NOW;
  auto waiting = kj::newPromiseAndFulfiller<void>();
  idleWaiters_.add(kj::mv(waiting.fulfiller));
  return kj::mv(waiting.promise);
}

// Jobs report their own failures, so an exception here is a bug in the bridge.
void Jobs::taskFailed(kj::Exception&& exception) { kj::throwFatalException(kj::mv(exception)); }

}  // namespace obby::bridge
