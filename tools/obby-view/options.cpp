// What obby-view can be asked for.
#include "options.h"

#include "view/terminal.h"

namespace obby {
namespace {

using cli::OptionRow;
using cli::ValueType;

OptionRow make(std::string name, ValueType type, std::string value, std::string help) {
  OptionRow row;
  row.name = std::move(name);
  row.type = type;
  row.value = std::move(value);
  row.help = std::move(help);
  return row;
}

OptionRow formatRow() {
  OptionRow row = make("format", ValueType::choice, "",
                       "the page for a browser, or text [default: html for a FILE that ends in "
                       ".html or .htm, else text]");
  row.choices = {"html", "text"};
  return row;
}

OptionRow queryRow() {
  OptionRow row = make("query", ValueType::text, "ID", "show this query only; may be repeated");
  row.repeatable = true;
  return row;
}

OptionRow widthRow() {
  OptionRow row = make("width", ValueType::integer, "COLUMNS",
                       "columns of the text [default: those of the terminal]");
  row.min = 40;
  row.max = 400;
  return row;
}

bool endsIn(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

cli::ToolSpec viewSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-view";
  spec.summary = "Show levels, verdicts and trajectories in a browser or in the terminal";
  spec.examples = {
      {"Write a page that opens in any browser, without a network",
       "obby-import first-steps.rbxlx | obby-solve | obby-view -o report.html"},
      {"Print a table and a map", "obby-solve several-routes.jsonl | obby-view"},
      {"Look at a level before anything is solved", "obby-view -o level.html teaser.jsonl"},
  };
  spec.options = {
      commonRow(cli::Common::output),
      formatRow(),
      queryRow(),
      make("full", ValueType::flag, "", "thin nothing out, however large the page becomes"),
      make("no-map", ValueType::flag, "", "text: the table only"),
      make("ascii", ValueType::flag, "", "text: ASCII characters only"),
      widthRow(),
      commonRow(cli::Common::onError),
  };
  spec.notes =
      "A trajectory holds actions only: it is played again here, and one that does not end as its "
      "record says is shown as a mismatch.";
  return spec;
}

bool wantsPage(const cli::Arguments& arguments) {
  if (arguments.has("format")) return arguments.text("format") == "html";
  const std::string& path = arguments.text("output");
  return endsIn(path, ".html") || endsIn(path, ".htm");
}

view::TextOptions textOptions(const cli::Context& context) {
  const cli::Arguments& arguments = context.arguments();
  view::TextOptions options;
  options.maps = !arguments.flag("no-map");
  options.terminal.width =
      arguments.has("width") ? size_t(arguments.integer("width")) : view::terminalWidth();
  options.terminal.color = context.colorOutput();
  options.terminal.utf8 = !arguments.flag("ascii") && view::localeIsUtf8();
  return options;
}

}  // namespace obby
