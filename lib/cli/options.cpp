#include "cli/options.h"

#include <utility>

namespace obby::cli {
namespace {

OptionRow row(std::string name, char letter, ValueType type, std::string value, std::string help) {
  OptionRow out;
  out.name = std::move(name);
  out.letter = letter;
  out.type = type;
  out.value = std::move(value);
  out.help = std::move(help);
  return out;
}

OptionRow choiceRow(std::string name, ValueType type, std::vector<std::string> choices,
                    std::string defaultText, std::string help) {
  OptionRow out = row(std::move(name), 0, type, "", std::move(help));
  out.choices = std::move(choices);
  out.defaultText = std::move(defaultText);
  return out;
}

OptionRow limited(OptionRow out, double min, double max, std::string defaultText) {
  out.min = min;
  out.max = max;
  out.defaultText = std::move(defaultText);
  return out;
}

OptionRow grouped(OptionRow out, const char* group) {
  out.group = group;
  return out;
}

OptionRow universal(OptionRow out) { return grouped(std::move(out), kHelpGroup); }

OptionRow rareUniversal(OptionRow out) {
  out.rare = true;
  return universal(std::move(out));
}

OptionRow configRow() {
  OptionRow out = row("config", 0, ValueType::file, "FILE",
                      "read options from FILE, one `name = value` per line; a section such as "
                      "[obby-solve] is for that tool only");
  out.details =
      "Put text that contains blanks in 'quotes' and several values in [brackets]. Options above "
      "the first section are for every tool.";
  return out;
}

OptionRow manualRow() {
  OptionRow out = universal(row("man", 0, ValueType::flag, "", "print the manual page and exit"));
  out.hidden = true;
  return out;
}

std::vector<OptionRow> makeUniversalRows() {
  const auto flag = [](const char* name, char letter, const char* help) {
    return row(name, letter, ValueType::flag, "", help);
  };
  return {
      universal(flag("quiet", 'q', "no warnings and no progress on stderr")),
      universal(flag("verbose", 'v', "say on stderr what is being done")),
      rareUniversal(flag("no-color", 0,
                         "no colours (the default if NO_COLOR is set, if TERM is dumb, or without "
                         "a terminal)")),
      rareUniversal(
          flag("json-errors", 0,
               "print errors, warnings and notes on stderr as JSON, one object per line")),
      universal(configRow()),
      rareUniversal(flag("print-config", 0,
                         "print the options in force, in the format of --config, and exit")),
      rareUniversal(flag("schema", 0, "print the schema of the streams and exit")),
      rareUniversal(choiceRow("completion", ValueType::choice, {"bash", "zsh", "fish"}, "",
                              "print a completion script for this shell and exit")),
      universal(flag("version", 0, "print version, commit and schema version, and exit")),
      universal(flag("help", 'h', "print this help and exit")),
      universal(flag("help-all", 0, "print help on all options and exit")),
      manualRow(),
  };
}

OptionRow outputRow() {
  OptionRow out = row("output", 'o', ValueType::file, "FILE",
                      "write to FILE, which appears only when the run is complete or interrupted");
  out.details = "- is standard output.";
  out.defaultText = "-";
  return grouped(std::move(out), kFilesGroup);
}

OptionRow formatRow() {
  OptionRow out =
      choiceRow("format", ValueType::choice, {"jsonl", "capnp", "packed"}, "",
                "output encoding [default: by the output file's extension, else jsonl]");
  out.details = "The extension .capnp means capnp, and .capnpp means packed.";
  return grouped(std::move(out), kFilesGroup);
}

OptionRow seedRow() {
  OptionRow out = row("seed", 0, ValueType::seed, "N", "random seed: same seed, same results");
  out.defaultText = "0";
  return grouped(std::move(out), kRunGroup);
}

OptionRow threadsRow() {
  OptionRow out =
      limited(row("threads", 0, ValueType::integer, "N", "threads to use; 0: all available CPUs"),
              0, 4096, "0");
  out.details = "Results do not depend on it.";
  return grouped(std::move(out), kRunGroup);
}

OptionRow backendRow() {
  return grouped(choiceRow("backend", ValueType::choice, {"auto", "cpu", "cuda"}, "auto",
                           "where worlds are simulated; results do not depend on it"),
                 kRunGroup);
}

OptionRow timeLimitRow() {
  return grouped(
      limited(row("time-limit", 0, ValueType::number, "SECONDS", "stop after this wall-clock time"),
              0, 1e9, ""),
      kRunGroup);
}

OptionRow progressRow() {
  OptionRow out = choiceRow("progress", ValueType::mode, {"auto", "line", "json", "none"}, "auto",
                            "progress on stderr; auto: a live line on a terminal, else nothing; "
                            "line: the same on a terminal, else a line every 10 s; json: JSON "
                            "objects");
  out.details =
      "A terminal that also shows the records gets no live line: auto prints nothing there, and "
      "line prints a line every 10 s. --progress alone means --progress=line.";
  out.bare = "line";
  return grouped(std::move(out), kHelpGroup);
}

OptionRow onErrorRow() {
  OptionRow out = choiceRow("on-error", ValueType::choice, {"stop", "skip", "emit"}, "stop",
                            "on a bad record: stop, skip it, or emit it unchanged");
  out.details = "The exit code is 2 in every case.";
  return grouped(std::move(out), kFilesGroup);
}

}  // namespace

OptionRow commonRow(Common option) {
  switch (option) {
    case Common::output: return outputRow();
    case Common::format: return formatRow();
    case Common::seed: return seedRow();
    case Common::threads: return threadsRow();
    case Common::backend: return backendRow();
    case Common::timeLimit: return timeLimitRow();
    case Common::progress: return progressRow();
    case Common::onError: return onErrorRow();
  }
  return {};
}

OptionRow withDefault(OptionRow row, std::string defaultText) {
  row.defaultText = std::move(defaultText);
  return row;
}

const std::vector<OptionRow>& universalRows() {
  static const std::vector<OptionRow> rows = makeUniversalRows();
  return rows;
}

}  // namespace obby::cli
