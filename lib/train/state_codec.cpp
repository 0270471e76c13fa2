#include "train/state_codec.h"

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "base/check.h"
#include "base/hash.h"
#include "policy/trainable.h"

namespace obby::train {

namespace {

using sim::Outcome, sim::State;  // as the field table of a world names them

#define OBBY_SIZE_OF(type, name) +sizeof(type)
static_assert(sizeof(sim::World) == OBBY_WORLD_FIELDS(OBBY_SIZE_OF)
                                            OBBY_PROGRESS_FIELDS(OBBY_SIZE_OF) +
                                        sizeof(sim::World::clocks),
              "a world has padding: its bytes would differ between equal worlds");
#undef OBBY_SIZE_OF

template <class From, class List>
void fill(const From* from, List to) {
  for (uint32_t i = 0; i < to.size(); ++i) to.set(i, from[i]);
}

template <class T>
bool allFinite(const std::vector<T>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](T v) { return std::isfinite(v); });
}

template <class List, class To>
Status take(const List& from, const char* what, size_t expected, To* to) {
  if (from.size() != expected)
    return makeError(fmt::format("it has {} {}, expected {}", from.size(), what, expected));
  for (const auto v : from) {
    if (!std::isfinite(double(v)))
      return makeError(fmt::format("it is damaged: some of its {} are not finite", what));
    *to++ = v;
  }
  return {};
}

template <class T>
capnp::Data::Reader bytesOf(const std::vector<T>& rows) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const kj::byte*>(rows.data()), rows.size() * sizeof(T)};
}

template <class T>  // Player or Reached
std::vector<sim::World> worldsOf(const std::vector<T>& rows) {
  std::vector<sim::World> worlds;
  for (const T& row : rows) worlds.push_back(row.world);
  return worlds;
}

template <class T>
Status rowsOf(capnp::Data::Reader bytes, const char* what, std::vector<T>& rows) {
  if (bytes.size() % sizeof(T) != 0)
    return makeError(fmt::format("it has {} bytes of {}, expected a multiple of {}", bytes.size(),
                                 what, sizeof(T)));
  rows.resize(bytes.size() / sizeof(T));
  if (!rows.empty()) std::memcpy(rows.data(), bytes.begin(), bytes.size());
  return {};
}

Status readNumbers(capnp::List<float>::Reader from, const char* what, std::vector<float>& out) {
  out.resize(policy::trainableNetwork().parameters().size());
  return take(from, what, out.size(), out.data());
}

void writePlace(const PlaceState& s, schema::SavedPlace::Builder to) {
  to.setTaken(s.taken);
  to.setHardest(s.hardest);
  to.setNextHardest(s.nextHardest);
  to.setLevelHash(s.levelHash);
  to.setPlayed(s.counts.played);
  to.setSolvedOnce(s.counts.solvedOnce != 0);
  to.setWorlds(bytesOf(worldsOf(s.players)));
  to.setBodies(bytesOf(s.bodies));
  to.setReached(bytesOf(worldsOf(s.reached)));
  auto reachedMinLeft = to.initReachedMinLeft(uint32_t(s.reached.size()));
  for (uint32_t i = 0; i < reachedMinLeft.size(); ++i) reachedMinLeft.set(i, s.reached[i].minLeft);
  const auto players = uint32_t(s.players.size());
  auto minLeft = to.initMinLeft(players);
  auto ticks = to.initTicks(players);
  auto fromStart = to.initFromStart(players);
  for (uint32_t i = 0; i < players; ++i) {
    minLeft.set(i, s.players[i].minLeft);
    ticks.set(i, s.players[i].ticks);
    fromStart.set(i, s.players[i].fromStart);
  }
}

Status readReached(schema::SavedPlace::Reader from, std::vector<Reached>& out) {
  std::vector<sim::World> worlds;
  OBBY_RETURN_IF_ERROR(rowsOf(from.getReached(), "restart worlds", worlds));
  const auto minLeft = from.getReachedMinLeft();
  if (minLeft.size() != worlds.size())
    return makeError("it is damaged: its lists of restart worlds differ in length");
  for (uint32_t i = 0; i < worlds.size(); ++i) out.push_back({worlds[i], minLeft[i]});
  return {};
}

Status readPlace(schema::SavedPlace::Reader from, PlaceState& out) {
  out.taken = from.getTaken();
  out.hardest = from.getHardest();
  out.nextHardest = from.getNextHardest();
  if (!isShare(out.hardest) || !isShare(out.nextHardest))
    return makeError("it is damaged: the difficulty of a level is not from 0 to 1");
  out.levelHash = from.getLevelHash();
  out.counts.played = from.getPlayed();
  out.counts.solvedOnce = from.getSolvedOnce();
  std::vector<sim::World> worlds;
  OBBY_RETURN_IF_ERROR(rowsOf(from.getWorlds(), "worlds", worlds));
  OBBY_RETURN_IF_ERROR(rowsOf(from.getBodies(), "dynamic bodies", out.bodies));
  OBBY_RETURN_IF_ERROR(readReached(from, out.reached));
  out.counts.reached = uint32_t(out.reached.size());
  const auto minLeft = from.getMinLeft();
  const auto ticks = from.getTicks();
  const auto fromStart = from.getFromStart();
  if (minLeft.size() != worlds.size() || ticks.size() != worlds.size() ||
      fromStart.size() != worlds.size())
    return makeError("it is damaged: its lists of a level's players differ in length");
  for (uint32_t i = 0; i < worlds.size(); ++i)
    out.players.push_back({worlds[i], 0, minLeft[i], ticks[i], fromStart[i], worlds[i].jumps});
  return {};
}

}  // namespace

bool isShare(double v) { return v >= 0 && v <= 1; }

bool isFinite(const Sums& sums) {
  return allFinite(sums.sum) && allFinite(sums.squares) && std::isfinite(sums.rows);
}

bool isFinite(const LearnerState& s) {
  return allFinite(s.parameters) && allFinite(s.momentum) && allFinite(s.squares) &&
         std::isfinite(s.values.mean) && std::isfinite(s.values.deviation) &&
         isFinite(s.values.returns);
}

uint64_t stateLayout() {
#define OBBY_NAME_OF(type, name) #type " " #name ";"
  const std::string text = fmt::format(
      OBBY_WORLD_FIELDS(OBBY_NAME_OF) OBBY_PROGRESS_FIELDS(
          OBBY_NAME_OF) "clocks {}; world {}; position {} rotation {} velocity {} spin {} "
                        "stillTicks {} state {}; body {}",
      sim::kMaxClocks, sizeof(sim::World), offsetof(sim::RigidBody, position),
      offsetof(sim::RigidBody, rotation), offsetof(sim::RigidBody, velocity),
      offsetof(sim::RigidBody, spin), offsetof(sim::RigidBody, stillTicks),
      offsetof(sim::RigidBody, state), sizeof(sim::RigidBody));
#undef OBBY_NAME_OF
  return hashBytes(text.data(), text.size());
}

void writeSums(const Sums& sums, schema::SavedSums::Builder to) {
  fill(sums.sum.data(), to.initSum(uint32_t(sums.sum.size())));
  fill(sums.squares.data(), to.initSquares(uint32_t(sums.squares.size())));
  to.setRows(sums.rows);
}

Status readSums(schema::SavedSums::Reader from, Sums& out) {
  OBBY_RETURN_IF_ERROR(take(from.getSum(), "sums", out.sum.size(), out.sum.data()));
  OBBY_RETURN_IF_ERROR(
      take(from.getSquares(), "sums of squares", out.squares.size(), out.squares.data()));
  out.rows = from.getRows();
  const bool sound = std::isfinite(out.rows) && out.rows >= 0;
  return sound ? Status()
               : Status(makeError("it is damaged: the number of rows in its sums is not valid"));
}

void writeLearner(const LearnerState& state, schema::SavedLearner::Builder to) {
  const auto count = uint32_t(state.parameters.size());
  fill(state.parameters.data(), to.initWeights(count));
  fill(state.momentum.data(), to.initMomentum(count));
  fill(state.squares.data(), to.initSquares(count));
  to.setSteps(state.steps);
  to.setValueMean(state.values.mean);
  to.setValueDeviation(state.values.deviation);
  writeSums(state.values.returns, to.initReturns());
}

Status readLearner(schema::SavedLearner::Reader from, LearnerState& out) {
  OBBY_RETURN_IF_ERROR(readNumbers(from.getWeights(), "weights", out.parameters));
  OBBY_RETURN_IF_ERROR(readNumbers(from.getMomentum(), "means of gradients", out.momentum));
  OBBY_RETURN_IF_ERROR(readNumbers(from.getSquares(), "means of squares", out.squares));
  out.steps = from.getSteps();
  out.values.mean = from.getValueMean();
  out.values.deviation = from.getValueDeviation();
  if (!std::isfinite(out.values.mean) || !std::isfinite(out.values.deviation) ||
      !(out.values.deviation > 0))
    return makeError("it is damaged: the mean or deviation of its values is not valid");
  return readSums(from.getReturns(), out.values.returns);
}

void writeEnvGroup(const EnvGroupState& state, schema::SavedEnvGroup::Builder to) {
  auto places = to.initPlaces(uint32_t(state.places.size()));
  for (uint32_t i = 0; i < places.size(); ++i) writePlace(state.places[i], places[i]);
}

Status readEnvGroup(schema::SavedEnvGroup::Reader from, EnvGroupState& out) {
  for (const auto place : from.getPlaces())
    OBBY_RETURN_IF_ERROR(readPlace(place, out.places.emplace_back()));
  return {};
}

std::string packEnvGroups(const std::vector<EnvGroupState>& envGroups) {
  capnp::MallocMessageBuilder message(1 << 18);
  auto list = message.initRoot<schema::SavedEnvGroups>().initEnvGroups(uint32_t(envGroups.size()));
  for (uint32_t i = 0; i < list.size(); ++i) writeEnvGroup(envGroups[i], list[i]);
  const auto words = capnp::messageToFlatArray(message);
  const auto bytes = words.asBytes();
  return std::string(reinterpret_cast<const char*>(bytes.begin()), bytes.size());
}

void unpackEnvGroups(const std::string& bytes, std::vector<EnvGroupState>& envGroups) {
  auto words = kj::heapArray<capnp::word>(bytes.size() / sizeof(capnp::word));
  std::memcpy(words.asBytes().begin(), bytes.data(), words.asBytes().size());
  capnp::ReaderOptions options;
  options.traversalLimitInWords = 2 * words.size() + 1024;
  capnp::FlatArrayMessageReader reader(words, options);
  for (const auto envGroup : reader.getRoot<schema::SavedEnvGroups>().getEnvGroups()) {
    const Status read = readEnvGroup(envGroup, envGroups.emplace_back());
    OBBY_CHECK_EQ(bool(read), true);
  }
}

}  // namespace obby::train
