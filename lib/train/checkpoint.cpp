#include "train/checkpoint.h"

#include <capnp/any.h>
#include <capnp/message.h>
#include <capnp/serialize.h>
#include <fmt/format.h>
#include <kj/exception.h>

#include <cstring>

#include "base/hash.h"
#include "schema/checkpoint.capnp.h"
#include "train/state_codec.h"

namespace obby::train {

namespace {

constexpr uint32_t kVersion = 5;
using Words = kj::Array<capnp::word>;

uint64_t digest(const Words& words) {
  return hashBytes(words.asBytes().begin(), words.asBytes().size());
}

Error refused(const std::string& name, const std::string& what) {
  return Error{
      name, {}, {}, "cannot resume from this checkpoint: " + what, "start again without --resume"};
}

Status decode(schema::SavedTraining::Reader file, Checkpoint& out) {
  if (file.getVersion() != kVersion)
    return makeError(
        fmt::format("its layout version is {}, expected {}", file.getVersion(), kVersion));
  if (file.getObservationVersion() != policy::kObservationVersion) {
    return makeError(fmt::format("its observation version is {}, expected {}",
                                 file.getObservationVersion(), policy::kObservationVersion));
  }
  if (file.getStateLayout() != stateLayout())
    return makeError("a version of obby-train with another layout of worlds wrote it");
  out.program = file.getProgram();
  for (const auto s : file.getSettings())
    out.settings.push_back({presentSettingName(s.getName()), s.getValue()});
  out.seconds = file.getSeconds();
  TrainerState& state = out.state;
  state.iterations = file.getIterations();
  state.decisions = file.getDecisions();
  state.solved = file.getSolved();
  state.hardest = file.getHardest();
  if (!isShare(state.solved) || !isShare(state.hardest))
    return makeError("it is damaged: a share or difficulty is not from 0 to 1");
  OBBY_RETURN_IF_ERROR(readSums(file.getSeen(), state.seen));
  OBBY_RETURN_IF_ERROR(readLearner(file.getLearner(), state.learner));
  for (const auto envGroup : file.getEnvGroups())
    OBBY_RETURN_IF_ERROR(readEnvGroup(envGroup, state.envGroups.emplace_back()));
  return {};
}

// Checks the hash. It is the file's first field, so it lies where the root's data begin.
Status checkHash(Words& words, const capnp::ReaderOptions& options) {
  capnp::FlatArrayMessageReader reader(words, options);
  const auto root = reader.getRoot<capnp::AnyStruct>();
  const auto data = root.getDataSection();
  if (data.size() < sizeof(uint64_t)) return makeError("it is empty");
  const size_t at = size_t(data.begin() - words.asBytes().begin());
  uint64_t hash = 0;
  std::memcpy(&hash, words.asBytes().begin() + at, sizeof hash);
  std::memset(words.asBytes().begin() + at, 0, sizeof hash);
  return digest(words) == hash ? Status() : makeError("it is damaged: its hash does not match");
}

void encode(const Checkpoint& checkpoint, schema::SavedTraining::Builder file) {
  file.setVersion(kVersion);
  file.setObservationVersion(policy::kObservationVersion);
  file.setStateLayout(stateLayout());
  file.setProgram(checkpoint.program);
  auto settings = file.initSettings(uint32_t(checkpoint.settings.size()));
  for (uint32_t i = 0; i < settings.size(); ++i) {
    settings[i].setName(checkpoint.settings[i].name);
    settings[i].setValue(checkpoint.settings[i].value);
  }
  file.setSeconds(checkpoint.seconds);
  const TrainerState& state = checkpoint.state;
  file.setIterations(state.iterations);
  file.setDecisions(state.decisions);
  file.setSolved(state.solved);
  file.setHardest(state.hardest);
  writeSums(state.seen, file.initSeen());
  writeLearner(state.learner, file.initLearner());
  auto envGroups = file.initEnvGroups(uint32_t(state.envGroups.size()));
  for (uint32_t i = 0; i < envGroups.size(); ++i) writeEnvGroup(state.envGroups[i], envGroups[i]);
}

}  // namespace

std::string writeCheckpoint(const Checkpoint& checkpoint) {
  capnp::MallocMessageBuilder message(1 << 18);
  auto file = message.initRoot<schema::SavedTraining>();
  encode(checkpoint, file);
  file.setHash(digest(capnp::messageToFlatArray(message)));
  const Words words = capnp::messageToFlatArray(message);
  const auto bytes = words.asBytes();
  return std::string(reinterpret_cast<const char*>(bytes.begin()), bytes.size());
}

Result<Checkpoint> readCheckpoint(std::string_view bytes, const std::string& name) {
  if (bytes.empty() || bytes.size() % sizeof(capnp::word) != 0)
    return refused(name, "it is damaged: its length is 0 or not a multiple of 8 bytes");
  Words words = kj::heapArray<capnp::word>(bytes.size() / sizeof(capnp::word));
  std::memcpy(words.asBytes().begin(), bytes.data(), bytes.size());
  capnp::ReaderOptions options;
  options.traversalLimitInWords = 2 * words.size() + 1024;  // no word is read more than twice
  Checkpoint out;
  Status status;
  // Cap'n Proto throws if a message is incomplete.
  const auto failure = kj::runCatchingExceptions([&] {
    status = checkHash(words, options);
    if (!status) return;
    capnp::FlatArrayMessageReader reader(words, options);
    status = decode(reader.getRoot<schema::SavedTraining>(), out);
  });
  if (failure != nullptr) return refused(name, "it is truncated or damaged");
  if (!status) return refused(name, status.error().message);
  return out;
}

}  // namespace obby::train
