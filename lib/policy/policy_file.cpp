#include "policy/policy_file.h"

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <fmt/format.h>
#include <kj/exception.h>

#include <cmath>
#include <cstring>

#include "base/hash.h"
#include "schema/policy.capnp.h"

namespace obby::policy {

namespace {

constexpr uint32_t kVersion = 1;
constexpr size_t kMaxBytes = 1 << 26;

struct LayerSize {
  int inputs, outputs;
};
constexpr LayerSize kLayers[] = {{kInputs, kHidden}, {kHidden, kHidden}, {kHidden, kPaddedOutputs}};

uint64_t digest(const Network& network) {
  return hashBytes(network.numbers().data(), network.numbers().size() * sizeof(float));
}

const float* fill(const float* from, capnp::List<float>::Builder to) {
  for (uint32_t i = 0; i < to.size(); ++i) to.set(i, *from++);
  return from;
}

Error refused(const std::string& name, const std::string& what) {
  return Error{name,
               {},
               {},
               "not a policy file that this version can use: " + what,
               "train a new one with this version's obby-train"};
}

// Copies the numbers of a list to `to`, which advances.
Status take(capnp::List<float>::Reader from, size_t expected, const std::string& what, float*& to) {
  if (from.size() != expected)
    return makeError(fmt::format("it has {} {}, expected {}", from.size(), what, expected));
  for (const float v : from) {
    if (!std::isfinite(v)) return makeError(fmt::format("not all {} are finite", what));
    *to++ = v;
  }
  return {};
}

Status takeNumbers(schema::PolicyFile::Reader file, Network& network) {
  float* to = network.numbers().data();
  OBBY_RETURN_IF_ERROR(take(file.getMeans(), kInputs, "means", to));
  OBBY_RETURN_IF_ERROR(take(file.getScales(), kInputs, "scales", to));
  const auto layers = file.getLayers();
  if (layers.size() != std::size(kLayers))
    return makeError(
        fmt::format("it has {} layers, expected {}", layers.size(), std::size(kLayers)));
  for (uint32_t l = 0; l < layers.size(); ++l) {
    const LayerSize size = kLayers[l];
    if (int64_t(layers[l].getInputs()) != size.inputs ||
        int64_t(layers[l].getOutputs()) != size.outputs) {
      return makeError(fmt::format("layers[{}] is {} x {}, expected {} x {}", l,
                                   layers[l].getInputs(), layers[l].getOutputs(), size.inputs,
                                   size.outputs));
    }
    OBBY_RETURN_IF_ERROR(take(layers[l].getWeights(), size_t(size.inputs) * size_t(size.outputs),
                              fmt::format("weights of layers[{}]", l), to));
    OBBY_RETURN_IF_ERROR(take(layers[l].getBiases(), size_t(size.outputs),
                              fmt::format("biases of layers[{}]", l), to));
  }
  return {};
}

Status decode(schema::PolicyFile::Reader file, PolicyFile& out) {
  if (file.getVersion() != kVersion)
    return makeError(
        fmt::format("its layout version is {}, expected {}", file.getVersion(), kVersion));
  if (file.getObservationVersion() != kObservationVersion) {
    return makeError(
        fmt::format("it was trained on observations of version {}, expected version {}",
                    file.getObservationVersion(), kObservationVersion));
  }
  if (file.getMoves() != uint32_t(kMoves))
    return makeError(fmt::format("it has {} moves, expected {}", file.getMoves(), kMoves));
  OBBY_RETURN_IF_ERROR(takeNumbers(file, out.network));
  if (file.getHash() != digest(out.network))
    return makeError("the policy file is damaged: its hash does not match",
                     "restore a copy, or train a new policy");
  const auto t = file.getTraining();
  out.training = {t.getCommand(), t.getVersion(), t.getSeed(),   t.getDecisions(),
                  t.getSeconds(), t.getHardest(), t.getSolved(), t.getStart()};
  for (const double v : {t.getSeconds(), double(t.getHardest()), double(t.getSolved())})
    if (!std::isfinite(v)) return makeError("not all numbers about its training are finite");
  out.values = {file.getValueMean(), file.getValueDeviation()};
  const bool sound = std::isfinite(out.values.mean) && std::isfinite(out.values.deviation);
  if (!sound || out.values.deviation < 0)
    return makeError("'valueMean' or 'valueDeviation' is not a valid number");
  return {};
}

}  // namespace

std::string writePolicy(const PolicyFile& policy) {
  capnp::MallocMessageBuilder message(1 << 16);
  auto file = message.initRoot<schema::PolicyFile>();
  file.setVersion(kVersion);
  file.setObservationVersion(kObservationVersion);
  file.setMoves(kMoves);
  const float* from = policy.network.numbers().data();
  from = fill(from, file.initMeans(kInputs));
  from = fill(from, file.initScales(kInputs));
  auto layers = file.initLayers(uint32_t(std::size(kLayers)));
  for (uint32_t l = 0; l < layers.size(); ++l) {
    const LayerSize size = kLayers[l];
    layers[l].setInputs(uint32_t(size.inputs));
    layers[l].setOutputs(uint32_t(size.outputs));
    from = fill(from, layers[l].initWeights(uint32_t(size.inputs * size.outputs)));
    from = fill(from, layers[l].initBiases(uint32_t(size.outputs)));
  }
  file.setHash(digest(policy.network));
  auto t = file.initTraining();
  t.setCommand(policy.training.command);
  t.setVersion(policy.training.version);
  t.setSeed(policy.training.seed);
  t.setDecisions(policy.training.decisions);
  t.setSeconds(policy.training.seconds);
  t.setHardest(policy.training.hardest);
  t.setSolved(policy.training.solved);
  t.setStart(policy.training.start);
  file.setValueMean(policy.values.mean);
  file.setValueDeviation(policy.values.deviation);
  const auto words = capnp::messageToFlatArray(message);
  const auto bytes = words.asBytes();
  return std::string(reinterpret_cast<const char*>(bytes.begin()), bytes.size());
}

Result<PolicyFile> readPolicy(std::string_view bytes, const std::string& name) {
  if (bytes.size() > kMaxBytes) return refused(name, "it is larger than 64 MiB");
  if (bytes.empty() || bytes.size() % sizeof(capnp::word) != 0)
    return Error{
        name, {}, {}, "not a policy file, or a truncated one", "name a file that obby-train wrote"};
  auto words = kj::heapArray<capnp::word>(bytes.size() / sizeof(capnp::word));
  std::memcpy(words.asBytes().begin(), bytes.data(), bytes.size());
  PolicyFile out;
  Status status;
  // Cap'n Proto reports defects of a message by exceptions.
  const auto failure = kj::runCatchingExceptions([&] {
    capnp::FlatArrayMessageReader reader(words);
    status = reader.getEnd() == words.end() ? decode(reader.getRoot<schema::PolicyFile>(), out)
                                            : Status(makeError("it has extra bytes at its end"));
  });
  KJ_IF_MAYBE (e, failure) {
    return refused(name, e->getDescription().cStr());
  }
  if (!status) {
    Error error = std::move(status).error();
    if (error.hint.empty()) return refused(name, error.message);
    error.input = name;
    return error;
  }
  return out;
}

}  // namespace obby::policy
