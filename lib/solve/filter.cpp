#include "solve/filter.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/resolve_places.h"
#include "solve/players/verify_player.h"

namespace obby::solve {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += fmt::format("{}'{}'", text.empty() ? "" : ", ", word);
  return text;
}

// Builds and compiles a query, so that --on-error applies to an invalid one before any record is
// written.
Result<io::Record> queryOf(const LoadedLevel& level, const QuickQuery& quick, const char* id) {
  OBBY_ASSIGN(io::Record query, buildQuery(level.record.reader().getLevel(), quick, id));
  OBBY_RETURN_IF_ERROR(level::Query::compile(query.reader().getQuery(), level.level));
  return query;
}

}  // namespace

Filter::Filter(FilterOptions options, io::Pipeline& pipeline)
    : options_(std::move(options)),
      pipeline_(pipeline),
      pool_(options_.threads),
      levels_(options_.levelBytes),
      queries_(options_.queryBytes) {
  options_.solver.earlier = &options_.earlier;
}

Result<io::Then> Filter::handle(const io::Record& record) {
  switch (record.which()) {
    case io::Kind::PARAMS: physics_.know(record); return io::Then::pass;
    case io::Kind::LEVEL: return handleLevel(record);
    case io::Kind::QUERY: return handleQuery(record);
    case io::Kind::TRAJECTORY: return handleTrajectory(record.reader().getTrajectory());
    default: return io::Then::pass;
  }
}

// Passes on the level with its physics changed, so that later tools replay with the same physics.
Result<io::Then> Filter::handleLevel(const io::Record& read) {
  OBBY_RETURN_IF_ERROR(finishLevel());
  last_.reset();
  // If the new level is invalid, its queries must not go to an older level of its name.
  levels_.forget(read.reader().getLevel().getName());
  if (!physics_.known()) return take(read, read);
  const io::Record calibrated = physics_.applied(read);
  OBBY_ASSIGN(const io::Then then, take(calibrated, read));
  if (then == io::Then::pass) OBBY_RETURN_IF_ERROR(pipeline_.output().pass(calibrated));
  return io::Then::drop;
}

Result<io::Then> Filter::take(const io::Record& played, const io::Record& read) {
  OBBY_ASSIGN(LoadedLevel loaded, loadLevel(played));
  // This comes first: a level that lacks the places of the rule must not be added.
  if (options_.task == Task::filter) {
    OBBY_ASSIGN(PassFilter filter,
                PassFilter::make(played.reader().getLevel(), loaded.level, options_.passes));
    passFilters_.insert_or_assign(loaded.level.name(), std::move(filter));
  }
  const auto level = std::make_shared<const LoadedLevel>(std::move(loaded));
  const bool now =
      asksQuick() && (!options_.quick->goals.empty() || hasEnd(played.reader().getLevel()));
  last_ = Last{level, read, now};
  know(level);
  if (!now) return io::Then::pass;
  OBBY_ASSIGN(const io::Record query, queryOf(*level, *options_.quick, "command-line"));
  OBBY_RETURN_IF_ERROR(pipeline_.output().pass(played));
  OBBY_RETURN_IF_ERROR(ask(*level, query));
  return io::Then::drop;
}

Result<io::Then> Filter::handleQuery(const io::Record& record) {
  const auto query = record.reader().getQuery();
  if (options_.task != Task::answer) note(query.getId());
  if (options_.task == Task::filter) return io::Then::pass;
  OBBY_ASSIGN(const LevelPointer level, levelNamed(query.getLevel()));
  if (last_ && level == last_->level) ++last_->queries;
  if (asksQuick()) return io::Then::pass;  // the command line's query replaces those of the stream
  OBBY_ASSIGN(const io::Record full, resolved(*level, record));
  if (options_.task == Task::verify) {
    // The verifier relies on a valid record.
    if (wanted(query.getId())) {
      OBBY_RETURN_IF_ERROR(level::Query::compile(full.reader().getQuery(), level->level));
    }
    queries_.add(level->level.name(), full);
    return io::Then::pass;
  }
  note(query.getId());
  if (!wanted(query.getId())) return io::Then::pass;
  // --on-error applies to an invalid query before it is written.
  OBBY_RETURN_IF_ERROR(level::Query::compile(full.reader().getQuery(), level->level));
  OBBY_RETURN_IF_ERROR(ask(*level, full));
  return io::Then::drop;
}

// Returns true if the command line's query replaces those of the stream.
bool Filter::asksQuick() const {
  return options_.quick && !options_.each && options_.task == Task::answer;
}

Result<Filter::LevelPointer> Filter::levelNamed(const std::string& name) const {
  if (name.empty() && last_) return last_->level;
  return levels_.named(name);
}

// Adds a level. Also drops the filters and queries of the levels that it displaces.
void Filter::know(const LevelPointer& level) {
  for (const std::string& dropped : levels_.add(level)) {
    passFilters_.erase(dropped);
    queries_.forgetLevel(dropped);
  }
}

Result<io::Record> Filter::resolved(const LoadedLevel& level, const io::Record& query) const {
  if (options_.quick && options_.each) {
    return changeQuery(level.record.reader().getLevel(), *options_.quick, query);
  }
  if (!level::namesParts(query.reader().getQuery())) return query;
  io::RecordBuilder copy(query.reader());
  OBBY_RETURN_IF_ERROR(
      level::resolvePlaces(level.record.reader().getLevel(), copy.root().getQuery()));
  return io::Record(std::move(copy));
}

bool Filter::wanted(const std::string& id) const {
  const std::vector<std::string>& only = options_.only;
  return only.empty() || std::find(only.begin(), only.end(), id) != only.end();
}

// Notes each id once. Ids that are not in `only` are noted up to the number that an error lists,
// since a stream need not end.
void Filter::note(const std::string& id) {
  constexpr size_t kMaxOthers = 5;
  if (options_.only.empty()) return;
  const bool isOther = !wanted(id);
  std::vector<std::string>& ids = isOther ? others_ : met_;
  if (isOther && ids.size() == kMaxOthers) return;
  if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
}

Status Filter::answer(const LoadedLevel& level, schema::Query::Reader query) {
  bool first = true;
  const auto write = [&](schema::Record::Reader r) -> Status {
    if (options_.remember && r.isTrajectory()) {
      OBBY_RETURN_IF_ERROR(remember(r.getTrajectory(), first));
      first = false;
    }
    return pipeline_.write(r);
  };
  const SolverOutput output{write, options_.progress, options_.deviceFailed};
  OBBY_ASSIGN(const QueryAnswer a,
              solveQuery(level, query, options_.solver, {pool_, options_.device}, output));
  if (options_.answered) options_.answered(level.level.name(), query.getId(), a.verdict);
  switch (a.verdict) {
    case schema::Verdict::SOLVED: ++counts_.solved; return {};
    case schema::Verdict::UNREACHABLE: ++counts_.unreachable; return {};
    case schema::Verdict::UNKNOWN: ++counts_.unknown; break;
  }
  if (a.stopped != Stopped::interrupted) pipeline_.outOfBudget();
  return {};
}

// The first trajectory of an answer replaces those of the previous answer.
Status Filter::remember(schema::Trajectory::Reader trajectory, bool first) {
  if (first) options_.earlier.forget(trajectory.getLevel(), trajectory.getQuery());
  return options_.earlier.note(trajectory);
}

Status Filter::ask(const LoadedLevel& level, const io::Record& query) {
  const io::Record full = withPlayers(level.record.reader().getLevel(), options_.players, query);
  OBBY_RETURN_IF_ERROR(pipeline_.output().pass(full));
  const Status answered = answer(level, full.reader().getQuery());
  levels_.weigh(level.level.name());
  return answered;
}

// The default query is asked after the level's other records, but its error is reported for the
// level.
Status Filter::finishLevel() {
  Status asked = askDefault();
  return asked ? asked : pipeline_.forgiveLate(last_->read, std::move(asked).error());
}

Status Filter::askDefault() {
  if (!last_ || last_->asked || options_.task != Task::answer || !options_.only.empty()) return {};
  last_->asked = true;
  if (asksQuick()) {
    return lacksGoal(last_->level->record.reader().getLevel(), *options_.quick, last_->queries);
  }
  if (last_->queries > 0) return {};
  const QuickQuery quick = options_.quick.value_or(QuickQuery{});
  OBBY_ASSIGN(const io::Record query, queryOf(*last_->level, quick, "whole"));
  return ask(*last_->level, query);
}

Status Filter::finishInput() {
  OBBY_RETURN_IF_ERROR(finishLevel());
  for (const std::string& id : options_.only) {
    if (std::find(met_.begin(), met_.end(), id) != met_.end()) continue;
    return Error{{},
                 {},
                 "--query",
                 fmt::format("the stream has no query '{}'", id),
                 others_.empty() ? "it has no queries at all" : "it has " + joined(others_)};
  }
  return {};
}

Result<io::Then> Filter::handleTrajectory(schema::Trajectory::Reader trajectory) {
  if (!wanted(trajectory.getQuery())) return io::Then::pass;
  if (options_.task == Task::verify) OBBY_RETURN_IF_ERROR(check(trajectory));
  if (options_.task != Task::filter) return io::Then::pass;
  OBBY_ASSIGN(const bool kept, keeps(trajectory));
  ++(kept ? counts_.kept : counts_.dropped);
  return kept ? io::Then::pass : io::Then::drop;
}

Result<bool> Filter::keeps(schema::Trajectory::Reader trajectory) {
  OBBY_ASSIGN(const LevelPointer level, levelNamed(trajectory.getLevel()));
  OBBY_ASSIGN(const level::Player player, level::playerOf(trajectory));
  OBBY_ASSIGN(const LoadedLevel* const played, level->players->of(*level, player));
  return passFilters_.at(level->level.name()).keeps(played->level, trajectory);
}

Status Filter::check(schema::Trajectory::Reader trajectory) {
  OBBY_ASSIGN(const LevelPointer level, levelNamed(trajectory.getLevel()));
  OBBY_ASSIGN(const io::Record query, queries_.named(level->level.name(), trajectory.getQuery()));
  OBBY_RETURN_IF_ERROR(verifyPlayer(*level, query.reader().getQuery(), trajectory));
  ++counts_.verified;
  return {};
}

}  // namespace obby::solve
