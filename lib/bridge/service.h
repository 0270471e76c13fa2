// The bridge's protocol, whatever carries it: what each call does and answers. docs/bridge.md has
// it for those who write clients.
#pragma once

#include <kj/async.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "bridge/jobs.h"
#include "bridge/limits.h"
#include "bridge/programs.h"
#include "bridge/reply.h"
#include "bridge/request.h"
#include "bridge/secrets.h"
#include "bridge/store.h"

namespace obby::bridge {

struct Order;

class Service {
 public:
  Service(Loop& loop, const Limits& limits, Programs programs, Store store, Tokens tokens,
          bool needToken);
  ~Service();  // takes away the answers that were kept

  // A new code for /v1/pair; it replaces the one before.
  const Pairing& offerPairing();

  // Before a body is read: why there is no use in it.
  std::optional<Reply> closedTo(const Call& call) const;

  // Everything but events, which is the carrier's. `body` is inflated. The promise may be dropped
  // at any time.
  kj::Promise<Reply> handle(const Call& call, std::string body);

  // Before events are sent: the client, or why there are none.
  std::variant<std::shared_ptr<Client>, Reply> events(const Call& call);
  // The first message of events, without number: session, and the cursor from which it goes on.
  std::string hello(const Client& client, uint64_t cursor) const;

  std::shared_ptr<Client> client(int number);
  int clientOf(std::string_view token) const { return tokens_.clientOf(token); }

  // To be called each second: silent clients lose their WebSocket, then their jobs, and jobs that
  // have used up their processor time end.
  void sweep();
  // To be called when all jobs have ended, and no more come: WebSockets close once all messages
  // have gone.
  void endEvents();
  // Seconds since anybody was here or a job ran.
  double quietFor() const;
  Jobs& jobs() { return jobs_; }
  Loop& loop() { return loop_; }
  const Limits& limits() const { return limits_; }
  bool needToken() const { return needToken_; }
  bool paired() const { return !tokens_.empty(); }

 private:
  Reply info(const Call& call);
  Reply pair(const std::string& body);
  kj::Promise<Reply> putLevel(std::string body);
  Reply getLevel(const Call& call) const;
  Reply putJob(std::shared_ptr<Client> client, const std::string& body);
  std::variant<JobPlan, Reply> plan(const Order& order, Client& client, uint64_t number);
  std::optional<Reply> addWarmStart(const Order& order, Client& client, JobPlan& to);
  kj::Promise<Reply> getJob(std::shared_ptr<Client> client, Call call, double until, uint64_t poll);
  Reply jobReply(const Job& job, const Client& client, uint64_t cursor) const;
  Reply cancelJob(Client& client, const std::string& id);
  std::optional<Reply> checkSession(const Call& call) const;
  std::optional<Reply> checkCursor(const Call& call, const Client& client, uint64_t cursor) const;

  Loop& loop_;
  const Limits& limits_;
  Programs programs_;
  Store store_;
  Tokens tokens_;
  bool needToken_;
  std::string session_;
  std::optional<Pairing> pairing_;
  std::map<int, std::shared_ptr<Client>> clients_;
  uint32_t imports_ = 0;
  double lastSeen_ = 0;
  Jobs jobs_;
};

}  // namespace obby::bridge
