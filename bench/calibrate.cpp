// Measures how well calibration finds unknown parameters. The recordings come from our simulator
// under twelve random sets, with and without recorder errors, and from Bullet, an engine with other
// rules. A fit takes three to five minutes on two cores, so all cases with twelve sets take hours:
// select some.
//   bench_calibrate [--json] [--each] [--from SET] [--sets N] [CASE...]     --each: every parameter
//   of every set
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string_view>

#include "calibrate/course.h"
#include "calibrate/fit.h"
#include "calibrate/shortfall.h"
#include "common/need.h"
#include "common/report.h"
#ifdef OBBY_HAS_BULLET_PLAYER
#include "support/bullet_player.h"
#endif
#include "support/recording_faults.h"
#include "support/varied_manoeuvre.h"

namespace {

using namespace obby;
using calibrate::Fitted;
using calibrate::Take;

struct Case {
  const char* name;
  test::Faults faults;
};

constexpr Case kCases[] = {
    {"clean", {}},
    {"noise0.01", {.noise = 0.01f}},
    {"noise0.02", {.noise = 0.02f}},
    {"dropped", {.dropped = 0.1f}},
    {"jitter", {.jitter = 0.004}},
    {"late", {.late = 3}},
    {"directions16", {.directions = 16}},
    {"all", {.noise = 0.01f, .dropped = 0.1f, .jitter = 0.004, .late = 2, .directions = 16}},
};

struct Options {
  bool each = false;
  uint64_t from = 1, sets = 12;
  bench::Report::Form form = bench::Report::Form::table;
  std::vector<std::string> wanted;
};

// Totals over the sets of a case.
struct Tally {
  struct Of {
    int known = 0, sharp = 0, near = 0;
    double worst = 0;  // worst error among sharp values
  };
  std::map<std::string, Of> parameters;
  int outside = 0;
  double again = 0, maxAgain = 0, elsewhere = 0, maxElsewhere = 0;  // studs
  double seconds = 0;
};

// Returns the reference of a relative error: the truth, or the upper bound if the value may be 0.
double sizeOf(const Fitted& f, double truth) {
  return f.parameter.lowest > 0 ? truth : f.parameter.highest;
}

// Returns the relative error. Values in whole ticks are compared after rounding.
double errorOf(const Fitted& f, double truth) {
  const auto counted = [&](double value) {
    return f.tick > 0 ? std::round(value / f.tick) : value;
  };
  return std::fabs(counted(f.value) - counted(truth)) / counted(sizeOf(f, truth));
}

bool holds(const Fitted& f, double truth) {
  const double slack = 0.5 * f.tick;
  return truth >= f.low - slack && truth <= f.high + slack;
}

std::vector<Take> spoilt(std::vector<Take> takes, const test::Faults& faults, uint64_t seed) {
  for (Take& take : takes) take.track = test::spoiled(take.track, faults, ++seed);
  return takes;
}

io::RecordBuilder paramsOf(const calibrate::Fit& fit) {
  io::RecordBuilder params;
  params.root().initParams();
  for (const Fitted& f : fit.parameters)
    calibrate::setValue(params.root().getParams(), f.parameter.name, f.value);
  params.root().getParams().setControlRate(uint16_t(fit.controlRate));
  params.root().getParams().setSubsteps(uint16_t(fit.substeps));
  return params;
}

// Returns how the simulator deviates from the fitted recordings.
std::vector<std::string> reasonsAgainst(const std::vector<Take>& takes, const calibrate::Fit& fit) {
  constexpr double kTolerance = 0.01;
  const io::RecordBuilder params = paramsOf(fit);
  return reasonsOf(
      bench::need(calibrate::shortfallOf(takes, fit, params.reader().getParams(), kTolerance)),
      kTolerance);
}

double meanMissOf(const std::vector<Take>& takes, const calibrate::Fit& fit) {
  const io::RecordBuilder params = paramsOf(fit);
  double sum = 0;
  for (const Take& take : takes)
    sum += missOf(bench::need(pathOf(take, params.reader().getParams(), fit.delay))).mean;
  return sum / double(takes.size());
}

// The data of one fit: the fitted recordings, the held-out recordings, the recordings for the final
// comparison, and the true parameters if known.
struct Trial {
  std::string name;
  uint64_t seed;
  std::vector<Take> takes, heldOut;
  std::vector<Take> again,
      // Recordings of the same manoeuvres made again, and of other trajectories in the same places.
      elsewhere;
  const schema::PhysicsParams::Reader* hidden = nullptr;
  std::vector<calibrate::Parameter> parameters = calibrate::parametersAround(calibrate::defaults());
};

void count(const Trial& trial, const Fitted& f, Tally& tally, bool each) {
  const std::string& name = f.parameter.name;
  const double truth = trial.hidden == nullptr ? 0 : calibrate::valueOf(*trial.hidden, name);
  if (each)
    fmt::print(stderr, "{} {} {:<15} {:>9.5g} {:>9.5g} {:>9.5g} {:>9.5g} {}\n", trial.name,
               trial.seed, name, truth, f.value, f.low, f.high, f.known ? "known" : "");
  if (!f.known || trial.hidden == nullptr) return;
  Tally::Of& of = tally.parameters[name];
  ++of.known;
  tally.outside += !holds(f, truth);
  // A value is sharp if its own interval is within one percent, or within one tick.
  if (std::max(f.high - f.value, f.value - f.low) > 0.01 * sizeOf(f, f.value)) return;
  const double error = errorOf(f, truth);
  ++of.sharp;
  of.near += error <= 0.01;
  of.worst = std::max(of.worst, error);
}

void measure(const Trial& trial, bool each, ThreadPool& pool, Tally& tally) {
  calibrate::FitSettings settings;
  settings.seed = trial.seed;
  settings.tolerance = 0.1;  // the tool's default
  settings.restarts = 1;
  settings.heldOut = trial.heldOut;
  const std::atomic<bool> stop{false};
  calibrate::Fit fit;
  const double seconds = bench::secondsOf([&] {
    fit = bench::need(calibrate::fit(trial.takes, trial.parameters, calibrate::defaults(), settings,
                                     pool, stop, [](const calibrate::FitProgress&) {}));
  });
  for (const Fitted& f : fit.parameters) count(trial, f, tally, each);
  const double again = meanMissOf(trial.again, fit);
  const double elsewhere = meanMissOf(trial.elsewhere, fit);
  if (each) {
    fmt::print(
        stderr,
        "{} {} again {:.4f} elsewhere {:.4f} delay {:.4f} rate {} loss {:.3g} seconds {:.1f}\n",
        trial.name, trial.seed, again, elsewhere, fit.delay, fit.controlRate, fit.loss, seconds);
    for (size_t i = 0; i < trial.again.size(); ++i)
      fmt::print(stderr, "   {} {:.4f} {:.4f}\n", trial.again[i].track.name,
                 meanMissOf({trial.again[i]}, fit), meanMissOf({trial.elsewhere[i]}, fit));
    for (const std::string& why : reasonsAgainst(trial.takes, fit))
      fmt::print(stderr, "   {}\n", why);
  }
  tally.seconds += seconds;
  tally.again += again;
  tally.maxAgain = std::max(tally.maxAgain, again);
  tally.elsewhere += elsewhere;
  tally.maxElsewhere = std::max(tally.maxElsewhere, elsewhere);
}

std::vector<calibrate::Manoeuvre> others(std::vector<calibrate::Manoeuvre> manoeuvres,
                                         uint64_t seed, test::Variation max = test::kElsewhere) {
  for (calibrate::Manoeuvre& m : manoeuvres) m = test::varied(std::move(m), ++seed, max);
  return manoeuvres;
}

void measureOurs(const Case& c, uint64_t seed, bool each, ThreadPool& pool, Tally& tally) {
  const io::RecordBuilder truth = calibrate::drawnParams(seed, 0.3);
  const auto hidden = truth.reader().getParams();
  std::vector<calibrate::Manoeuvre> played = calibrate::manoeuvres();
  std::erase_if(played, [](const auto& m) { return m.name == "push the box"; });
  const auto recorded = [&](const std::vector<calibrate::Manoeuvre>& manoeuvres, uint64_t noise) {
    return spoilt(calibrate::takesUnder(hidden, 0, manoeuvres), c.faults, noise);
  };
  measure({c.name, seed, recorded(played, 100 * seed),
           recorded(others(played, 100 * seed), 100 * seed + 50),
           recorded(others(played, 100 * seed + 70, test::kAgain), 100 * seed + 70),
           recorded(others(played, 100 * seed + 50), 100 * seed + 75), &hidden},
          each, pool, tally);
}

#ifdef OBBY_HAS_BULLET_PLAYER
std::vector<Take> playedByBullet(const test::BulletGame& game,
                                 const std::vector<calibrate::Manoeuvre>& manoeuvres) {
  io::RecordBuilder plain;
  test::writeBulletCourse(plain.root().initLevel());
  const auto level = bench::need(level::Level::compile(plain.reader().getLevel()));
  const io::Record record(std::move(plain));
  std::vector<Take> out;
  for (const calibrate::Manoeuvre& m : manoeuvres)
    out.push_back({test::playedByBullet(game, level, m), record});
  return out;
}

void measureBullet(const char* name, test::BulletGame::Body body, uint64_t seed, bool each,
                   ThreadPool& pool, Tally& tally) {
  const test::BulletGame game = test::drawnGame(body, seed, 0.25f);
  const auto manoeuvres = test::bulletManoeuvres();
  // Records each manoeuvre three times with variations, as a person would.
  std::vector<calibrate::Manoeuvre> session = manoeuvres;
  for (const uint64_t again : {10, 20}) {
    for (calibrate::Manoeuvre& m : others(manoeuvres, 100 * seed + again)) {
      m.name += fmt::format(" {}", again / 10 + 1);
      session.push_back(std::move(m));
    }
  }
  const auto recorded = [&](const std::vector<calibrate::Manoeuvre>& played, uint64_t noise) {
    return spoilt(playedByBullet(game, played), {.noise = 0.01f}, noise);
  };
  const Trial trial{name,
                    seed,
                    recorded(session, 100 * seed),
                    recorded(others(manoeuvres, 100 * seed + 90), 100 * seed + 50),
                    recorded(others(manoeuvres, 100 * seed + 50, test::kAgain), 100 * seed + 70),
                    recorded(others(manoeuvres, 100 * seed + 70), 100 * seed + 75)};
  if (each)
    fmt::print(stderr, "{} {} walk {} jump {} gravity {} accel {} {} gain {} {} damping {}\n", name,
               seed, game.walkSpeed, game.jumpSpeed, game.gravity, game.groundAccel, game.airAccel,
               game.groundGain, game.airGain, game.damping);
  measure(trial, each, pool, tally);
}
#endif

void write(const std::string& name, const Tally& tally, double sets, bench::Report& report) {
  Tally::Of sum;
  for (const auto& [parameter, of] : tally.parameters) {
    const std::string row = fmt::format("{}.{}", name, parameter);
    report.add(row, "known", of.known, "sets");
    report.add(row, "sharp", of.sharp, "sets");
    report.add(row, "withinPercent", of.near, "sets");
    if (of.sharp > 0) report.add(row, "largestError", of.worst, "");
    sum.known += of.known, sum.sharp += of.sharp, sum.near += of.near;
    sum.worst = std::max(sum.worst, of.worst);
  }
  if (!tally.parameters.empty()) {
    report.add(name, "known", sum.known, "parameters");
    report.add(name, "sharp", sum.sharp, "parameters");
    report.add(name, "withinPercent", sum.near, "parameters");
    report.add(name, "largestError", sum.worst, "");
    report.add(name, "outsideInterval", tally.outside, "parameters");
  }
  report.add(name, "againMean", tally.again / sets, "studs");
  report.add(name, "againWorst", tally.maxAgain, "studs");
  report.add(name, "elsewhereMean", tally.elsewhere / sets, "studs");
  report.add(name, "elsewhereWorst", tally.maxElsewhere, "studs");
  report.add(name, "seconds", tally.seconds / sets, "s");
}

bool isCase(std::string_view name) {
  const auto named = [&](const Case& c) { return c.name == name; };
  return std::any_of(std::begin(kCases), std::end(kCases), named) || name == "bulletKinematic" ||
         name == "bulletDynamic";
}

Options optionsOf(int argc, char** argv) {
  Options out;
  for (int i = 1; i < argc; ++i) {
    if (!strcmp(argv[i], "--json")) {
      out.form = bench::Report::Form::json;
    } else if (!strcmp(argv[i], "--each")) {
      out.each = true;
    } else if (!strcmp(argv[i], "--sets") && i + 1 < argc) {
      out.sets = std::strtoull(argv[++i], nullptr, 10);
    } else if (!strcmp(argv[i], "--from") && i + 1 < argc) {
      out.from = std::strtoull(argv[++i], nullptr, 10);
    } else {
      if (!isCase(argv[i])) {
        fmt::print(stderr, "bench_calibrate: no case '{}'\n", argv[i]);
        std::exit(2);
      }
      out.wanted.push_back(argv[i]);
    }
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = optionsOf(argc, argv);
  bench::Report report("calibrate", options.form);
  ThreadPool pool(availableThreads());
  const auto asked = [&](const char* name) {
    return options.wanted.empty() ||
           std::count(options.wanted.begin(), options.wanted.end(), name) > 0;
  };
  const auto add = [&](const char* name, const auto& measureOne) {
    if (!asked(name)) return;
    Tally tally;
    for (uint64_t i = 0; i < options.sets; ++i) measureOne(options.from + i, tally);
    write(name, tally, double(options.sets), report);
  };
  for (const Case& c : kCases)
    add(c.name,
        [&](uint64_t seed, Tally& tally) { measureOurs(c, seed, options.each, pool, tally); });
#ifdef OBBY_HAS_BULLET_PLAYER
  using Body = test::BulletGame::Body;
  for (const auto& [name, body] :
       {std::pair("bulletKinematic", Body::kinematic), std::pair("bulletDynamic", Body::dynamic)})
    add(name, [&](uint64_t seed, Tally& tally) {
      measureBullet(name, body, seed, options.each, pool, tally);
    });
#else
  fmt::print(stderr, "bench_calibrate: built without Bullet: its recordings are left out\n");
#endif
}
