#include "play.h"

#include <fmt/format.h>

#include <optional>

#include "base/thread_pool.h"
#include "level/tricks.h"
#include "metrics.h"

namespace obby::tools {

namespace {

using calibrate::Fidelity;

Status writeOne(io::Pipeline& pipeline, const std::string& name, const Fidelity& f) {
  std::vector<Metric> values = {{"meanStuds", f.mean, "studs"}, {"maxStuds", f.max, "studs"}};
  if (f.apex) values.push_back({"apexErrorStuds", *f.apex, "studs"});
  values.push_back({"events", double(f.events), ""});
  values.push_back({"eventsWithinAFrame", double(f.matched), ""});
  return writeMetrics(pipeline, "obby-calibrate --play: " + name, f.frames, values);
}

Status writeSummary(io::Pipeline& pipeline, const std::vector<Fidelity>& all,
                    const calibrate::FidelitySummary& s) {
  std::vector<Metric> values = {{"recordings", double(all.size()), ""},
                                {"medianMeanStuds", s.medianMean, "studs"},
                                {"p95MeanStuds", s.p95Mean, "studs"}};
  if (s.medianApex) values.push_back({"apexErrorStuds", *s.medianApex, "studs"});
  if (s.matched) values.push_back({"eventsWithinAFrame", *s.matched, "share"});
  uint64_t frames = 0;
  for (const Fidelity& f : all) frames += f.frames;
  return writeMetrics(pipeline, "obby-calibrate --play", frames, values);
}

std::string textOf(size_t count, const calibrate::FidelitySummary& s) {
  std::string out = fmt::format(
      "{} recording{} played: the mean position error is {:.3f} studs in the median recording, and "
      "at most {:.3f} studs in 95 % of them",
      count, count == 1 ? "" : "s", s.medianMean, s.p95Mean);
  if (s.medianApex)
    out +=
        fmt::format("; the height of a jump is off by {:.3f} studs in the median", *s.medianApex);
  if (s.matched)
    out += fmt::format("; {:.0f} % of state changes are within a frame", 100 * *s.matched);
  return out;
}

}  // namespace

Status playTakes(cli::Context& context, io::Pipeline& pipeline,
                 const std::vector<calibrate::Take>& takes, schema::PhysicsParams::Reader params) {
  std::vector<std::optional<Result<Fidelity>>> played(takes.size());
  OBBY_ASSIGN(const uint16_t tricks, level::tricksNamed(context.arguments().list("tricks")));
  ThreadPool pool(context.threads());
  pool.run(int(takes.size()), [&](int i) {
    if (!context.stop())
      played[size_t(i)] = calibrate::fidelityOf(takes[size_t(i)], params, tricks);
  });
  std::vector<Fidelity> all;
  for (size_t i = 0; i < takes.size() && played[i]; ++i) {
    OBBY_ASSIGN(const Fidelity one, std::move(*played[i]));
    OBBY_RETURN_IF_ERROR(writeOne(pipeline, takes[i].track.name, one));
    all.push_back(one);
  }
  if (all.empty()) return {};
  const calibrate::FidelitySummary summary = calibrate::summaryOf(all);
  OBBY_RETURN_IF_ERROR(writeSummary(pipeline, all, summary));
  context.note(textOf(all.size(), summary));
  return {};
}

}  // namespace obby::tools
