// The option table of obby-calibrate and what its options mean to lib/calibrate.
#include "options.h"

#include <fmt/format.h>

#include <charconv>

#include "cli/rows.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::OptionRow;
using cli::repeatable;
using cli::row;
using cli::ValueType;

constexpr const char* kFitGroup = "Fitting";
constexpr const char* kRehearseGroup = "The course";

std::vector<OptionRow> fitRows() {
  return {
      repeatable(row("fit", ValueType::text, "NAME", "",
                     "fit this parameter only; without it, all that the recordings can show",
                     kFitGroup)),
      repeatable(row("set", ValueType::text, "NAME=VALUE", "",
                     "begin with this value; what is not fitted keeps it", kFitGroup)),
      between(row("held-out", ValueType::integer, "N", "4",
                  "keep every N-th recording from the fit, to measure on; 0: none", kFitGroup),
              0, 1000),
      between(row("tolerance", ValueType::number, "STUDS", "0.1",
                  "mean distance from the recordings that is good enough: the search ends there, "
                  "or the report says what keeps it away",
                  kFitGroup),
              0, 1000),
      between(row("restarts", ValueType::integer, "N", "3", "searches, from different places",
                  kFitGroup),
              1, 1000),
      between(
          row("generations", ValueType::integer, "N", "100", "of each search, at most", kFitGroup),
          1, 100000),
      row("report", ValueType::file, "FILE", "",
          "write what was found, and how well it is known, to FILE: a page with the paths if it "
          "ends in .html, else a text",
          kFitGroup),
  };
}

std::vector<OptionRow> rehearseRows() {
  return {
      row("course", ValueType::flag, "", "",
          "write the calibration course and what to do there, as trajectories that a recorder "
          "plays",
          kRehearseGroup),
      row("rehearse", ValueType::flag, "", "",
          "record nothing real: write the calibration course and what the simulator makes of its "
          "manoeuvres, with the parameters of --set",
          kRehearseGroup),
      between(row("noise", ValueType::number, "STUDS", "0",
                  "that a recorded position may be off, each axis", kRehearseGroup),
              0, 10),
  };
}

}  // namespace

cli::ToolSpec calibrateSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-calibrate";
  spec.summary = "find the physics parameters that recordings of the real game show";
  spec.inputHelp = "streams with levels and recordings of them";
  spec.readsInputs = [](const cli::Arguments& a) { return !makesTakes(a); };
  spec.examples = {
      {"can these manoeuvres tell how strong gravity is?",
       "obby-calibrate --rehearse --set gravity=180 | obby-calibrate --fit gravity --fit jumpSpeed "
       "--restarts 1 "
       "--report found.txt > params.jsonl"},
      {"how well, if positions are a hundredth of a stud off?",
       "obby-calibrate --rehearse --noise 0.01 > takes.jsonl && obby-calibrate takes.jsonl --fit "
       "walkSpeed --fit airAccel --restarts 1 --report found.txt > params.jsonl"},
  };
  spec.options = {cli::commonRow(cli::Common::output),  cli::commonRow(cli::Common::format),
                  cli::commonRow(cli::Common::onError), cli::commonRow(cli::Common::progress),
                  cli::commonRow(cli::Common::threads), cli::commonRow(cli::Common::seed)};
  for (const auto& rows : {fitRows(), rehearseRows()})
    spec.options.insert(spec.options.end(), rows.begin(), rows.end());
  spec.notes =
      "Writes a params record, and metrics with each parameter's interval and each recording's "
      "error. Levels and recordings are not passed on, other records are.";
  return spec;
}

Status optionsFit(const cli::Arguments& a) {
  constexpr const char* kOneOfTwo = "leave out one of the two";
  const bool course = a.flag("course"), rehearse = a.flag("rehearse");
  if (course && rehearse)
    return Error{{}, {}, "--rehearse", "does not go with --course", kOneOfTwo};
  if (!rehearse)
    OBBY_RETURN_IF_ERROR(
        cli::refuseTyped(a, {"noise"}, "nothing is rehearsed without --rehearse", "leave it out"));
  if (!makesTakes(a)) return {};
  return cli::refuseTyped(
      a, {"fit", "held-out", "tolerance", "restarts", "generations", "report"},
      fmt::format("nothing is fitted with --{}", course ? "course" : "rehearse"), kOneOfTwo);
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
                   fmt::format("'{}' is not NAME=VALUE", text),
                   "for example --set gravity=180"};
    OBBY_RETURN_IF_ERROR(calibrate::setNamed(params, text.substr(0, sign), value));
  }
  return {};
}

}  // namespace obby::tools
