#include "calibrate/trick_evidence.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "level/tricks.h"

namespace obby::calibrate {

namespace {

constexpr double kChange = 0.05;  // min change of a recording's mean distance, studs

Result<std::vector<double>> distances(std::span<const Take> takes,
                                      schema::PhysicsParams::Reader params, uint16_t tricks,
                                      ThreadPool& pool) {
  std::vector<std::optional<Result<Fidelity>>> played(takes.size());
  pool.run(int(takes.size()),
           [&](int i) { played[size_t(i)] = fidelityOf(takes[size_t(i)], params, tricks); });
  std::vector<double> out;
  for (auto& take : played) {
    OBBY_ASSIGN(const Fidelity one, std::move(*take));
    out.push_back(one.mean);
  }
  return out;
}

}  // namespace

Result<std::vector<TrickEvidence>> trickEvidence(std::span<const Take> takes,
                                                 schema::PhysicsParams::Reader params,
                                                 ThreadPool& pool) {
  OBBY_ASSIGN(const std::vector<double> plain, distances(takes, params, 0, pool));
  std::vector<TrickEvidence> out;
  for (const schema::Trick trick : level::tricksIn(kAllTricks)) {
    const auto bit = uint16_t(1u << uint32_t(trick));
    OBBY_ASSIGN(const std::vector<double> tricky, distances(takes, params, bit, pool));
    TrickEvidence& e = out.emplace_back();
    e.trick = trick;
    for (size_t i = 0; i < takes.size(); ++i) {
      e.without += plain[i] / double(takes.size());
      e.with += tricky[i] / double(takes.size());
      e.nearer += tricky[i] < plain[i] - kChange;
      e.farther += tricky[i] > plain[i] + kChange;
    }
  }
  return out;
}

std::string textOf(std::span<const TrickEvidence> evidence) {
  std::string text;
  for (const TrickEvidence& e : evidence) {
    if (!e.isOn()) continue;
    text += fmt::format(
        "{}with {}s the simulator is {:.3f} studs off instead of {:.3f}, and {} recording{} closer",
        text.empty() ? "" : "; ", level::trickName(e.trick), e.with, e.without, e.nearer,
        e.nearer == 1 ? " is" : "s are");
  }
  return text;
}

}  // namespace obby::calibrate
