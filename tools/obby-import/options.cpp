// The option table of obby-import.
#include "options.h"

#include "cli/rows.h"

namespace obby::tools {
namespace {

constexpr const char* kGroup = "Import";

}  // namespace

cli::ToolSpec importSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-import";
  spec.summary = "turn Roblox place and model files into levels and queries";
  spec.examples = {
      {"Convert a place file to records: the level and a query for each stage",
       "obby-import first-steps.rbxlx"},
      {"List the parts that were recognised, guessed or left out",
       "obby-import --explain first-steps.rbxlx"},
      {"Solve every stage and show the answers",
       "obby-import demo.rbxlx | obby-solve --time-limit 5 | obby-view"},
      {"Write only the level, as Cap'n Proto, under another name",
       "obby-import --no-queries --name intro -o intro.capnp first-steps.rbxlx"},
      {"Combine several inputs, including hand-written levels",
       "obby-import first-steps.rbxlx teaser.jsonl -o all.jsonl"},
      {"Use physics from obby-calibrate: a params record applies to the levels after it",
       "echo '{\"type\":\"params\",\"gravity\":190}' | obby-import - first-steps.rbxlx"},
  };
  spec.options = {
      cli::commonRow(cli::Common::output),
      cli::commonRow(cli::Common::format),
      cli::commonRow(cli::Common::onError),
      cli::row("name", cli::ValueType::text, "NAME", "",
               "name of the level [default: the name of the file]", kGroup),
      cli::flagRow("no-queries", "write only the level, without a query for each stage", kGroup),
      cli::flagRow("no-scripts", "do not run the place's scripts; the level lacks their effects",
                   kGroup),
      cli::flagRow("explain", "print a table of parts, roles and evidence instead of records",
                   kGroup),
  };
  spec.inputHelp =
      "place and model files (.rbxl, .rbxlx, .rbxm, .rbxmx), Rojo projects (a folder or its "
      "default.project.json) or streams of records";
  spec.notes =
      "The format of an input is recognised by its content. A Rojo project is recognised by its "
      "name, *.project.json, or as a folder that holds default.project.json. A place's scripts run "
      "in a sandbox, without access to files, the network or other programs. If a part gets the "
      "wrong role, correct it with a tag on the part (docs/import.md).";
  return spec;
}

}  // namespace obby::tools
