// Translates obby-solve's options to lib/solve's.
#include "baselines/methods.h"
#include "io/read_file.h"
#include "options.h"
#include "policy/shipped_policy.h"
#include "solve/improve/improve.h"

namespace obby::tools {

namespace {

Error refused(const std::string& option, std::string message, std::string hint = {}) {
  return Error{{}, {}, "--" + option, std::move(message), std::move(hint)};
}

Result<solve::Task> taskOf(const cli::Arguments& a, const solve::PassRule& passes) {
  if (!a.flag("verify")) return passes.empty() ? solve::Task::answer : solve::Task::filter;
  if (!passes.empty())
    return refused("verify", "cannot be combined with --pass or --not-pass",
                   "filter first, then verify the output");
  return solve::Task::verify;
}

solve::QuickQuery quickQuery(const cli::Arguments& a) {
  solve::QuickQuery q;
  q.start = a.text("start");
  q.goals = a.list("goal");
  q.waypoints = a.list("waypoint");
  q.visits = a.list("visit");
  q.avoid = a.list("avoid");
  q.forbid = a.list("forbid");
  if (a.has("arrive")) q.arrive = a.text("arrive");
  q.tricks = a.list("tricks");
  if (a.has("directions")) q.directions = a.text("directions");
  if (a.has("min-jumps")) q.minJumps = int32_t(a.integer("min-jumps"));
  if (a.has("max-damage")) q.maxDamage = float(a.number("max-damage"));
  if (a.has("max-jumps")) q.maxJumps = int32_t(a.integer("max-jumps"));
  if (a.has("max-time")) q.timeLimit = float(a.number("max-time"));
  return q;
}

// Returns the first given (or typed) option that defines a query, or an empty text.
std::string asking(const cli::Arguments& a, bool typed) {
  for (const cli::OptionRow& r : queryRows()) {
    if (r.name != "each" && (typed ? a.typed(r.name) : a.has(r.name))) return r.name;
  }
  return {};
}

// A query on the command line must be used by the task.
Status refuseIdleQuick(const cli::Arguments& a, const solve::FilterOptions& o) {
  const std::string option = asking(a, true);
  if (o.task == solve::Task::filter && (!option.empty() || a.typed("each"))) {
    return refused(option.empty() ? "each" : option,
                   "cannot be combined with --pass or --not-pass, which do not search",
                   "leave out this option");
  }
  if (o.task == solve::Task::verify && !option.empty() && !o.each) {
    return refused(option, "cannot be combined with --verify",
                   "leave it out, or add --each to apply it to the queries in the input");
  }
  if (a.typed("each") && !o.quick) {
    return refused("each", "needs another option to apply to the queries",
                   "for example --each --max-jumps 3");
  }
  return {};
}

Status readQuick(const cli::Arguments& a, solve::FilterOptions& o) {
  if (!asking(a, false).empty()) o.quick = quickQuery(a);
  o.each = a.flag("each");
  OBBY_RETURN_IF_ERROR(refuseIdleQuick(a, o));
  if (o.task == solve::Task::answer && o.quick && !o.each && !o.only.empty()) {
    return refused("query", "cannot be combined with a query asked on the command line",
                   "add --each to apply these options to the queries in the input");
  }
  return {};
}

// Refuses options that would have no effect with the others.
Status refuseIdle(const cli::Arguments& a, solve::Task task) {
  if (task == solve::Task::answer) {
    if (a.integer("solutions") > 1) return {};
    return cli::refuseTyped(a, {"diverse"}, "needs --solutions 2 or more",
                            "for example --solutions 5 --diverse");
  }
  // These options only control the search or its reports.
  const char* const message =
      task == solve::Task::verify
          ? "cannot be combined with --verify, which does not search"
          : "cannot be combined with --pass or --not-pass, which do not search";
  return cli::refuseTyped(
      a,
      {"diverse", "difficulty", "final-only", "paths", "heat-map", "explain", "time-limit",
       "max-steps", "solutions", "attempts", "trials", "method", "warm", "policy", "body",
       "frame-rate", "same-keys", "improve", "prefer"},
      message, "leave out this option");
}

Result<std::shared_ptr<const policy::PolicyFile>> policyOf(const cli::Arguments& a) {
  if (!a.has("policy")) return std::shared_ptr<const policy::PolicyFile>();
  OBBY_ASSIGN(const std::string bytes, io::readFile(a.text("policy")));
  OBBY_ASSIGN(policy::PolicyFile file, policy::readPolicy(bytes, a.text("policy")));
  return std::make_shared<const policy::PolicyFile>(std::move(file));
}

solve::Budget budgetOf(const cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  solve::Budget b;
  b.seed = a.seed();
  b.seconds = a.number("time-limit");
  if (a.has("max-steps")) b.maxSteps = uint64_t(a.integer("max-steps"));
  b.solutions = uint32_t(a.integer("solutions"));
  b.diverse = a.flag("diverse") && b.solutions > 1;
  b.attempts = uint32_t(a.integer("attempts"));
  b.stop = &context.stop();
  return b;
}

void readPreference(const cli::Arguments& a, solve::SolverOptions& o) {
  o.preference = solve::findPreference(a.text("prefer"));  // none: `first`
  o.improveSteps = uint64_t(a.number("improve") * solve::kImproveStepsPerSecond);
}

void report(cli::Context& context, solve::FilterOptions& o) {
  o.progress = [&context](const solve::QueryProgress& p) {
    context.progress(
        {"query " + p.query,
         p.fraction,
         {{"steps", double(p.steps)}, {"cells", double(p.cells)}, {"closest", double(p.closest)}}});
  };
  o.deviceFailed = [&context](const Error& error) {
    context.warn(error.text() + "; continuing on the CPU");
  };
}

}  // namespace

Result<solve::FilterOptions> filterOptions(cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  solve::FilterOptions o;
  o.threads = context.threads();
  o.only = a.list("query");
  o.passes = {a.list("pass"), a.list("not-pass")};
  OBBY_ASSIGN(o.task, taskOf(a, o.passes));
  OBBY_RETURN_IF_ERROR(readQuick(a, o));
  OBBY_RETURN_IF_ERROR(refuseIdle(a, o.task));
  OBBY_ASSIGN(o.players,
              solve::askedPlayers(a.list("body"), a.list("frame-rate"), a.flag("same-keys")));
  o.remember = a.flag("watch");
  if (a.has("warm")) {
    io::SourceOptions earlier = context.sourceOptions();
    earlier.inputs = {a.text("warm")};
    OBBY_ASSIGN(o.earlier, solve::EarlierAnswers::read(std::move(earlier)));
  }
  o.solver.method = baselines::findMethod(a.text("method"));
  OBBY_ASSIGN(o.policy, policyOf(a));
  o.solver.policy = o.policy ? &o.policy->network : &policy::shippedPolicy().network;
  o.solver.progressRecords = !a.flag("final-only");
  o.solver.explain = a.flag("explain");
  o.solver.paths = a.flag("paths");
  o.solver.heatMap = a.flag("heat-map");
  if (a.flag("difficulty")) {
    o.solver.difficultyTrials = uint32_t(a.integer("trials"));
  } else {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(a, {"trials"}, "has no effect without --difficulty",
                                          "add --difficulty, or leave out --trials"));
  }
  o.solver.budget = budgetOf(context);
  readPreference(a, o.solver);
  report(context, o);
  return o;
}

Result<sim::Backend> searchBackend(const cli::Context& context) {
  OBBY_ASSIGN(const sim::BackendKind kind, sim::backendKind(context.arguments().text("backend")));
  const bool gpu = kind == sim::BackendKind::cuda;
  return sim::Backend::open(gpu ? kind : sim::BackendKind::cpu);
}

}  // namespace obby::tools
