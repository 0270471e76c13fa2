// Measures how fast and how reliably the search methods answer the query suite of levels/: methods
// x queries x seeds. Each run is logged when it ends. bench/results/README.md explains the report.
#include <fmt/format.h>

#include <algorithm>

#include "base/hash.h"
#include "baselines/methods.h"
#include "cli/context.h"
#include "cli/rows.h"
#include "cli/tool.h"
#include "common/machine.h"
#include "common/report.h"
#include "io/read_file.h"
#include "solve/search/methods/ablations.h"
#include "suite/curve.h"
#include "suite/plan.h"
#include "suite/table.h"

namespace {

using namespace obby;
using cli::OptionRow;
using cli::ValueType;

constexpr double kQuickCap = 10, kQuickUnsolvableCap = 2;  // seconds

struct Option {
  const char* name;
  ValueType type;
  const char *value, *defaultText, *help;
  double min;
  bool repeatable;
};
constexpr Option kOptions[] = {
    {"method", ValueType::choice, "", "",
     "run this method (default: auto and ge); the first one also runs the queries without a "
     "solution",
     0, true},
    {"query", ValueType::text, "FILE:ID", "", "run only this query", 0, true},
    {"seeds", ValueType::integer, "N", "5", "run each with seeds 1 to N", 1, false},
    {"cap", ValueType::number, "SECONDS", "90", "time limit for a run", 0.01, false},
    {"unsolvable-cap", ValueType::number, "SECONDS", "10",
     "time limit for a query without a solution", 0.01, false},
    {"quick", ValueType::flag, "", "",
     "finish in under ten minutes on two cores: one seed, caps of 10 and 2 seconds; methods after "
     "the first run every third query",
     0, false},
    {"shuffle", ValueType::flag, "", "",
     "run the queries in a fixed random order, so that an interrupted run is a fair sample", 0,
     false},
    {"any-build", ValueType::flag, "", "",
     "also count runs of other builds, for suites that need several sessions. All runs of a query "
     "and seed come from one kind of machine: finished ones are kept, others run again",
     0, false},
    {"any-machine", ValueType::flag, "", "",
     "with --any-build or --report-only: also count runs of other kinds of machine; times within a "
     "factor of two then mean nothing",
     0, false},
    {"report-only", ValueType::flag, "", "",
     "run nothing; report the results file, runs of any build", 0, false},
    {"list", ValueType::flag, "", "", "print the queries, one FILE:ID per line", 0, false},
    {"results", ValueType::file, "FILE", "build/bench/solve.jsonl",
     "append runs to this log; runs of this build in it are not repeated", 0, false},
    {"svg", ValueType::file, "FILE", "",
     "also draw the success-against-time curve and, with ge, the thirds of the paper's figure", 0,
     false},
    {"levels", ValueType::file, "FOLDER", OBBY_SOURCE_DIR "/levels", "folder of the suite", 0,
     false},
    {"json", ValueType::flag, "", "", "print one JSON object per figure instead of a table", 0,
     false},
};

std::vector<OptionRow> options() {
  std::vector<OptionRow> rows = {cli::commonRow(cli::Common::threads),
                                 cli::commonRow(cli::Common::progress)};
  for (const Option& option : kOptions) {
    OptionRow& r = rows.emplace_back();
    r.name = option.name;
    r.type = option.type;
    r.value = option.value;
    r.defaultText = option.defaultText;
    r.help = option.help;
    r.min = option.min;
    r.repeatable = option.repeatable;
    if (r.name != "method") continue;
    for (const solve::Method* m : baselines::allMethods()) r.choices.emplace_back(m->name);
    for (const solve::Method& m : solve::ablations()) r.choices.emplace_back(m.name);
  }
  return rows;
}

cli::ToolSpec spec() {
  cli::ToolSpec s;
  s.name = "bench_solve";
  s.summary = "measure search methods on the query suite";
  s.examples = {
      {"a first look", "bench_solve --quick"},
      {"the whole suite, with a picture", "bench_solve --svg solve.svg"},
      {"one method on one query", "bench_solve --method auto --query teaser.jsonl:whole"}};
  s.options = options();
  s.takesInputs = false;
  s.notes =
      "PAR-2 is the time to the first solution, or twice the cap if there is none. par2RatioToGe "
      "is the PAR-2 of ge divided by that of the method, over the solvable queries that both ran: "
      "5 is five times better than ge. falseVerdicts counts runs that contradict the suite: solved "
      "where it has no solution, or unreachable where it has one. Thirds are by effort, which is "
      "estimated from level and query alone (bench/suite/effort.h).";
  return s;
}

const solve::Method* methodOf(const std::string& name) {
  for (const solve::Method& m : solve::ablations()) {
    if (name == m.name) return &m;
  }
  return baselines::findMethod(name);
}

Result<bench::Plan> planOf(const cli::Arguments& a) {
  bench::Plan plan;
  std::vector<std::string> methods = a.list("method");
  if (methods.empty()) methods = {"auto", "ge"};
  for (const std::string& name : methods) plan.methods.push_back(methodOf(name));
  const bool quick = a.flag("quick");
  plan.seeds = quick ? 1 : uint64_t(a.integer("seeds"));
  plan.cap = quick ? kQuickCap : a.number("cap");
  plan.unsolvableCap = quick ? kQuickUnsolvableCap : a.number("unsolvable-cap");
  plan.sampled = quick && a.list("query").empty();
  plan.anyMachine = a.flag("any-machine");
  OBBY_ASSIGN(plan.suite, bench::loadSuite(a.text("levels"), a.list("query")));
  if (a.flag("shuffle")) {
    std::sort(plan.suite.begin(), plan.suite.end(),
              [](const auto& x, const auto& y) { return x.content < y.content; });
  }
  return plan;
}

// Returns a digest of this build. Another build may search differently, so its runs do not count.
Result<uint64_t> programDigest() {
  OBBY_ASSIGN(const std::string bytes, io::readFile("/proc/self/exe"));
  return hashBytes(bytes.data(), bytes.size());
}

// Makes the missing runs of one query and seed. `known`: the makers whose runs count.
Status runMissing(cli::Context& context, const std::vector<bench::Trial>& trials, uint64_t program,
                  const bench::Maker& known, ThreadPool& pool, bench::RunLog& log) {
  for (const bench::Trial& q : trials) {
    if (context.stop()) break;
    bench::Run planned = bench::plannedRun(q, program);
    planned.machine = bench::machineKind();
    if (log.find(planned.key(), known)) continue;
    OBBY_ASSIGN(const std::optional<bench::Run> run, bench::ask(q, planned, pool, context.stop()));
    if (run) OBBY_RETURN_IF_ERROR(log.append(*run));
  }
  return {};
}

Status runAllMissing(cli::Context& context, const bench::Plan& plan, uint64_t program,
                     const bench::Maker& known, ThreadPool& pool, bench::RunLog& log) {
  bench::Maker here = known;
  const bool byMachine = known.program == 0 && !plan.anyMachine;
  if (byMachine) here.machine = bench::machineKind();
  const double all = double(plan.seeds) * double(plan.suite.size());
  double done = 0;
  for (uint64_t seed = 1; seed <= plan.seeds; ++seed) {
    for (size_t q = 0; q < plan.suite.size() && !context.stop(); ++q) {
      context.progress({fmt::format("{} seed {}", plan.suite[q].name(), seed), done++ / all, {}});
      const std::vector<bench::Trial> trials = plan.trialsAt(q, seed);
      if (byMachine && bench::machineOf(trials, log, known).runs == trials.size()) continue;
      OBBY_RETURN_IF_ERROR(runMissing(context, trials, program, here, pool, log));
    }
  }
  return {};
}

Status report(const cli::Arguments& a, const bench::Results& results) {
  const std::vector<bench::Measure> measures = bench::summarise(results);
  if (a.flag("json")) {
    bench::Report rows("solve", bench::Report::Form::json);
    for (const bench::Measure& m : measures) {
      rows.add(m.method, m.metric, m.value, m.unit);
      if (!m.interval) continue;
      rows.add(m.method, m.metric + "Low", m.interval->low, m.unit);
      rows.add(m.method, m.metric + "High", m.interval->high, m.unit);
    }
  } else {
    fmt::print("{}", bench::tableText(results.methods, measures));
    for (size_t m = 0; m < results.methods.size(); ++m) {
      fmt::print("\nslowest of {}\n{}", results.methods[m], bench::slowest(results, m, 10));
    }
  }
  if (a.text("svg").empty()) return {};
  OBBY_ASSIGN(io::Sink picture, io::Sink::open(a.text("svg")));
  OBBY_RETURN_IF_ERROR(picture.write(bench::suiteSvg(results, measures)));
  return picture.close();
}

Result<cli::ExitCode> run(cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  OBBY_ASSIGN(const bench::Plan plan, planOf(a));
  if (a.flag("list")) {
    for (const bench::SuiteQuery& q : plan.suite) fmt::print("{}\n", q.name());
    return cli::ExitCode::ok;
  }
  OBBY_ASSIGN(bench::RunLog log, bench::RunLog::open(a.text("results")));
  if (log.unreadable() > 0) {
    context.warn(fmt::format("{}: {} lines are not runs", a.text("results"), log.unreadable()));
  }
  bench::Maker known;
  if (!a.flag("report-only")) {
    OBBY_ASSIGN(const uint64_t program, programDigest());
    if (!a.flag("any-build")) known.program = program;
    ThreadPool pool(context.threads());
    known.threads = pool.size();
    OBBY_RETURN_IF_ERROR(runAllMissing(context, plan, program, known, pool, log));
  }
  OBBY_RETURN_IF_ERROR(report(a, bench::resultsOf(plan, log, known)));
  return cli::ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) { return obby::cli::runTool(spec(), argc, argv, run); }
