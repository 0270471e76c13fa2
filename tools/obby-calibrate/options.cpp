// The option table of obby-calibrate, and its translation to lib/calibrate's settings.
#include "options.h"

#include <fmt/format.h>

#include <charconv>

#include "cli/rows.h"
#include "level/tricks.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::flagRow;
using cli::OptionRow;
using cli::rare;
using cli::repeatable;
using cli::row;
using cli::ValueType;

constexpr const char* kFitGroup = "Fitting";
constexpr const char* kPlayGroup = "Comparison (nothing is fitted)";
constexpr const char* kRehearseGroup = "Calibration course (nothing is fitted)";

std::vector<OptionRow> fitRows() {
  return {
      repeatable(row("fit", ValueType::text, "NAME", "",
                     "fit only this parameter [default: all that the recordings can determine]",
                     kFitGroup)),
      repeatable(row("set", ValueType::text, "NAME=VALUE", "",
                     "start from this value; a parameter that is not fitted keeps it", kFitGroup)),
      row("report", ValueType::file, "FILE", "",
          "write the values and their uncertainty to FILE: as a page with the trajectories if its "
          "name ends in .html, else as text",
          kFitGroup),
      between(row("tolerance", ValueType::number, "STUDS", "0.1",
                  "mean distance from the recordings at which the search ends; if it is not "
                  "reached, the report says why",
                  kFitGroup),
              0, 1000),
      between(row("held-out", ValueType::integer, "N", "4",
                  "exclude every Nth recording from the fit and measure the error on it; 0: none",
                  kFitGroup),
              0, 1000),
      between(
          row("restarts", ValueType::integer, "N", "3",
              "number of evolutionary searches, each from a different starting point", kFitGroup),
          1, 1000),
      between(row("generations", ValueType::integer, "N", "100",
                  "maximum generations of each search", kFitGroup),
              1, 100000),
  };
}

OptionRow tricksRow() {
  OptionRow r = row("tricks", ValueType::choice, "", "none",
                    "with --play: tricks that the recordings contain", kPlayGroup);
  r.choices = level::trickOptions();
  return repeatable(rare(r));
}

std::vector<OptionRow> playRows() {
  return {
      flagRow(
          "play",
          "replay the recordings' inputs in the simulator, with the parameters given by --set, and "
          "write the simulator's error on each recording, and a summary",
          kPlayGroup),
      tricksRow(),
  };
}

std::vector<OptionRow> rehearseRows() {
  return {
      flagRow(
          "course",
          "write the calibration course and its manoeuvres, to be played and recorded in Studio "
          "(docs/calibration.md)",
          kRehearseGroup),
      flagRow("rehearse",
              "write the calibration course with simulated recordings, made with the parameters "
              "given by --set",
              kRehearseGroup),
      between(
          row("noise", ValueType::number, "STUDS", "0",
              "with --rehearse: maximum error of a recorded position on each axis", kRehearseGroup),
          0, 10),
  };
}

}  // namespace

cli::ToolSpec calibrateSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-calibrate";
  spec.summary = "fit physics parameters to recordings of the real game";
  spec.inputHelp = "streams with levels and recordings of them";
  spec.readsInputs = [](const cli::Arguments& a) { return !makesTakes(a); };
  spec.examples = {
      {"Write the calibration course, to be played and recorded in Studio",
       "obby-calibrate --course -o course.jsonl"},
      {"Simulate recordings under weaker gravity",
       "obby-calibrate --rehearse --set gravity=180 -o takes.jsonl"},
      {"Check that gravity can be recovered from recordings of the course",
       "obby-calibrate --rehearse --set gravity=180 | obby-calibrate --fit gravity --restarts 1"},
      {"Compare recordings with the simulator under weaker gravity",
       "obby-calibrate --rehearse | obby-calibrate --play --set gravity=190"},
      {"Check how accurately walkSpeed can be recovered from noisy recordings",
       "obby-calibrate --rehearse --noise 0.01 | "
       "obby-calibrate --fit walkSpeed --restarts 1 --report found.html"},
  };
  spec.options =
      cli::joined({{cli::commonRow(cli::Common::output), cli::commonRow(cli::Common::format),
                    cli::commonRow(cli::Common::onError), cli::commonRow(cli::Common::progress)},
                   fitRows(),
                   playRows(),
                   rehearseRows(),
                   {cli::commonRow(cli::Common::threads), cli::commonRow(cli::Common::seed)}});
  spec.notes =
      "A fit writes a params record, and metrics with each parameter's confidence interval and "
      "each recording's error. --play writes a metrics record for each recording and one for all. "
      "Levels and recordings are not passed on; other records are.";
  return spec;
}

Status optionsFit(const cli::Arguments& a) {
  constexpr const char* kOneOfTwo = "leave out one of the two";
  std::vector<const char*> modes;  // modes that fit nothing
  for (const char* mode : {"course", "play", "rehearse"}) {
    if (a.flag(mode)) modes.push_back(mode);
  }
  if (modes.size() > 1)
    return Error{{},
                 {},
                 fmt::format("--{}", modes.back()),
                 fmt::format("cannot be combined with --{}", modes.front()),
                 kOneOfTwo};
  if (!a.flag("rehearse"))
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(a, {"noise"}, "has no effect without --rehearse",
                                          "add --rehearse, or leave out --noise"));
  if (modes.empty()) return {};
  return cli::refuseTyped(
      a, {"fit", "held-out", "tolerance", "restarts", "generations", "report"},
      fmt::format("cannot be combined with --{}, which fits nothing", modes.front()), kOneOfTwo);
}

bool makesTakes(const cli::Arguments& a) { return a.flag("rehearse") || a.flag("course"); }

calibrate::FitSettings fitSettings(const cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  calibrate::FitSettings s;
  s.seed = a.seed();
  s.restarts = uint32_t(a.integer("restarts"));
  s.generations = uint32_t(a.integer("generations"));
  s.tolerance = a.number("tolerance");
  return s;
}

Status applySet(const cli::Arguments& a, schema::PhysicsParams::Builder params) {
  for (const std::string& text : a.list("set")) {
    const size_t sign = text.find('=');
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto read = sign == std::string::npos
                          ? std::from_chars_result{nullptr, std::errc::invalid_argument}
                          : std::from_chars(text.data() + sign + 1, end, value);
    if (read.ec != std::errc() || read.ptr != end)
      return Error{{},
                   {},
                   "--set",
                   fmt::format("expected NAME=VALUE, found '{}'", text),
                   "for example --set gravity=180"};
    OBBY_RETURN_IF_ERROR(calibrate::setNamed(params, text.substr(0, sign), value));
  }
  return {};
}

}  // namespace obby::tools
