#include "cli/options.h"

#include <utility>

namespace obby::cli {
namespace {

constexpr const char* kUniversalGroup = "Help and messages";

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

OptionRow universal(OptionRow out) {
  out.group = kUniversalGroup;
  return out;
}

std::vector<OptionRow> makeUniversalRows() {
  OptionRow completion = choiceRow("completion", ValueType::choice, {"bash", "zsh", "fish"}, "",
                                   "print a completion script for that shell");
  return {
      universal(row("quiet", 'q', ValueType::flag, "", "no warnings and no progress on stderr")),
      universal(row("verbose", 'v', ValueType::flag, "", "say on stderr what is being done")),
      universal(row("no-color", 0, ValueType::flag, "",
                    "no colours (also: NO_COLOR set, TERM=dumb, no terminal)")),
      universal(row("json-errors", 0, ValueType::flag, "",
                    "errors, warnings and notes as JSON objects on stderr")),
      universal(row("config", 0, ValueType::file, "FILE",
                    "read options from FILE: lines `name = value`, 'text with blanks' in quotes, "
                    "several values in [brackets]; below [TOOL] those of one tool")),
      universal(row("print-config", 0, ValueType::flag, "",
                    "print the options in force, as --config reads them, and exit")),
      universal(row("schema", 0, ValueType::flag, "", "print the schema of the streams and exit")),
      universal(completion),
      universal(row("version", 0, ValueType::flag, "", "print the version and exit")),
      universal(row("help", 'h', ValueType::flag, "", "print this help and exit")),
  };
}

}  // namespace

OptionRow commonRow(Common option) {
  switch (option) {
    case Common::output: {
      OptionRow out = row("output", 'o', ValueType::file, "FILE",
                          "write to FILE, which appears when it is complete; - is standard output");
      out.defaultText = "-";
      return out;
    }
    case Common::format:
      return choiceRow("format", ValueType::choice, {"jsonl", "capnp", "packed"}, "",
                       "encoding of the output stream [default: by FILE's ending .capnp or "
                       ".capnpp, else jsonl]");
    case Common::seed: {
      OptionRow out = row("seed", 0, ValueType::seed, "N",
                          "seed of all random numbers; the same seed gives the same answers");
      out.defaultText = "0";
      return out;
    }
    case Common::threads:
      return limited(row("threads", 0, ValueType::integer, "N",
                         "threads to use, 0 for all that this process may use; the answers do not "
                         "depend on it"),
                     0, 4096, "0");
    case Common::backend:
      return choiceRow("backend", ValueType::choice, {"auto", "cpu", "cuda"}, "auto",
                       "where worlds are simulated; the answers do not depend on it");
    case Common::timeLimit:
      return limited(
          row("time-limit", 0, ValueType::number, "SECONDS", "stop after this wall-clock time"), 0,
          1e9, "");
    case Common::progress: {
      OptionRow out =
          choiceRow("progress", ValueType::mode, {"auto", "line", "json", "none"}, "auto",
                    "signs of life on stderr: redrawn on a terminal that gets no records, a line "
                    "each ten seconds, or JSON objects");
      out.bare = "line";
      return out;
    }
    case Common::onError:
      return choiceRow("on-error", ValueType::choice, {"stop", "skip", "emit"}, "stop",
                       "a bad record: stop, leave it out, or pass it on unchanged; the exit code "
                       "is 2 in every case");
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
