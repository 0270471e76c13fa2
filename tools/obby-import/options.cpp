// The option table of obby-import.
#include "options.h"

namespace obby::tools {
namespace {

using cli::OptionRow;
using cli::ValueType;

OptionRow flag(const char* name, const char* help) {
  OptionRow row;
  row.name = name;
  row.help = help;
  row.group = "Import";
  return row;
}

OptionRow nameRow() {
  OptionRow row = flag("name", "name of the level [default: the file's name]");
  row.type = ValueType::text;
  row.value = "NAME";
  return row;
}

}  // namespace

cli::ToolSpec importSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-import";
  spec.summary = "turn Roblox place and model files into levels and queries";
  spec.examples = {
      {"A place file as records: the level and a query for each stage",
       "obby-import first-steps.rbxlx"},
      {"What was recognised, what was guessed, what was left out",
       "obby-import --explain first-steps.rbxlx"},
      {"Solve every stage and look at the answers",
       "obby-import demo.rbxlx | obby-solve --time-limit 5 | obby-view --format text"},
      {"Keep the level only, as Cap'n Proto, under a name of its own",
       "obby-import --no-queries --name intro -o intro.capnp first-steps.rbxlx"},
      {"Under physics that obby-calibrate found: a params record holds for the levels behind it",
       "echo '{\"type\":\"params\",\"gravity\":190}' | obby-import - first-steps.rbxlx"},
      {"Several inputs at once, hand-written levels among them",
       "obby-import first-steps.rbxlx teaser.jsonl -o all.jsonl"},
  };
  spec.options = {
      cli::commonRow(cli::Common::output),
      cli::commonRow(cli::Common::format),
      cli::commonRow(cli::Common::onError),
      nameRow(),
      flag("no-queries", "write the level only, no query for each stage"),
      flag("explain", "print a table of parts, roles and evidence instead of records"),
  };
  spec.inputHelp = "place and model files (.rbxl, .rbxlx, .rbxm, .rbxmx) or streams of records";
  spec.notes =
      "The format of an input is told by its content, not by its name. Scripts in a place are "
      "read, "
      "never executed. Where a part is taken for something else than it is, a tag sets it right "
      "(docs/import.md).";
  return spec;
}

}  // namespace obby::tools
