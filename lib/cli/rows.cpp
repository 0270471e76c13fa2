#include "cli/rows.h"

namespace obby::cli {
namespace {

OptionRow hidden(OptionRow r) {
  r.hidden = true;
  return r;
}

OptionRow universalFlag(const char* name, const char* help) {
  return flagRow(name, help, kHelpGroup);
}

OptionRow configRow() {
  return detailed(
      row("config", ValueType::file, "FILE", "",
          "read options from FILE, one `name = value` per line; a section such as "
          "[obby-solve] is for that tool only",
          kHelpGroup),
      "Put text that contains spaces in 'quotes' and several values in [brackets]. Options above "
      "the first section are for every tool.");
}

std::vector<OptionRow> makeUniversalRows() {
  return {
      lettered(universalFlag("quiet", "print no warnings and no progress on stderr"), 'q'),
      lettered(universalFlag("verbose", "also print notes about the run on stderr"), 'v'),
      rare(universalFlag("no-color",
                         "print no colours (the default if NO_COLOR is set, TERM is dumb or the "
                         "output is not a terminal)")),
      rare(universalFlag("json-errors",
                         "print errors, warnings and notes on stderr as JSON, one object per "
                         "line")),
      configRow(),
      rare(universalFlag("print-config",
                         "print the effective options in the format of --config and exit")),
      rare(universalFlag("schema", "print the schema of the streams and exit")),
      rare(choosing(row("completion", ValueType::choice, "", "",
                        "print a completion script for this shell and exit", kHelpGroup),
                    {"bash", "zsh", "fish"})),
      universalFlag("version", "print version, commit and schema version, and exit"),
      lettered(universalFlag("help", "print this help and exit"), 'h'),
      universalFlag("help-all", "print help on all options and exit"),
      hidden(universalFlag("man", "print the manual page and exit")),
  };
}

OptionRow outputRow() {
  return lettered(detailed(row("output", ValueType::file, "FILE", "-",
                               "write to FILE, which is created when the run ends", kFilesGroup),
                           "- is standard output."),
                  'o');
}

OptionRow formatRow() {
  return detailed(
      choosing(
          row("format", ValueType::choice, "", "",
              "output encoding [default: by the output file's extension, else jsonl]", kFilesGroup),
          {"jsonl", "capnp", "packed"}),
      "The extension .capnp means capnp, and .capnpp means packed.");
}

OptionRow seedRow() {
  return row("seed", ValueType::seed, "N", "0", "random seed: same seed, same results", kRunGroup);
}

OptionRow threadsRow() {
  return detailed(between(row("threads", ValueType::integer, "N", "0",
                              "threads to use; 0: all available CPUs", kRunGroup),
                          0, 4096),
                  "Results do not depend on the number of threads.");
}

OptionRow backendRow() {
  return choosing(row("backend", ValueType::choice, "", "auto",
                      "device that simulates worlds; results do not depend on it", kRunGroup),
                  {"auto", "cpu", "cuda"});
}

OptionRow timeLimitRow() {
  return between(row("time-limit", ValueType::number, "SECONDS", "",
                     "stop after this wall-clock time", kRunGroup),
                 0, 1e9);
}

OptionRow progressRow() {
  OptionRow out =
      choosing(row("progress", ValueType::mode, "", "auto",
                   "progress on stderr; auto: a live line on a terminal, else none; line: a "
                   "live line on a terminal, else one every 10 s; json: JSON objects",
                   kHelpGroup),
               {"auto", "line", "json", "none"});
  out.details =
      "A terminal that also shows the records gets no live line: auto prints nothing there, and "
      "line prints a line every 10 s. --progress alone means --progress=line.";
  out.bare = "line";
  return out;
}

OptionRow onErrorRow() {
  return detailed(choosing(row("on-error", ValueType::choice, "", "stop",
                               "on a bad record: stop, skip it, or emit it unchanged", kFilesGroup),
                           {"stop", "skip", "emit"}),
                  "The exit code is 2 in every case.");
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

std::vector<OptionRow> joined(std::initializer_list<std::vector<OptionRow>> groups) {
  std::vector<OptionRow> rows;
  for (const std::vector<OptionRow>& group : groups)
    rows.insert(rows.end(), group.begin(), group.end());
  return rows;
}

const std::vector<OptionRow>& universalRows() {
  static const std::vector<OptionRow> rows = makeUniversalRows();
  return rows;
}

}  // namespace obby::cli
