#include "train/level_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/random.h"
#include "io/compact.h"
#include "level/resolve_places.h"

namespace obby::train {

namespace {

// The choice within a turn follows from the turn's number, not from the learner's seed.
constexpr uint64_t kChoiceSeed = 0x7475726e;

constexpr size_t kHolder = 512;  // estimated overhead of a record, bytes

size_t bytesOf(const io::Record& record) { return io::compactBytes(record) + kHolder; }

// Returns the query, with the boxes of the parts that it names.
Result<io::Record> withPlaces(const io::Record& level, const io::Record& query) {
  if (!level::namesParts(query.reader().getQuery())) return query;
  io::RecordBuilder copy(query.reader());
  OBBY_RETURN_IF_ERROR(level::resolvePlaces(level.reader().getLevel(), copy.root().getQuery()));
  return io::Record(std::move(copy));
}

Result<std::shared_ptr<const TrainingLevel>> compile(const io::Record& level,
                                                     const io::Record& query) {
  return TrainingLevel::make(level.reader().getLevel(), query.reader().getQuery());
}

}  // namespace

LevelStream::LevelStream(io::SourceOptions options, const LevelStreamSettings& settings)
    : reader_(std::move(options), settings) {}

Result<std::shared_ptr<const TrainingLevel>> LevelStream::level(uint64_t index,
                                                                float hardest) const {
  std::optional<Item> item;
  {
    const std::lock_guard hold(lock_);
    reader_.forget(past_);
    OBBY_RETURN_IF_ERROR(reader_.readTo(index));
    uint64_t number = index;
    if (number >= reader_.read) {
      const bool broken = !reader_.ended;  // ended by `options.stop`
      if (broken || !reader_.settings.again) return Playable();
      number %= reader_.kept;
    }
    const auto found = reader_.turns.find(number);
    if (found == reader_.turns.end())
      return makeError(fmt::format("level {} of the stream is no longer in memory", number));
    item = chosen(found->second, index, hardest);
    reader_.played(number, found->second, *item);
  }
  if (item->compiled) return item->compiled;
  auto compiled = compile(item->level, item->query);
  if (!compiled) compiled.error().input = reader_.inputName;
  return compiled;
}

std::string LevelStream::nameOf(const std::vector<std::string>& inputs) {
  if (inputs.empty()) return {};
  const std::string first = inputs[0] == "-" ? "stdin" : inputs[0];
  return inputs.size() == 1 ? first : fmt::format("{} and {} more", first, inputs.size() - 1);
}

const LevelStream::Item& LevelStream::chosen(const Turn& turn, uint64_t index, float hardest) {
  std::vector<const Item*> ready;
  for (const Item& item : turn) {
    if (item.difficulty() <= hardest) ready.push_back(&item);
  }
  if (!ready.empty()) return *ready[Random(kChoiceSeed, index).below(uint32_t(ready.size()))];
  return *std::min_element(turn.begin(), turn.end(), [](const Item& a, const Item& b) {
    return a.difficulty() < b.difficulty();
  });
}

size_t LevelStream::compiledOf(const Turn& turn) {
  return size_t(std::count_if(turn.begin(), turn.end(),
                              [](const Item& item) { return item.compiled != nullptr; }));
}

io::SourceSummary LevelStream::summary() const {
  const std::lock_guard hold(lock_);
  io::SourceSummary out = reader_.source.summary();
  out.add(reader_.settings.before);
  return out;
}

size_t LevelStream::compiledOnReading() const {
  const std::lock_guard hold(lock_);
  return reader_.compiledOnReading;
}

size_t LevelStream::compiledHeld() const {
  const std::lock_guard hold(lock_);
  size_t held = compiledOf(reader_.open);
  for (const auto& [index, turn] : reader_.turns) held += compiledOf(turn);
  return held;
}

// level() holds the lock while it waits for the stream, so this must not block: on a GPU other
// levels are played meanwhile.
void LevelStream::past(uint64_t index) const {
  uint64_t before = past_;
  while (before < index && !past_.compare_exchange_weak(before, index)) {
  }
  const std::unique_lock hold(lock_, std::try_to_lock);
  if (hold) reader_.forget(past_);
}

void LevelStream::end() const {
  if (reader_.settings.timeout != nullptr) reader_.settings.timeout->end();
}

// Stops reading at an error, because indices of later levels would be wrong.
Status LevelStream::Reader::readTo(uint64_t index) {
  while (!ended && !stopped() && read <= index) {
    if (said) said = readOne();
    if (!said) return said;
  }
  if (read > 0 || !ended) return {};
  return Error{inputName,
               {},
               {},
               "the input has no level with a query",
               "pipe obby-gen into obby-train, or use --generate"};
}

Status LevelStream::Reader::readOne() {
  OBBY_ASSIGN(const std::optional<io::Record> record,
              settings.timeout != nullptr ? settings.timeout->next(source) : source.next());
  if (record) return take(*record);
  if (stopped()) return {};
  if (settings.again) OBBY_RETURN_IF_ERROR(source.checkWhole());
  ended = true;
  levels.clear();
  reach = 0;
  close();
  return {};
}

Status LevelStream::Reader::take(const io::Record& record) {
  if (!record.known()) return {};
  switch (record.which()) {
    case io::Kind::PARAMS: physics.know(record); return {};
    case io::Kind::LEVEL: know(physics.known() ? physics.applied(record) : record); return {};
    case io::Kind::QUERY: return takeQuery(record);
    default: return {};
  }
}

void LevelStream::Reader::know(const io::Record& level) {
  levels.push_back(
      {level.reader().getLevel().getName(), io::compact(level), bytesOf(level), false});
  reach += levels.back().bytes;
  const auto tooMany = [&] {
    return levels.size() > settings.levelsInReach ||
           (levels.size() > 1 && reach > settings.bytesInReach);
  };
  while (tooMany()) {
    reach -= levels.front().bytes;
    levels.pop_front();
  }
}

// Returns the last level with this name, or null. An empty name stands for the last level of all.
LevelStream::Known* LevelStream::Reader::levelNamed(const std::string& name) {
  if (name.empty() && !levels.empty()) return &levels.back();
  const auto found = std::find_if(levels.rbegin(), levels.rend(),
                                  [&](const Known& level) { return level.name == name; });
  return found == levels.rend() ? nullptr : &*found;
}

Status LevelStream::Reader::takeQuery(const io::Record& record) {
  const std::string name = record.reader().getQuery().getLevel();
  Known* const level = levelNamed(name);
  if (level == nullptr && name.empty())
    return source.forgive(record, makeError("there is no level before this query"));
  if (level == nullptr) {
    return source.forgive(
        record,
        makeError(fmt::format("there is no level '{}' before this query (levels in memory: {})",
                              name, levels.size())));
  }
  auto query = withPlaces(level->record, record);
  if (!query) return source.forgive(record, query.error());
  Playable playable;
  if (!passedOver(*query)) {
    auto compiled = compile(level->record, *query);
    if (!compiled) return source.forgive(record, compiled.error());
    playable = *std::move(compiled);
    ++compiledOnReading;
  }
  const size_t more = std::exchange(level->counted, true) ? 0 : level->bytes;
  const size_t recordBytes = more + bytesOf(*query);
  add({level->record, io::compact(*query), std::move(playable)}, recordBytes);
  return {};
}

// Returns true if the query's turn is past, as after a resume in the middle of a stream. The query
// was compiled in the earlier run and need not be compiled again. If errors are forgiven, the query
// may have been skipped, so it is compiled again.
bool LevelStream::Reader::passedOver(const io::Record& query) const {
  const bool alone = query.reader().getQuery().getDifficulty() < 0;
  const uint64_t turn = read + (alone && !open.empty() ? 1 : 0);
  return turn < needed && source.onError() == io::OnError::stop;
}

void LevelStream::Reader::add(Item item, size_t recordBytes) {
  const bool alone = item.difficulty() < 0;
  if (alone) close();
  bytes += recordBytes;
  open.push_back(std::move(item));
  if (alone || open.size() >= settings.choices) close();
}

void LevelStream::Reader::close() {
  if (open.empty()) return;
  full = full || !settings.again || (kept > 0 && bytes > settings.keptBytes);
  if (!full) ++kept;
  const uint64_t index = read++;
  waiting += compiledOf(open);
  if (index < needed || waiting > settings.compiledLevels) dropCompiled(open);
  if (!full || index >= needed) turns.emplace(index, std::move(open));
  open.clear();
}

// Reduces a turn whose records are not kept to the item that was played. After a restart only a
// kept turn can play another item.
void LevelStream::Reader::played(uint64_t number, Turn& turn, const Item& item) {
  dropCompiled(turn);
  if (number >= kept) turn.assign(1, Item{item.level, item.query, nullptr});
}

void LevelStream::Reader::dropCompiled(Turn& turn) {
  waiting -= compiledOf(turn);
  for (Item& item : turn) item.compiled = nullptr;
}

// Drops turns that other ranks or an earlier run have played. Kept turns keep their records.
void LevelStream::Reader::forget(uint64_t before) {
  if (before <= needed) return;
  const auto end = turns.lower_bound(before);
  for (auto turn = turns.lower_bound(needed); turn != end; ++turn) dropCompiled(turn->second);
  needed = before;
  turns.erase(turns.lower_bound(kept), turns.lower_bound(std::max(needed, kept)));
}

}  // namespace obby::train
