#include "bridge/service.h"

#include <fmt/format.h>

#include "bridge/importing.h"
#include "bridge/json.h"
#include "bridge/moving.h"
#include "io/version.h"
#include "loopback/secrets.h"

namespace obby::bridge {
namespace {

constexpr size_t kSessionBytes = 8;
constexpr uint32_t kImports = 2;  // max number at a time
constexpr const char* kAskAgain = "get session and cursor from /v1/info, then ask again";

Reply noSuchJob() {
  return refuse(404, "there is no job with this id",
                "it may have ended long ago, or the bridge was restarted");
}

Reply levelReply(int status, const std::string& id, const std::vector<std::string>& queries,
                 const std::vector<std::string>& warnings) {
  io::JsonWriter out;
  out.open('{').field("level", id).key("queries").list(queries).key("warnings").open('[');
  for (const std::string& warning : warnings) out.raw(warning);
  return {status, out.finish()};
}

}  // namespace

Service::Service(Loop& loop, const Limits& limits, Programs programs, Store store, Tokens tokens,
                 bool needToken)
    : loop_(loop),
      limits_(limits),
      programs_(std::move(programs)),
      store_(std::move(store)),
      tokens_(std::move(tokens)),
      needToken_(needToken),
      session_(loopback::randomHex(kSessionBytes)),
      lastSeen_(loop.now()),
      jobs_(loop, limits, [this](const Job& job) {
        if (!job.answerPath().empty()) store_.removeAnswer(job.answerPath());
      }) {}

Service::~Service() { jobs_.forgetAll(); }

const Pairing& Service::offerPairing() { return pairing_.emplace(loop_.now()); }

std::shared_ptr<Client> Service::client(int number) {
  auto& out = clients_[number];
  if (!out) out = std::make_shared<Client>(number, limits_.ringBytes, limits_.unsentBytes);
  out->lastSeen = lastSeen_ = loop_.now();
  return out;
}

kj::Promise<Reply> Service::handle(const Call& call, std::string body) {
  if (auto closed = closedTo(call)) return *std::move(closed);
  if (call.endpoint == Endpoint::info) return info(call);
  if (call.endpoint == Endpoint::pair) return pair(body);
  std::shared_ptr<Client> who = client(call.client);
  switch (call.endpoint) {
    case Endpoint::putLevel: return putLevel(std::move(body));
    case Endpoint::getLevel: return getLevel(call);
    case Endpoint::putJob: return putJob(std::move(who), body);
    case Endpoint::cancelJob: return cancelJob(*who, call.id);
    case Endpoint::getJob: break;
    default: return refuse(426, "events are sent over a WebSocket", "open a WebSocket");
  }
  Job* job = jobs_.find(*who, call.id);
  const uint64_t poll = job ? ++job->polls : 0;
  who->wake();  // ends an older long poll of that job, which would only hold a connection
  const double wait = std::min(call.wait, limits_.maxWaitSeconds);
  return getJob(std::move(who), call, loop_.now() + wait, poll);
}

Reply Service::info(const Call& call) {
  io::JsonWriter out;
  out.open('{').field("name", "obby-bridge").field("protocol", kProtocol);
  out.field("version", io::toolVersion()).field("needsToken", needToken_);
  out.field("pairing", pairing_ && *pairing_->closed(loop_.now()) == 0);
  if (call.client < 0) return {200, out.finish()};
  const std::shared_ptr<Client> who = client(call.client);
  out.field("session", session_).field("cursor", who->ring().last()).key("jobs").open('[');
  for (const Job* job : jobs_.of(*who)) {
    out.open('{').field("job", job->id()).field("state", nameOf(job->state())).close();
  }
  out.close().key("limits").open('{').field("bodyBytes", limits_.bodyBytes);
  out.field("inflatedBytes", limits_.inflatedBytes).field("messageBytes", limits_.messageBytes);
  out.field("ringBytes", limits_.ringBytes).field("jobs", limits_.jobs);
  out.field("waiting", limits_.waiting).field("pingSeconds", limits_.pingSeconds);
  out.field("silenceSeconds", limits_.silenceSeconds);
  out.field("graceSeconds", limits_.graceSeconds).close();
  out.key("tools").open('{').field("solve", !programs_.solve.empty());
  out.field("import", !programs_.import.empty());
  out.field("calibrate", !programs_.calibrate.empty());
  return {200, out.finish()};
}

std::optional<Reply> Service::closedTo(const Call& call) const {
  if (call.endpoint != Endpoint::pair) return {};
  const char* why =
      pairing_ ? pairing_->closed(loop_.now()) : "the bridge was started without --pair";
  if (*why == 0) return {};
  return refuse(403, why, "start obby-bridge --pair and send the code it shows");
}

Reply Service::pair(const std::string& body) {
  std::string code;
  const auto tree = io::JsonTree::parse(body);
  if (!tree) return refuse(400, tree.error());
  const Status read = forMembers(*tree, tree->root(), "",
                                 [&](std::string_view name, const io::JsonTree::Node& value) {
                                   if (name != "code")
                                     return Status(unknownMember("", name, {"code"}));
                                   auto text = jsonString(*tree, value, "code");
                                   if (!text) return Status(text.error());
                                   code = *std::move(text);
                                   return Status();
                                 });
  if (!read) return refuse(400, read.error());
  if (!pairing_->answer(code, loop_.now())) {
    return refuse(403, "wrong code", fmt::format("tries left: {}", pairing_->triesLeft()));
  }
  auto token = tokens_.add();
  if (!token) return refuse(507, token.error().text(), "free disk space, then pair again");
  return {200, io::JsonWriter().open('{').field("token", *token).finish()};
}

kj::Promise<Reply> Service::putLevel(std::string body) {
  if (programs_.import.empty()) {
    return refuse(501, "there is no obby-import next to obby-bridge", "install all of obby");
  }
  const std::string id = Store::idOf(body);
  if (const auto known = store_.get(id); known && *known) {
    std::vector<std::string> queries;
    for (const std::string& line : (*known)->queries) queries.push_back(queryIdOfLine(line));
    return levelReply(200, id, queries, (*known)->reports);
  }
  if (imports_ >= kImports)
    return refuse(503, "other levels are still being read", "try again later");
  imports_++;
  return importLevel(loop_, programs_.import, std::move(body), limits_)
      .then([this, id](Imported in) -> Reply {
        if (in.refusal.status != 200) return in.refusal;
        if (const Status kept = store_.put(id, in.lines, in.warnings); !kept) {
          return refuse(507, kept.error().text(),
                        "free disk space, or name another folder with --state-dir");
        }
        return levelReply(201, id, in.queries, in.warnings);
      })
      .attach(kj::defer([this] { imports_--; }));
}

Reply Service::getLevel(const Call& call) const {
  const auto level = store_.get(call.id);
  if (!level) return refuse(500, level.error());
  if (!*level) return refuse(404, "there is no level with this id", "send it to /v1/levels again");
  if (call.moving) {
    auto some = movingParts((*level)->levels);
    if (!some) return refuse(500, some.error());
    return {200, *std::move(some), "application/x-ndjson"};
  }
  std::string lines = (*level)->levels;
  for (const std::string& query : (*level)->queries) lines.append(query).append("\n");
  return {200, std::move(lines), "application/x-ndjson"};
}

Reply Service::cancelJob(Client& client, const std::string& id) {
  Job* job = jobs_.find(client, id);
  if (!job) return noSuchJob();
  jobs_.cancel(*job, "the client cancelled the job");
  job = jobs_.find(client, id);  // the limit of kept jobs may have removed it
  const JobState state = job ? job->state() : JobState::cancelled;
  return {202, io::JsonWriter().open('{').field("job", id).field("state", nameOf(state)).finish()};
}

std::optional<Reply> Service::checkSession(const Call& call) const {
  if (call.session.empty() || call.session == session_) return {};
  return refuse(410, "the bridge has restarted since this session began", kAskAgain);
}

std::optional<Reply> Service::checkCursor(const Call& call, const Client& client,
                                          uint64_t cursor) const {
  if (auto wrong = checkSession(call)) return wrong;
  if (cursor > client.ring().last())
    return refuse(410, "this cursor is ahead of the last message", kAskAgain);
  if (client.ring().reaches(cursor)) return {};
  return refuse(410, "messages after this cursor are no longer kept", kAskAgain);
}

kj::Promise<Reply> Service::getJob(std::shared_ptr<Client> client, Call call, double until,
                                   uint64_t poll) {
  // The session comes first, because jobs of an earlier bridge are unknown or different by now.
  if (auto wrong = checkSession(call)) return *std::move(wrong);
  const Job* job = jobs_.find(*client, call.id);
  if (!job) return noSuchJob();
  const uint64_t cursor = call.cursor.value_or(job->firstCursor());
  if (auto wrong = checkCursor(call, *client, cursor)) return *std::move(wrong);
  bool news = job->ended() || job->polls != poll || loop_.now() >= until;
  for (const Message* m = client->ring().after(cursor); m && !news;
       m = client->ring().after(m->number)) {
    news = m->job == job->number();
  }
  if (news) {
    client->lastSeen = lastSeen_ = loop_.now();
    return jobReply(*job, *client, cursor);
  }
  const auto left = uint64_t((until - loop_.now()) * 1000) + 1;
  auto woken = client->whenWoken().exclusiveJoin(loop_.timer.afterDelay(left * kj::MILLISECONDS));
  return woken.then(
      [this, client = std::move(client), call = std::move(call), until, poll]() mutable {
        return getJob(std::move(client), std::move(call), until, poll);
      });
}

Reply Service::jobReply(const Job& job, const Client& client, uint64_t cursor) const {
  io::JsonWriter messages;
  messages.open('[');
  const Message* m = client.ring().after(cursor);
  for (; m && messages.text().size() <= kMiB; m = client.ring().after(m->number)) {
    cursor = m->number;
    if (m->job == job.number()) messages.raw(m->text);
  }
  io::JsonWriter out;
  out.open('{').field("job", job.id()).field("state", nameOf(job.state()));
  out.field("session", session_).field("cursor", cursor).field("more", m != nullptr);
  return {200, out.key("messages").raw(messages.finish()).finish()};
}

std::variant<std::shared_ptr<Client>, Reply> Service::events(const Call& call) {
  std::shared_ptr<Client> who = client(call.client);
  const uint64_t cursor = call.cursor.value_or(who->ring().last());
  if (auto wrong = checkCursor(call, *who, cursor)) return *std::move(wrong);
  if (who->socketOpen) {
    return refuse(409, "this client already has a WebSocket", "close it, or poll /v1/jobs/ID");
  }
  return who;
}

std::string Service::hello(const Client& client, uint64_t cursor) const {
  io::JsonWriter out;
  out.open('{').field("type", "hello").field("protocol", kProtocol).field("session", session_);
  return out.field("cursor", cursor).field("last", client.ring().last()).finish();
}

void Service::sweep() {
  const double now = loop_.now();
  for (const auto& [number, who] : clients_) {
    // The client is connected, whether or not it sends requests.
    if (who->socketOpen) lastSeen_ = now;
    if (who->mayBeSilent) continue;
    const double silent = now - who->lastSeen;
    if (silent > limits_.silenceSeconds && who->socketOpen) {
      who->dropSocket = true;
      who->wake();
    }
    if (silent > limits_.silenceSeconds + limits_.graceSeconds) {
      jobs_.cancelAll(who.get(), "the client stopped responding");
    }
  }
  jobs_.boundTime();
  if (!jobs_.idle() || imports_ > 0) lastSeen_ = now;  // a client that waits for a level is silent
}

void Service::endEvents() {
  for (const auto& [number, who] : clients_) {
    who->ending = true;
    who->wake();
  }
}

double Service::quietFor() const { return loop_.now() - lastSeen_; }

}  // namespace obby::bridge
