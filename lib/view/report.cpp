// Which record belongs to which query and level.
#include "view/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/resolve_places.h"

namespace obby::view {

namespace {

bool ofProgress(const PathEntry& path) { return path.record.which() == io::Kind::PROGRESS; }

}  // namespace

schema::Trajectory::Reader PathEntry::reader() const {
  if (!ofProgress(*this)) return record.reader().getTrajectory();
  const auto progress = record.reader().getProgress();
  switch (kind) {
    case PathKind::closest: return progress.getBest();
    case PathKind::newest: return progress.getNewest();
    default: return progress.getDeaths()[death];
  }
}

bool QueryEntry::mismatch() const {
  return std::any_of(paths.begin(), paths.end(), [](const PathEntry& path) {
    return path.kind == PathKind::solution && !path.playback.mismatch.empty();
  });
}

std::string Report::title() const {
  if (levels.empty()) return "obby report";
  std::string title = levels.front().level->name();
  if (title.empty()) title = "Level";
  if (levels.size() > 1) title += fmt::format(" and {} more", levels.size() - 1);
  return title;
}

Status Collector::addLevel(const io::Record& record) {
  auto compiled = level::Level::compile(record.reader().getLevel());
  if (!compiled) return forgive_(record, std::move(compiled).error());
  auto level = std::make_shared<const level::Level>(*std::move(compiled));
  // The same level again, from a concatenated stream: its queries go together.
  const int known = report_.levels.empty() ? -1 : levelNamed(level->name());
  if (known >= 0 && report_.levels[size_t(known)].level->name() == level->name() &&
      report_.levels[size_t(known)].level->hash() == level->hash()) {
    return {};
  }
  report_.levels.push_back({record, std::move(level)});
  return {};
}

int Collector::levelNamed(const std::string& name) const {
  for (size_t i = report_.levels.size(); i-- > 0;) {
    if (name.empty() || report_.levels[i].level->name() == name) return int(i);
  }
  return -1;
}

QueryEntry& Collector::queryNamed(const std::string& id, int level) {
  const auto [at, fresh] = byName_.try_emplace({level, id}, report_.queries.size());
  if (fresh) {
    report_.queries.emplace_back();
    report_.queries.back().id = id;
    report_.queries.back().level = level;
  }
  return report_.queries[at->second];
}

Status Collector::add(const io::Record& record) {
  if (!record.known()) return {};
  switch (record.which()) {
    case io::Kind::LEVEL: return addLevel(record);
    case io::Kind::QUERY: {
      const auto query = record.reader().getQuery();
      queryNamed(query.getId(), levelNamed(query.getLevel())).query = record;
      return {};
    }
    case io::Kind::RESULT: {
      const auto result = record.reader().getResult();
      queryNamed(result.getQuery(), levelNamed(result.getLevel())).result = record;
      return {};
    }
    case io::Kind::TRAJECTORY: {
      const auto path = record.reader().getTrajectory();
      const bool solved = path.getOutcome() == schema::Outcome::GOAL;
      queryNamed(path.getQuery(), levelNamed(path.getLevel()))
          .paths.push_back({solved ? PathKind::solution : PathKind::attempt, record, {}});
      return {};
    }
    case io::Kind::PROGRESS: addProgress(record); return {};
    default: return {};
  }
}

// Only the last one of a query: it knows more than those before.
void Collector::addProgress(const io::Record& record) {
  const auto progress = record.reader().getProgress();
  if (!progress.hasBest()) return;
  auto& paths = queryNamed(progress.getQuery(), levelNamed(progress.getBest().getLevel())).paths;
  std::erase_if(paths, ofProgress);
  paths.push_back({PathKind::closest, record, {}});
  if (progress.hasNewest()) paths.push_back({PathKind::newest, record, {}});
  for (uint32_t i = 0; i < progress.getDeaths().size(); ++i) {
    paths.push_back({PathKind::attempt, record, {}, i});
  }
}

Status Collector::compile(QueryEntry& entry) {
  if (!entry.query) return {};
  if (entry.level < 0) {
    Error error = makeError("the stream holds no level for this query", "put the level before it");
    error.path = "level";
    const io::Record record = *std::exchange(entry.query, std::nullopt);
    return forgive_(record, std::move(error));
  }
  if (level::namesParts(entry.reader())) {
    io::RecordBuilder copy(entry.query->reader());
    const auto level = report_.levels[size_t(entry.level)].record.reader().getLevel();
    if (Status status = level::resolvePlaces(level, copy.root().getQuery()); !status) {
      const io::Record record = *std::exchange(entry.query, std::nullopt);
      return forgive_(record, std::move(status).error());
    }
    entry.query = io::Record(std::move(copy));
  }
  auto compiled = level::Query::compile(entry.reader(), *report_.levels[size_t(entry.level)].level);
  if (!compiled) {
    const io::Record record = *std::exchange(entry.query, std::nullopt);
    return forgive_(record, std::move(compiled).error());
  }
  entry.compiled = std::make_shared<const level::Query>(*std::move(compiled));
  return {};
}

Status Collector::replay(QueryEntry& entry) {
  // An answer says more than what was known on the way to it.
  const auto any = [&](auto&& holds) { return std::ranges::any_of(entry.paths, holds); };
  const bool solved = any([](const PathEntry& p) { return p.kind == PathKind::solution; });
  const bool answered = any([](const PathEntry& p) { return !ofProgress(p); });
  std::erase_if(entry.paths, [&](const PathEntry& p) {
    return ofProgress(p) && (p.kind == PathKind::closest ? solved : answered);
  });
  std::stable_sort(entry.paths.begin(), entry.paths.end(),
                   [](const PathEntry& a, const PathEntry& b) { return a.kind < b.kind; });
  std::vector<PathEntry> kept;
  for (PathEntry& path : entry.paths) {
    Result<Playback> playback = makeError("the stream holds no level for this trajectory",
                                          "view the stream that holds the level too");
    if (entry.level >= 0) {
      playback =
          playBack(*report_.levels[size_t(entry.level)].level, entry.compiled.get(), path.reader());
    }
    if (!playback) {
      OBBY_RETURN_IF_ERROR(forgive_(path.record, std::move(playback).error()));
      continue;
    }
    path.playback = *std::move(playback);
    kept.push_back(std::move(path));
  }
  entry.paths = std::move(kept);
  return {};
}

Status Collector::select(const std::vector<std::string>& only) {
  for (const std::string& id : only) {
    const bool found = std::any_of(report_.queries.begin(), report_.queries.end(),
                                   [&](const QueryEntry& entry) { return entry.id == id; });
    if (!found) return makeError(fmt::format("there is no query \"{}\" in the input", id));
  }
  if (only.empty()) return {};
  std::erase_if(report_.queries, [&](const QueryEntry& entry) {
    return std::find(only.begin(), only.end(), entry.id) == only.end();
  });
  return {};
}

Result<Report> Collector::finish(const std::vector<std::string>& only) {
  OBBY_RETURN_IF_ERROR(select(only));
  for (QueryEntry& entry : report_.queries) {
    OBBY_RETURN_IF_ERROR(compile(entry));
    OBBY_RETURN_IF_ERROR(replay(entry));
  }
  return std::move(report_);
}

}  // namespace obby::view
