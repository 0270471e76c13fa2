// The bridge's protocol, independent of the carrier: the effect and the reply of each call.
// docs/bridge.md describes it for authors of clients.
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
  ~Service();  // removes the answers that were kept

  // Makes a code for /v1/pair, which replaces the previous one.
  const Pairing& offerPairing();

  // Returns a reply if reading the body would be pointless.
  std::optional<Reply> closedTo(const Call& call) const;

  // Handles every call except events, which the carrier sends. `body` is inflated. The promise may
  // be dropped at any time.
  kj::Promise<Reply> handle(const Call& call, std::string body);

  // Returns the client whose events are to be sent, or a refusal.
  std::variant<std::shared_ptr<Client>, Reply> events(const Call& call);
  // Returns the first message of events, without a number: the session, and the cursor from which
  // it continues.
  std::string hello(const Client& client, uint64_t cursor) const;

  std::shared_ptr<Client> client(int number);
  int clientOf(std::string_view token) const { return tokens_.clientOf(token); }

  // Must be called every second. Silent clients lose their WebSocket and then their jobs, and jobs
  // that have used up their processor time end.
  void sweep();
  // Must be called when all jobs have ended and no more come. WebSockets close once all messages
  // have gone.
  void endEvents();
  // Returns the seconds since a client was last seen or a job ran.
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
