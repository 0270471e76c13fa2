// Assigns records to queries and levels.
#include "view/report.h"

#include <capnp/any.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "level/resolve_places.h"

namespace obby::view {

namespace {

// Returns the id of the query that a record is or belongs to.
std::string queryOf(const io::Record& record) {
  switch (record.which()) {
    case io::Kind::QUERY: return record.reader().getQuery().getId();
    case io::Kind::RESULT: return record.reader().getResult().getQuery();
    case io::Kind::TRAJECTORY: return record.reader().getTrajectory().getQuery();
    case io::Kind::PROGRESS: return record.reader().getProgress().getQuery();
    default: return "";
  }
}

}  // namespace

Status Collector::addLevel(const io::Record& record) {
  current_ = -1;
  auto compiled = level::Level::compile(record.reader().getLevel());
  if (!compiled) return forgive_(record, std::move(compiled).error());
  auto level = std::make_shared<const level::Level>(*std::move(compiled));
  // The same level may come again in a concatenated stream; its queries are merged.
  const int next = int(report_.levels.size());
  const auto [at, fresh] = levels_.try_emplace({level->name(), level->hash()}, next);
  current_ = at->second;
  if (!fresh) return {};
  lastNamed_[level->name()] = current_;
  report_.levels.push_back({record, std::move(level)});
  if (report_.levels.size() > 1) weigh(report_.levels.back());
  return {};
}

int Collector::levelNamed(const std::string& name) const {
  if (name.empty()) return current_;
  if (current_ >= 0 && report_.levels[size_t(current_)].level->name() == name) return current_;
  const auto last = lastNamed_.find(name);
  return last == lastNamed_.end() ? -1 : last->second;
}

QueryEntry& Collector::queryNamed(const std::string& id, int level) {
  const auto [at, fresh] = byName_.try_emplace({level, id}, report_.queries.size());
  if (fresh) {
    report_.queries.emplace_back();
    report_.queries.back().id = id;
    report_.queries.back().level = level;
  }
  touched_.insert(at->second);
  return report_.queries[at->second];
}

bool Collector::wanted(const io::Record& record) const {
  if (only_.empty()) return true;
  const std::string id = queryOf(record);
  return std::find(only_.begin(), only_.end(), id) != only_.end();
}

Status Collector::add(const io::Record& record) {
  if (!record.known()) return {};
  if (record.which() == io::Kind::LEVEL) return full() ? Status() : addLevel(record);
  if (!wanted(record) || full()) return {};
  switch (record.which()) {
    case io::Kind::QUERY: addQuery(record); return {};
    case io::Kind::RESULT: {
      const auto result = record.reader().getResult();
      QueryEntry& entry = queryNamed(result.getQuery(), levelNamed(result.getLevel()));
      entry.result = record;
      entry.progress.reset();  // the progress holds trajectories of a finished search
      entry.weighed = false;
      return {};
    }
    case io::Kind::TRAJECTORY: {
      const auto path = record.reader().getTrajectory();
      const bool solved = path.getOutcome() == schema::Outcome::GOAL;
      addPath(queryNamed(path.getQuery(), levelNamed(path.getLevel())),
              {solved ? PathKind::solution : PathKind::attempt, record, {}});
      return {};
    }
    case io::Kind::PROGRESS: addProgress(record); return {};
    default: return {};
  }
}

void Collector::addQuery(const io::Record& record) {
  const auto query = record.reader().getQuery();
  QueryEntry& entry = queryNamed(query.getId(), levelNamed(query.getLevel()));
  // The same record may come again in a concatenated stream.
  if (entry.query && capnp::toAny(entry.reader()) == capnp::toAny(query)) return;
  entry.query = record;
  entry.weighed = false;
  entry.compiled.reset();
  // Trajectories that came before their query were played without its regions and limits.
  for (PathEntry& path : entry.paths) {
    forget(path);
    path.serial = ++serial_;
  }
}

void Collector::addProgress(const io::Record& record) {
  const auto progress = record.reader().getProgress();
  if (!progress.hasSolution() && !progress.hasBest()) return;
  const auto of = progress.hasSolution() ? progress.getSolution() : progress.getBest();
  QueryEntry& entry = queryNamed(progress.getQuery(), levelNamed(of.getLevel()));
  if (progress.hasSolution()) addFirstSolution(entry, record);
  if (progress.hasBest()) addAttempts(entry, record);
}

// The record says nothing else about the search, so the latest progress stays.
void Collector::addFirstSolution(QueryEntry& entry, const io::Record& record) {
  PathEntry first{PathKind::solution, record, {}};
  const auto before = std::ranges::find_if(entry.paths, &PathEntry::provisional);
  if (before != entry.paths.end()) {
    if (capnp::toAny(before->reader()) == capnp::toAny(first.reader())) return;
    forget(*before);
    entry.paths.erase(before);
  }
  addPath(entry, std::move(first));
}

// Keeps only the latest progress of a query, which supersedes earlier ones.
void Collector::addAttempts(QueryEntry& entry, const io::Record& record) {
  const auto progress = record.reader().getProgress();
  entry.progress = record;
  entry.weighed = false;
  const auto kept = std::stable_partition(
      entry.paths.begin(), entry.paths.end(),
      [](const PathEntry& path) { return !path.ofProgress() || path.provisional(); });
  std::vector<PathEntry> before(std::make_move_iterator(kept),
                                std::make_move_iterator(entry.paths.end()));
  entry.paths.erase(kept, entry.paths.end());
  // A trajectory that the previous progress contained is not replayed.
  const auto put = [&](PathKind kind, uint32_t death) {
    PathEntry path{kind, record, {}, death};
    const auto same = std::ranges::find_if(before, [&](const PathEntry& old) {
      return old.kind == kind && old.serial != 0 &&
             capnp::toAny(old.reader()) == capnp::toAny(path.reader());
    });
    if (same == before.end()) return addPath(entry, std::move(path));
    path.playback = std::move(same->playback);
    path.serial = std::exchange(same->serial, 0);
    entry.paths.push_back(std::move(path));
  };
  put(PathKind::closest, 0);
  if (progress.hasNewest()) put(PathKind::newest, 0);
  for (uint32_t i = 0; i < progress.getDeaths().size(); ++i) put(PathKind::attempt, i);
  for (PathEntry& path : before) forget(path);
}

void Collector::addPath(QueryEntry& entry, PathEntry path) {
  path.serial = ++serial_;
  entry.paths.push_back(std::move(path));
}

Status Collector::compile(QueryEntry& entry) {
  if (!entry.query || entry.compiled) return {};
  const io::Record asRead = *entry.query;  // the original, because the record changes below
  const auto refuse = [&](Error error) {
    entry.query.reset();
    return forgive_(asRead, std::move(error));
  };
  if (entry.level < 0) {
    Error error =
        makeError("the level of this query is not in the stream", "put the level before it");
    error.path = "level";
    return refuse(std::move(error));
  }
  if (level::namesParts(entry.reader())) {
    io::RecordBuilder copy(entry.query->reader());
    const auto level = report_.levels[size_t(entry.level)].record.reader().getLevel();
    if (Status status = level::resolvePlaces(level, copy.root().getQuery()); !status) {
      return refuse(std::move(status).error());
    }
    entry.query = io::Record(std::move(copy));
  }
  auto compiled = level::Query::compile(entry.reader(), *report_.levels[size_t(entry.level)].level);
  if (!compiled) return refuse(std::move(compiled).error());
  entry.compiled = std::make_shared<const level::Query>(*std::move(compiled));
  return {};
}

Status Collector::replay(QueryEntry& entry) {
  // An answer supersedes the trajectories of its search's progress.
  const auto any = [&](auto&& holds) { return std::ranges::any_of(entry.paths, holds); };
  const bool solved = any([](const PathEntry& p) { return p.kind == PathKind::solution; });
  const bool answered = any([](const PathEntry& p) { return !p.ofProgress(); });
  const bool improved =
      any([](const PathEntry& p) { return p.kind == PathKind::solution && !p.provisional(); });
  const auto outdated = [&](const PathEntry& p) {
    if (p.provisional()) return improved;
    return p.ofProgress() && (p.kind == PathKind::closest ? solved : answered);
  };
  for (PathEntry& path : entry.paths) {
    if (outdated(path)) forget(path);
  }
  std::erase_if(entry.paths, outdated);
  // Sorting thousands takes a while, and a live stream updates after each record.
  const auto before = [](const PathEntry& a, const PathEntry& b) { return a.kind < b.kind; };
  if (!std::is_sorted(entry.paths.begin(), entry.paths.end(), before)) {
    std::stable_sort(entry.paths.begin(), entry.paths.end(), before);
  }
  Status first;
  for (PathEntry& path : entry.paths) {
    Status status = path.played() || path.dropped ? Status() : play(entry, path);
    if (!status) status = forgive_(path.record, std::move(status).error());
    if (first) first = std::move(status);
  }
  std::erase_if(entry.paths, [](const PathEntry& path) { return !path.played(); });
  return first;
}

// Attempts over the budget stay unplayed.
Status Collector::play(const QueryEntry& entry, PathEntry& path) {
  if (entry.level < 0) {
    return makeError("the level of this trajectory is not in the stream",
                     "view the stream that holds the level, too");
  }
  const LevelEntry& level = report_.levels[size_t(entry.level)];
  OBBY_ASSIGN(PlayerReplays::Replayed replayed,
              players_.play(level, entry.level, entry, path.reader()));
  Playback playback = std::move(replayed.playback);
  path.resampled = std::move(replayed.record);
  const size_t cost = costOf(path, playback);
  if (!fits(cost) && budget_.rolls) evictFor(cost, path.kind);
  if (fits(cost)) {
    keep(path, std::move(playback));
    return {};
  }
  if (path.kind == PathKind::solution) {
    return makeError("the trajectories are too long to show together",
                     "show one query with --query ID");
  }
  if (!attemptsNoted_) {
    note("Some attempts are left out because earlier ones fill the memory budget.");
  }
  attemptsNoted_ = true;
  return {};
}

Status Collector::update() {
  Status first;
  for (const size_t index : std::exchange(touched_, {})) {
    for (Status status : {compile(report_.queries[index]), replay(report_.queries[index])}) {
      if (first) first = std::move(status);
    }
    weigh(report_.queries[index]);
  }
  sweepDropped();
  return first;
}

Status Collector::checkChosen() const {
  for (const std::string& id : only_) {
    const bool found = std::any_of(report_.queries.begin(), report_.queries.end(),
                                   [&](const QueryEntry& entry) { return entry.id == id; });
    if (!found) return makeError(fmt::format("the input has no query \"{}\"", id));
  }
  return {};
}

}  // namespace obby::view
