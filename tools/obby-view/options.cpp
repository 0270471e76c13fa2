// The option table of obby-view.
#include "options.h"

#include <fmt/format.h>

#include <charconv>

#include "cli/rows.h"
#include "formats.h"
#include "table/terminal.h"

namespace obby {
namespace {

using cli::between;
using cli::flagRow;
using cli::OptionRow;
using cli::row;
using cli::ValueType;

constexpr int kMinPicture = 32, kMaxPicture = 4096;  // pixels

constexpr const char* kContent = "Content";
constexpr const char* kTextGroup = "Text";
constexpr const char* kPictureGroup = "Picture";

OptionRow formatRow() {
  OptionRow out =
      row("format", ValueType::choice, "", "",
          "a page for a browser, plain text, a picture of the first query, or the "
          "trajectories as a model for Studio [default: by the output file's extension, else "
          "text]",
          cli::kFilesGroup);
  for (const ViewFormat& format : viewFormats()) out.choices.emplace_back(format.name);
  return out;
}

// obby-view passes no records on, so --on-error has no emit.
OptionRow onErrorRow() {
  OptionRow out = cli::commonRow(cli::Common::onError);
  out.choices = {"stop", "skip"};
  out.help = "on a bad record: stop, or skip it; the exit code is 2 either way";
  out.details.clear();
  return out;
}

std::vector<OptionRow> contentRows() {
  return {
      cli::repeatable(row("query", ValueType::text, "ID", "", "show this query only", kContent)),
      flagRow("full", "show everything, even if the page becomes large", kContent)};
}

std::vector<OptionRow> textRows() {
  return {flagRow("no-map", "print the table only", kTextGroup),
          flagRow("ascii", "print ASCII characters only", kTextGroup),
          between(row("width", ValueType::integer, "COLUMNS", "",
                      "width of the text in columns [default: the terminal's]", kTextGroup),
                  40, 400)};
}

std::vector<OptionRow> pictureRows() {
  return {row("size", ValueType::text, "WIDTHxHEIGHT", "",
              "size in pixels; with svg, the height is ignored [default: 1280x720]", kPictureGroup),
          cli::choosing(row("from", ValueType::choice, "", "",
                            "direction of view (svg only); best: the side that hides least, as "
                            "in a png [default: best]",
                            kPictureGroup),
                        {"best", "above", "side"}),
          flagRow("attempts", "draw failed attempts, too", kPictureGroup)};
}

constexpr const char* kLive = "Live page";

std::vector<OptionRow> liveRows() {
  return {
      flagRow("live",
              "serve the page on this machine, print its address, and show the input as it "
              "arrives; -o is written when the input ends",
              kLive),
      between(row("port", ValueType::integer, "PORT", "0",
                  "listen on this port of the loopback interface; 0: on any free one", kLive),
              0, 65535),
      flagRow("live-exit",
              "exit once the input has ended and the last open page is closed, not only on Ctrl-C",
              kLive),
  };
}

}  // namespace

cli::ToolSpec viewSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-view";
  spec.summary = "show levels, verdicts and trajectories in a browser or in the terminal";
  spec.examples = {
      {"Write a page that opens in any browser, without a network",
       "obby-import first-steps.rbxlx | obby-solve | obby-view -o report.html"},
      {"Print a table and a map", "obby-solve --query right several-routes.jsonl | obby-view"},
      {"Draw the solution of a query, for a README or an issue",
       "obby-solve --query right several-routes.jsonl | obby-view -o route.png"},
      {"Watch a search in the browser, at the address that is printed",
       "obby-solve --query right several-routes.jsonl | obby-view --live --live-exit"},
      {"Look at a level before anything is solved", "obby-view -o level.html teaser.jsonl"},
      {"Draw a map of a solution, as a vector drawing",
       "obby-solve --query right several-routes.jsonl | obby-view --from above -o route.svg"},
  };
  spec.options = cli::joined({{commonRow(cli::Common::output), formatRow(), onErrorRow()},
                              contentRows(),
                              textRows(),
                              pictureRows(),
                              liveRows()});
  spec.notes =
      "A trajectory record holds only actions, so obby-view replays it. A trajectory that does "
      "not end as its record says is shown as a mismatch.";
  return spec;
}

Status refuseIdle(const cli::Arguments& arguments) {
  const bool live = arguments.flag("live");
  if (!live) {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(arguments, {"port", "live-exit"},
                                          "has no effect without --live", "add --live"));
  } else if (!arguments.has("output")) {
    return cli::refuseTyped(arguments,
                            {"format", "width", "ascii", "no-map", "size", "from", "attempts"},
                            "cannot be combined with --live unless -o names a file", "add -o FILE");
  }
  const std::string format = wantedFormat(arguments).name;
  const std::string message = "has no effect on " + format + " output";
  constexpr const char* kCure = "choose the format with --format or the extension of FILE";
  if (format != "text") {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(arguments, {"width", "ascii", "no-map"}, message, kCure));
  }
  if (format != "html" && !live) {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(arguments, {"full"}, message, kCure));
  }
  if (format != "png" && format != "svg") {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(arguments, {"size", "attempts"}, message, kCure));
  }
  if (format == "svg") return {};
  return cli::refuseTyped(arguments, {"from"}, message, kCure);
}

Result<view::PictureOptions> pictureOptions(const cli::Arguments& arguments) {
  view::PictureOptions options;
  options.attempts = arguments.flag("attempts");
  if (!arguments.has("size")) return options;
  const std::string& text = arguments.text("size");
  const char* const end = text.data() + text.size();
  const auto [cross, wrong] = std::from_chars(text.data(), end, options.width);
  const bool first = wrong == std::errc() && cross != end && *cross == 'x';
  const auto [rest, also] = first ? std::from_chars(cross + 1, end, options.height)
                                  : std::from_chars_result{cross, std::errc::invalid_argument};
  const auto fits = [](int v) { return v >= kMinPicture && v <= kMaxPicture; };
  if (also != std::errc() || rest != end || !fits(options.width) || !fits(options.height))
    return Error{{},
                 {},
                 "--size",
                 fmt::format("expected WIDTHxHEIGHT, each from {0} to {1}, found '{2}'",
                             kMinPicture, kMaxPicture, text),
                 "for example --size 1280x720"};
  return options;
}

view::TextOptions textOptions(const cli::Context& context) {
  const cli::Arguments& arguments = context.arguments();
  view::TextOptions options;
  options.maps = arguments.flag("no-map")          ? view::Maps::none
                 : arguments.list("query").empty() ? view::Maps::few
                                                   : view::Maps::all;
  options.terminal = table::terminalTraits(context.colorOutput());
  if (arguments.has("width")) options.terminal.width = size_t(arguments.integer("width"));
  if (arguments.flag("ascii")) options.terminal.utf8 = false;
  return options;
}

}  // namespace obby
