// obby-gen: generates levels with queries. Wiring only; lib/gen does the work.
#include <fmt/format.h>

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/context.h"
#include "cli/tool.h"
#include "emit.h"
#include "gen/place/place_file.h"
#include "gen/recipe.h"
#include "io/pipeline.h"
#include "options.h"
#include "shared/recipe_options.h"

namespace {

using namespace obby;

constexpr std::string_view kPlaceFormat = "rbxlx", kPlaceEnding = ".rbxlx";

bool wantsPlace(const cli::Arguments& a) {
  if (!a.text("format").empty()) return a.text("format") == kPlaceFormat;
  return a.text("output").ends_with(kPlaceEnding);
}

// Refuses names of place files that Studio could not open, since the output would be records.
Status nameFits(const cli::Arguments& a) {
  if (!a.text("format").empty()) return {};
  for (const char* ending : {".rbxl", ".rbxm", ".rbxmx"}) {
    if (!a.text("output").ends_with(ending)) continue;
    return Error{{},
                 {},
                 "--output",
                 fmt::format("place files are written as {}, not as {}", kPlaceEnding, ending),
                 "name the file *.rbxlx, or give --format"};
  }
  return {};
}

tools::EmitOptions emitOptions(const cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  tools::EmitOptions o;
  o.seed = a.seed();
  o.first = uint64_t(a.integer("first"));
  o.count = uint64_t(a.integer("count"));
  o.check = {a.flag("check"), a.flag("unsolvable") || a.flag("twins"),
             uint64_t(a.integer("check-steps")), a.seed(), &context.stop()};
  return o;
}

// Returns one generator, or with --twins also one for the unsolvable twins.
Result<std::vector<gen::Generator>> generatorsOf(const cli::Arguments& a,
                                                 const gen::Recipe& recipe) {
  const bool twins = a.flag("twins"), unsolvable = a.flag("unsolvable");
  if (twins && unsolvable) {
    return Error{
        {}, {}, "--twins", "cannot be combined with --unsolvable", "leave out one of the two"};
  }
  std::vector<gen::Generator> out;
  for (const bool lacking : {false, true}) {
    if (!twins && lacking != unsolvable) continue;
    OBBY_ASSIGN(gen::Generator one, gen::Generator::make(recipe, lacking));
    out.push_back(std::move(one));
  }
  return out;
}

Status noneKept(const tools::CheckOptions& check) {
  return makeError(fmt::format("--check rejected {} levels in a row", tools::kMaxRefused),
                   check.unsolvable ? "try another style, or raise 'excess' in the recipe"
                                    : "raise --check-steps, or try another style or difficulty");
}

// Returns a message about the levels that --check left out, with the reason.
std::string leftOut(const tools::Emission& made, const tools::CheckOptions& check, bool twins) {
  const std::string unsolved = fmt::format("not solved within {} steps", check.steps);
  const std::string unproved = "not proved unreachable";
  return fmt::format("--check left out {} of {} {}: {}", made.refused, made.refused + made.kept,
                     twins ? "pairs" : "levels",
                     twins              ? unsolved + ", or the twin " + unproved
                     : check.unsolvable ? unproved
                                        : unsolved);
}

// Ends the run after its output is written.
Status finished(cli::Context& context, const tools::Emission& made,
                const tools::CheckOptions& check) {
  if (made.ended == tools::Ended::noneKept) return noneKept(check);
  const bool twins = context.arguments().flag("twins");
  if (made.refused > 0) context.warn(leftOut(made, check, twins));
  return {};
}

// Writes a stream of records, including those made before an interruption.
Status writeStream(cli::Context& context, std::span<const gen::Generator> generators,
                   tools::EmitOptions options, ThreadPool& pool) {
  OBBY_ASSIGN(io::StreamWriter output, context.openOutput());
  options.format = output.format();
  io::SourceOptions nothing;
  nothing.inputs.clear();
  nothing.stop = &context.stop();
  io::Pipeline pipeline(std::move(nothing), context.identity(), std::move(output));
  OBBY_RETURN_IF_ERROR(
      pipeline.run([](const io::Record&) -> Result<io::Then> { return io::Then::pass; }));
  uint64_t levels = 0;
  const auto take = [&](const tools::Emitted& one) -> Status {
    for (const io::Record& record : one.records) {
      OBBY_RETURN_IF_ERROR(pipeline.output().pass(record));
    }
    ++levels;
    const double share = options.count == 0 ? -1 : double(levels) / double(options.count);
    context.progress({"levels", share, {{"made", double(levels)}}});
    return {};
  };
  const auto made = tools::emit(generators, options, pool, context.stop(), take);
  if (made && made->ended == tools::Ended::noneKept) pipeline.outOfBudget();
  OBBY_RETURN_IF_ERROR(pipeline.finish(made ? Status() : Status(made.error())));
  return finished(context, *made, options.check);
}

// Writes a place file, or none if interrupted.
Status writePlace(cli::Context& context, std::span<const gen::Generator> generators,
                  const tools::EmitOptions& options, ThreadPool& pool) {
  if (options.count == 0) {
    return Error{{}, {}, "--count", "a place file cannot be endless", "give a number above 0"};
  }
  OBBY_ASSIGN(io::Sink sink, context.openSink());  // opened first, so that an unwritable file fails
                                                   // at once
  gen::PlaceFile place(generators.front());
  const auto take = [&](const tools::Emitted& one) -> Status {
    for (const gen::Generated& level : one.levels) OBBY_RETURN_IF_ERROR(place.add(level));
    return {};
  };
  OBBY_ASSIGN(const tools::Emission made,
              tools::emit(generators, options, pool, context.stop(), take));
  if (made.ended == tools::Ended::stopped) return {};
  if (made.ended == tools::Ended::complete) {
    OBBY_RETURN_IF_ERROR(sink.write(place.finish()));
    OBBY_RETURN_IF_ERROR(sink.close());
  }
  return finished(context, made, options.check);
}

Status writeList(const cli::Context& context, const gen::Recipe& recipe) {
  OBBY_ASSIGN(io::Sink sink, context.openSink());
  OBBY_RETURN_IF_ERROR(sink.write(tools::listOfStyles(recipe)));
  return sink.close();
}

// Refuses options that would have no effect.
Status optionsFit(const cli::Arguments& a) {
  if (a.flag("list")) {
    return cli::refuseTyped(a,
                            {"format", "count", "first", "unsolvable", "twins", "seed",
                             "difficulty", "check", "check-steps"},
                            "cannot be combined with --list", "leave out one of the two");
  }
  if (a.flag("check")) return {};
  return cli::refuseTyped(a, {"check-steps"}, "has no effect without --check",
                          "add --check, or leave out --check-steps");
}

Result<cli::ExitCode> run(cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  OBBY_RETURN_IF_ERROR(optionsFit(a));
  OBBY_RETURN_IF_ERROR(nameFits(a));
  OBBY_ASSIGN(const gen::Recipe recipe, tools::recipeOf(a));
  if (a.flag("list")) {
    OBBY_RETURN_IF_ERROR(checkRecipe(recipe));
    OBBY_RETURN_IF_ERROR(writeList(context, recipe));
    return cli::ExitCode::ok;
  }
  OBBY_ASSIGN(const std::vector<gen::Generator> generators, generatorsOf(a, recipe));
  ThreadPool pool(context.threads());
  const tools::EmitOptions options = emitOptions(context);
  OBBY_RETURN_IF_ERROR(wantsPlace(a) ? writePlace(context, generators, options, pool)
                                     : writeStream(context, generators, options, pool));
  return cli::ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::genSpec(), argc, argv, run);
}
