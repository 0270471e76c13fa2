// obby-calibrate: fits physics parameters to recordings. Wiring only; lib/calibrate does the work.
#include <fmt/format.h>

#include <optional>

#include "calibrate/course_level.h"
#include "calibrate/manoeuvres.h"
#include "calibrate/page.h"
#include "calibrate/report.h"
#include "calibrate/shortfall.h"
#include "calibrate/takes.h"
#include "calibrate/trick_evidence.h"
#include "cli/written_files.h"
#include "io/sink.h"
#include "level/tricks.h"
#include "metrics.h"
#include "options.h"
#include "play.h"

namespace {

using namespace obby;

Status writeMetrics(io::Pipeline& pipeline, const calibrate::Fit& fit,
                    const std::vector<calibrate::Outcome>& outcomes,
                    const std::vector<calibrate::TrickEvidence>& tricks) {
  std::vector<tools::Metric> values = {{"delay", fit.delay, "s"},
                                       {"meanMiss", calibrate::meanMiss(outcomes), "studs"}};
  if (fit.stopped) values.push_back({"interrupted", 1, ""});
  for (const calibrate::Fitted& f : fit.parameters) {
    const std::string& unit = f.parameter.unit;
    values.push_back({f.parameter.name, f.value, unit});
    values.push_back({f.parameter.name + ".low", f.low, unit});
    values.push_back({f.parameter.name + ".high", f.high, unit});
  }
  for (const calibrate::Outcome& o : outcomes) {
    values.push_back({"mean miss of " + o.name, o.miss.mean, "studs"});
    values.push_back({"last miss of " + o.name, o.miss.last, "studs"});
  }
  for (const calibrate::TrickEvidence& e : tricks) {
    if (e.isOn())
      values.push_back({"mean miss with " + level::trickName(e.trick), e.with, "studs"});
  }
  return tools::writeMetrics(pipeline, "obby-calibrate", fit.evaluations, values);
}

// Writes the course, and its manoeuvres as simulated recordings or as trajectories to record.
Status writeCourse(cli::Context& context, io::Pipeline& pipeline) {
  const cli::Arguments& a = context.arguments();
  io::RecordBuilder plain, level;
  calibrate::writeCourse(plain.root().initLevel());
  calibrate::writeCourse(level.root().initLevel());
  OBBY_RETURN_IF_ERROR(tools::applySet(a, level.root().getLevel().initPhysics()));
  OBBY_ASSIGN(const level::Level compiled, level::Level::compile(level.reader().getLevel()));
  OBBY_RETURN_IF_ERROR(
      pipeline.run([](const io::Record&) -> Result<io::Then> { return io::Then::pass; }));
  // Writes the level without the parameters, since they are to be found.
  OBBY_RETURN_IF_ERROR(pipeline.write(plain.reader()));
  uint64_t number = a.seed();
  for (const calibrate::Manoeuvre& m : calibrate::manoeuvres()) {
    io::RecordBuilder record;
    if (a.flag("course")) {
      calibrate::writePlan(compiled, m, record.root().initTrajectory());
    } else {
      calibrate::writeRecording(
          calibrate::rehearse(compiled, m, float(a.number("noise")), number++),
          record.root().initRecording());
    }
    OBBY_RETURN_IF_ERROR(pipeline.write(record.reader()));
  }
  return {};
}

Result<std::vector<calibrate::Outcome>> outcomesOf(const std::vector<calibrate::Take>& takes,
                                                   bool heldOut,
                                                   schema::PhysicsParams::Reader params,
                                                   double delay) {
  std::vector<calibrate::Outcome> out;
  for (const calibrate::Take& take : takes) {
    OBBY_ASSIGN(calibrate::Path path, calibrate::pathOf(take, params, delay));
    const calibrate::Miss miss = calibrate::missOf(path);
    out.push_back({take.track.name, heldOut, std::move(path), miss});
  }
  return out;
}

// If the error exceeds the tolerance, warns and returns the reasons for the report.
Result<std::vector<std::string>> whyNotNearer(cli::Context& context, const calibrate::Fit& fit,
                                              const std::vector<calibrate::Outcome>& outcomes,
                                              const std::vector<calibrate::Take>& takes,
                                              const std::vector<calibrate::Take>& heldOut,
                                              schema::PhysicsParams::Reader params) {
  const double tolerance = context.arguments().number("tolerance");
  const double miss = calibrate::meanMiss(outcomes);
  if (miss <= tolerance) return std::vector<std::string>();
  OBBY_ASSIGN(const calibrate::Shortfall shortfall,
              calibrate::shortfallOf(heldOut.empty() ? takes : heldOut, fit, params, tolerance));
  context.warn(fmt::format(
      "the simulator is {:.3f} studs off the recordings, more than the tolerance of {:g}: {}", miss,
      tolerance, calibrate::shortOf(shortfall, tolerance)));
  return calibrate::reasonsOf(shortfall, tolerance);
}

// Returns the takes whose levels compile with the parameters found, and reports the others. The
// others belong to levels that were not fitted, so they do not invalidate the fit.
std::vector<calibrate::Take> playable(cli::Context& context,
                                      const std::vector<calibrate::Take>& takes,
                                      schema::PhysicsParams::Reader params) {
  std::vector<calibrate::Take> out;
  for (const calibrate::Take& take : takes) {
    const auto level = calibrate::levelWith(take, params);
    if (level) {
      out.push_back(take);
    } else {
      context.warn(fmt::format(
          "recording '{}' is left out: level '{}' cannot be played with these parameters: {}",
          take.track.name, take.track.level, level.error().text()));
    }
  }
  return out;
}

Status tell(cli::Context& context, io::Pipeline& pipeline, const calibrate::Fit& fit,
            const std::vector<calibrate::Take>& takes, const std::vector<calibrate::Take>& kept,
            schema::PhysicsParams::Builder params, ThreadPool& pool,
            std::optional<io::Sink>& report) {
  for (const calibrate::Fitted& f : fit.parameters)
    calibrate::setValue(params, f.parameter.name, f.value);
  params.setControlRate(uint16_t(fit.controlRate));
  params.setSubsteps(uint16_t(fit.substeps));
  io::RecordBuilder record;
  record.root().setParams(params.asReader());
  OBBY_RETURN_IF_ERROR(pipeline.write(record.reader()));
  const std::vector<calibrate::Take> heldOut = playable(context, kept, params.asReader());
  OBBY_ASSIGN(auto outcomes, outcomesOf(takes, false, params.asReader(), fit.delay));
  OBBY_ASSIGN(const auto others, outcomesOf(heldOut, true, params.asReader(), fit.delay));
  outcomes.insert(outcomes.end(), others.begin(), others.end());
  OBBY_ASSIGN(const auto tricks, calibrate::trickEvidence(takes, params.asReader(), pool));
  OBBY_RETURN_IF_ERROR(writeMetrics(pipeline, fit, outcomes, tricks));
  OBBY_ASSIGN(const std::vector<std::string> why,
              whyNotNearer(context, fit, outcomes, takes, heldOut, params));
  const cli::Arguments& a = context.arguments();
  const std::string text = calibrate::textOf(fit, outcomes, a.number("tolerance"), why);
  context.note(text);
  if (const std::string said = calibrate::textOf(tricks); !said.empty()) context.note(said);
  if (!report) return {};
  const std::string path = a.text("report");
  const bool page = path.ends_with(".html") || path.ends_with(".htm");
  OBBY_RETURN_IF_ERROR(
      report->write(page ? calibrate::pageOf(fit, outcomes, a.number("tolerance"), why) : text));
  return report->close();
}

// The command line's parameters, parsed before any output is opened.
struct Asked {
  io::RecordBuilder now;
  std::vector<calibrate::Parameter> parameters;
};

Result<Asked> askedOf(const cli::Arguments& a) {
  Asked out;
  auto params = out.now.root().initParams();
  OBBY_RETURN_IF_ERROR(tools::applySet(a, params));
  out.parameters = calibrate::parametersAround(params.asReader());
  if (a.has("fit")) {
    OBBY_ASSIGN(out.parameters, calibrate::parametersNamed(a.list("fit"), params.asReader()));
  }
  return out;
}

Status calibrateFrom(cli::Context& context, io::Pipeline& pipeline, Asked asked,
                     std::optional<io::Sink>& report) {
  calibrate::Takes source;
  OBBY_RETURN_IF_ERROR(pipeline.run([&](const io::Record& r) { return source.handle(r); }));
  for (const std::string& warning : source.warnings()) context.warn(warning);
  std::vector<calibrate::Take> takes = source.take();
  if (context.stop()) return {};
  if (takes.empty())
    return pipeline.source().lacking(
        makeError(context.arguments().flag("play") ? "the input has no recordings to play"
                                                   : "the input has no recordings to fit to",
                  "record some in Studio, or try obby-calibrate --rehearse | obby-calibrate"));
  if (context.arguments().flag("play"))
    return tools::playTakes(context, pipeline, takes, asked.now.reader().getParams());
  const uint32_t every = uint32_t(context.arguments().integer("held-out"));
  const auto heldOut = every == 0 || takes.size() < every ? std::vector<calibrate::Take>()
                                                          : calibrate::holdOut(takes, every);
  if (takes.empty())
    return makeError("--held-out 1 leaves no recording to fit to", "give 2 or more");
  ThreadPool pool(context.threads());
  calibrate::FitSettings settings = tools::fitSettings(context);
  settings.heldOut = heldOut;
  auto params = asked.now.root().getParams();
  OBBY_ASSIGN(const calibrate::Fit fit,
              calibrate::fit(takes, std::move(asked.parameters), params.asReader(), settings, pool,
                             context.stop(), [&](const calibrate::FitProgress& progress) {
                               context.progress({progress.task,
                                                 progress.share,
                                                 {{"loss", progress.loss},
                                                  {"evaluations", double(progress.evaluations)}}});
                             }));
  return tell(context, pipeline, fit, takes, heldOut, params, pool, report);
}

// Opens the report before the fit, which may take an hour, so that an unwritable file fails at
// once. Refuses to overwrite recordings, which may be impossible to repeat.
Result<std::optional<io::Sink>> openReport(const cli::Arguments& a) {
  if (!a.has("report") || tools::makesTakes(a)) return std::optional<io::Sink>();
  const cli::WrittenFile written[] = {{"report", a.text("report")}};
  OBBY_RETURN_IF_ERROR(cli::refuseOverwriting(a, written));
  OBBY_ASSIGN(io::Sink sink, io::Sink::open(a.text("report")));
  return std::optional<io::Sink>(std::move(sink));
}

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_RETURN_IF_ERROR(tools::optionsFit(context.arguments()));
  OBBY_ASSIGN(Asked asked, askedOf(context.arguments()));
  const bool makes = tools::makesTakes(context.arguments());
  OBBY_ASSIGN(std::optional<io::Sink> report, openReport(context.arguments()));
  OBBY_ASSIGN(io::StreamWriter output, context.openOutput());
  io::SourceOptions source = context.sourceOptions();
  if (makes) source.inputs.clear();
  io::Pipeline pipeline(std::move(source), context.identity(), std::move(output));
  Status done = makes ? writeCourse(context, pipeline)
                      : calibrateFrom(context, pipeline, std::move(asked), report);
  OBBY_RETURN_IF_ERROR(pipeline.finish(std::move(done)));
  return cli::ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::calibrateSpec(), argc, argv, run);
}
