#include "view/live_data.h"

#include <algorithm>
#include <utility>

#include "view/page_parts.h"

namespace obby::view {
namespace {

const char* nameOf(StreamState state) {
  switch (state) {
    case StreamState::open: return "live";
    case StreamState::ended: return "ended";
    case StreamState::broken: break;
  }
  return "broken";
}

// Returns the ticks of motion for a level whose trajectories still grow. The number doubles each
// time, so that the motion is sent only a few times.
uint32_t ticksAhead(const LevelEntry& level, uint32_t needed) {
  uint32_t ticks = minTicksShown(level);
  while (ticks < needed) ticks *= 2;
  return ticks;
}

std::string headOf(const Report& report, const Budget& budget, StreamState state) {
  io::JsonWriter json;
  json.open('{').field("state", nameOf(state)).field("title", report.title());
  json.key("notes");
  writeNotes(json, report, budget);
  return json.finish();
}

bool shown(const PathEntry& path, const Budget& budget) {
  const bool attempt = path.kind == PathKind::attempt;
  return path.played() && !(attempt && path.serial % budget.attemptsOneOf != 0);
}

// Compresses ascending serials to ranges: 1 2 3 7 8 to [1, 3] [7, 8].
std::vector<std::pair<uint64_t, uint64_t>> rangesOf(const auto& bySerial) {
  std::vector<std::pair<uint64_t, uint64_t>> out;
  for (const auto& [serial, piece] : bySerial) {
    if (out.empty() || out.back().second + 1 != serial) out.emplace_back(serial, serial);
    out.back().second = serial;
  }
  return out;
}

}  // namespace

bool LiveData::put(Piece& piece, std::string json) const {
  if (piece.revision != 0 && piece.json == json) return false;
  piece = {next_, std::move(json)};
  return true;
}

void LiveData::thin(const Report& report) {
  PageSizes sizes;
  const std::vector<uint32_t> needed = ticksShown(report);
  levels_.resize(report.levels.size());
  for (size_t i = 0; i < levels_.size(); ++i) {
    LevelPiece& level = levels_[i];
    const uint32_t ticks = ticksAhead(report.levels[i], needed[i]);
    if (ticks != level.ticks) {
      level.ticks = ticks;
      level.stride = 0;
      level.sizes = {};
      level.sizes.add(report.levels[i], ticks);
    }
    sizes.fixed += level.sizes.fixed;
    sizes.tracks += level.sizes.tracks;
    sizes.longMotion = sizes.longMotion || level.sizes.longMotion;
  }
  for (const QueryEntry& query : report.queries) sizes.add(query);
  budget_ = budgetFor(sizes, options_.full ? kPageLimit : kPageTarget, std::move(budget_));
}

void LiveData::takeLevels(const Report& report) {
  for (size_t i = 0; i < levels_.size(); ++i) {
    LevelPiece& level = levels_[i];
    const bool moves = level.sizes.tracks > 0;
    const bool stale = level.revision == 0 || (moves && level.stride != budget_.trackStride);
    level.stride = budget_.trackStride;
    if (!stale) continue;
    io::JsonWriter json;
    writeLevel(json, report.levels[i], level.ticks, level.stride);
    put(level, json.finish());
  }
}

void LiveData::takeQuery(const QueryEntry& entry, QueryPieces& out) {
  io::JsonWriter facts;
  facts.open('{');
  writeQueryFacts(facts, entry);
  bool changed = put(out.facts, facts.finish());
  std::map<uint64_t, Piece> before = std::exchange(out.paths, {});
  const bool thinner = out.attemptStride != budget_.attemptStride;
  out.attemptStride = budget_.attemptStride;
  for (const PathEntry& path : entry.paths) {
    if (!shown(path, budget_)) continue;
    const bool attempt = path.kind == PathKind::attempt;
    Piece& piece = out.paths[path.serial];
    const auto known = before.find(path.serial);
    if (known != before.end() && !(attempt && thinner)) {
      piece = std::move(known->second);
      continue;
    }
    io::JsonWriter json;
    writePath(json, path, attempt ? budget_.attemptStride : 1);
    changed = put(piece, json.finish()) || changed;
  }
  auto ranges = rangesOf(out.paths);
  changed = changed || ranges != out.ranges;
  out.ranges = std::move(ranges);
  if (changed) out.changed = next_;
}

void LiveData::take(const Report& report, StreamState state) {
  next_ = revision_ + 1;
  thin(report);
  put(head_, headOf(report, budget_, state));
  takeLevels(report);
  queries_.resize(report.queries.size());
  for (size_t i = 0; i < queries_.size(); ++i) takeQuery(report.queries[i], queries_[i]);
  const auto isNew = [this](const auto& each) { return each.revision == next_; };
  const bool changed =
      isNew(head_) || std::ranges::any_of(levels_, isNew) ||
      std::ranges::any_of(queries_, [this](const auto& query) { return query.changed == next_; });
  if (changed) revision_ = next_;
}

void LiveData::writeQuery(io::JsonWriter& json, size_t index, uint64_t revision) const {
  const QueryPieces& query = queries_[index];
  json.open('{').field("index", index).key("facts").raw(query.facts.json);
  json.key("serials").open('[');
  for (const auto& [first, last] : query.ranges) {
    json.open('[').value(first).value(last).close();
  }
  json.close().key("trajectories").open('[');
  for (const auto& [serial, piece] : query.paths) {
    if (piece.revision <= revision) continue;
    json.open('{').field("serial", serial).key("data").raw(piece.json).close();
  }
  json.close().close();
}

std::string LiveData::since(uint64_t revision) const {
  if (revision > revision_) revision = 0;
  io::JsonWriter json;
  json.open('{').field("format", kPageFormat).field("revision", revision_);
  json.field("generator", options_.generator).key("head");
  json.raw(revision_ == 0 ? R"({"state":"live","title":"","notes":[]})" : head_.json);
  json.key("levels").open('[');
  for (size_t i = 0; i < levels_.size(); ++i) {
    if (levels_[i].revision <= revision) continue;
    json.open('{').field("index", i).key("data").raw(levels_[i].json).close();
  }
  json.close().key("queries").open('[');
  for (size_t i = 0; i < queries_.size(); ++i) {
    if (queries_[i].changed > revision) writeQuery(json, i, revision);
  }
  return json.finish();
}

}  // namespace obby::view
