#include "train/device/device_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "train/device/kernels.h"

namespace obby::train {

namespace {

// Returns the error for callers that require a level.
Error noneFor(const Status& said) { return said ? makeError(kInterrupted) : said.error(); }

}  // namespace

DevicePlaces::DevicePlaces(const TrainerSettings& settings, const LevelSource& source,
                           sim::Device& device, ThreadPool& pool, uint32_t rank, uint32_t ranks)
    : settings_(settings),
      source_(source),
      device_(device),
      rank_(rank),
      ranks_(ranks),
      places_(size_t(settings.envGroups) * settings.envGroup.levels),
      described_(places_.size()),
      next_(source, settings.envGroup, device, places_.size(), pool.size()) {}

std::vector<size_t> DevicePlaces::allPlaces() const {
  std::vector<size_t> all(places_.size());
  std::iota(all.begin(), all.end(), size_t(0));
  return all;
}

// Returns the level's index. The env groups of all ranks share the levels, as on the CPU.
uint64_t DevicePlaces::indexOf(size_t place, uint64_t taken) const {
  const auto envGroup = uint32_t(place / settings_.envGroup.levels);
  return levelIndex(settings_.envGroup, rank_ * settings_.envGroups + envGroup,
                    ranks_ * settings_.envGroups, uint32_t(place % settings_.envGroup.levels),
                    taken);
}

// A place's current level precedes all its later ones, so it bounds the levels still needed.
void DevicePlaces::dropPastLevels() const {
  uint64_t first = ~uint64_t(0);
  for (size_t p = 0; p < places_.size(); ++p) first = std::min(first, indexOf(p, places_[p].taken));
  source_.past(first);
}

void DevicePlaces::askForNext(std::span<const size_t> places) {
  std::vector<NextLevels::Wanted> wanted;
  for (const size_t p : places)
    wanted.push_back({p, indexOf(p, places_[p].taken + 1), places_[p].nextHardest});
  next_.ask(std::move(wanted));
}

Status DevicePlaces::make() {
  OBBY_RETURN_IF_ERROR(table_.make(device_, places_.size()));
  OBBY_RETURN_IF_ERROR(players_.makeZero(device_, places_.size() * settings_.envGroup.worlds));
  OBBY_RETURN_IF_ERROR(reached_.makeZero(device_, places_.size() * kMaxReached));
  return counts_.makeZero(device_, places_.size());
}

void DevicePlaces::describe(PlayArguments& to) const {
  to.places = table_.data();
  to.players = players_.data();
  to.reached = reached_.data();
  to.counts = counts_.data();
  to.worldsOfPlace = settings_.envGroup.worlds;
  to.worlds = settings_.worlds();
  to.firstWorld = rank_ * settings_.worlds();
}

Status DevicePlaces::begin(float hardest) {
  OBBY_RETURN_IF_ERROR(make());
  const std::vector<size_t> all = allPlaces();
  for (Place& p : places_) p.nextHardest = hardest;
  askForNext(all);
  OBBY_RETURN_IF_ERROR(takeLevels(all, hardest));
  for (const Place& p : places_) {
    if (p.waits) return noneFor(missing_);
  }
  return beginNew();
}

// Starts the worlds of levels that were just placed.
Status DevicePlaces::beginNew() {
  PlayArguments play{};
  describe(play);
  return enqueue(device_, trainKernel(TrainStep::begin), play, places_.size());
}

Result<NextLevel> DevicePlaces::needed(size_t p) {
  OBBY_ASSIGN(NextLevel level, next_.take(p));
  if (!level.level) return noneFor(level.said);
  return level;
}

// Moves the requested levels into their places, and requests those after them.
Status DevicePlaces::takeLevels(std::span<const size_t> places, float nextHardest) {
  for (DevicePlace& place : described_) place.isNew = false;
  for (const size_t p : places) {
    OBBY_ASSIGN(NextLevel level, next_.take(p));
    places_[p].waits = !level.level;
    if (missing_) missing_ = level.said;
    if (level.level) putIn(p, std::move(level));
    ++places_[p].taken;
    places_[p].hardest = std::exchange(places_[p].nextHardest, nextHardest);
  }
  askForNext(places);
  return putPlaces();
}

void DevicePlaces::putIn(size_t p, NextLevel level) {
  described_[p] = level.place;
  places_[p].levelHash = level.level->hash();
  places_[p].memory = std::move(level.memory);
}

Status DevicePlaces::putPlaces() {
  anyBodies_ = std::any_of(described_.begin(), described_.end(),
                           [](const DevicePlace& p) { return p.on.level.bodyCount != 0; });
  return table_.put(described_);
}

Result<Tally> DevicePlaces::endIteration(float hardest, const PlayArguments& play) {
  OBBY_ASSIGN(std::vector<PlaceCounts> counts, counts_.get());
  Tally tally;
  std::vector<size_t> over;
  for (size_t p = 0; p < counts.size(); ++p) {
    tally.add(counts[p]);
    if (isOver(counts[p], settings_.envGroup)) over.push_back(p);
  }
  OBBY_RETURN_IF_ERROR(counts_.put(counts));
  if (over.empty()) return tally;
  OBBY_RETURN_IF_ERROR(takeLevels(over, hardest));
  dropPastLevels();
  OBBY_RETURN_IF_ERROR(enqueue(device_, trainKernel(TrainStep::begin), play, places_.size()));
  return tally;
}

Result<PlaceState> DevicePlaces::stateOf(size_t p) const {
  const Place& place = places_[p];
  const uint32_t worlds = settings_.envGroup.worlds;
  PlaceState out;
  out.taken = place.taken;
  out.hardest = place.hardest;
  out.nextHardest = place.nextHardest;
  if (place.waits) return out;
  out.levelHash = place.levelHash;
  OBBY_RETURN_IF_ERROR(device_.download(&out.counts, counts_.data() + p, sizeof out.counts));
  OBBY_ASSIGN(out.players, sim::downloadTable(device_, players_.data() + p * worlds, worlds));
  OBBY_ASSIGN(out.reached,
              sim::downloadTable(device_, reached_.data() + p * kMaxReached, out.counts.reached));
  const DevicePlace& d = described_[p];
  OBBY_ASSIGN(out.bodies,
              sim::downloadTable(device_, d.bodies, size_t(worlds) * d.on.level.bodyCount));
  return out;
}

Result<std::vector<EnvGroupState>> DevicePlaces::state() const {
  std::vector<EnvGroupState> out(settings_.envGroups);
  for (size_t p = 0; p < places_.size(); ++p) {
    OBBY_ASSIGN(PlaceState state, stateOf(p));
    out[p / settings_.envGroup.levels].places.push_back(std::move(state));
  }
  return out;
}

Status DevicePlaces::restore(std::span<EnvGroupState> envGroups) {
  std::vector<PlaceState*> states;
  for (EnvGroupState& envGroup : envGroups) {
    if (envGroup.places.size() != settings_.envGroup.levels)
      return makeError(fmt::format("an env group of the checkpoint has {} levels, expected {}",
                                   envGroup.places.size(), settings_.envGroup.levels));
    for (PlaceState& place : envGroup.places) states.push_back(&place);
  }
  OBBY_RETURN_IF_ERROR(make());
  // Requests the current levels first, then as usual those after them.
  const std::vector<size_t> all = allPlaces();
  for (const size_t p : all) {
    const PlaceState& s = *states[p];
    if (s.taken == 0) return makeError("an env of the checkpoint has no level");
    places_[p] = {s.taken, 0, s.hardest, 0, nullptr, false};
  }
  dropPastLevels();
  for (Place& place : places_) --place.taken;
  askForNext(all);
  for (const size_t p : all) OBBY_RETURN_IF_ERROR(restorePlace(p, *states[p]));
  askForNext(all);
  OBBY_RETURN_IF_ERROR(putPlaces());
  return beginNew();
}

Status DevicePlaces::restorePlace(size_t p, const PlaceState& s) {
  OBBY_ASSIGN(NextLevel level, needed(p));
  OBBY_RETURN_IF_ERROR(checkPlace(s, *level.level, settings_.envGroup));
  putIn(p, std::move(level));
  described_[p].isNew = s.waits();
  places_[p].taken = s.taken;
  places_[p].hardest = s.hardest;
  places_[p].nextHardest = s.nextHardest;
  return s.waits() ? Status() : putState(p, s);
}

Status DevicePlaces::putState(size_t p, const PlaceState& s) {
  const auto put = [&](auto* to, const auto& from) {
    return from.empty() ? Status() : device_.upload(to, from.data(), from.size() * sizeof from[0]);
  };
  OBBY_RETURN_IF_ERROR(put(players_.data() + p * settings_.envGroup.worlds, s.players));
  OBBY_RETURN_IF_ERROR(put(reached_.data() + p * kMaxReached, s.reached));
  OBBY_RETURN_IF_ERROR(put(described_[p].bodies, s.bodies));
  PlaceCounts counts = s.counts;
  counts.reached = uint32_t(s.reached.size());
  return device_.upload(counts_.data() + p, &counts, sizeof counts);
}

}  // namespace obby::train
