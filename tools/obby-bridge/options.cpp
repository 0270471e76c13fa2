// The option table of obby-bridge, and its translation to lib/bridge's options.
#include "options.h"

#include <fmt/format.h>

#include <cstdlib>

#include "cli/rows.h"

namespace obby::tools {
namespace {

using bridge::kMiB;
using cli::between;
using cli::flagRow;
using cli::OptionRow;
using cli::rare;
using cli::row;
using cli::ValueType;

constexpr const char* kClients = "Connections";
constexpr const char* kJobs = "Searches and calibrations";
constexpr const char* kLimits = "Limits";
constexpr const char* kPort = "34990";  // the port that clients try

// Makes an option for a limit, with the library's default.
OptionRow limitRow(const char* name, const char* value, double fallback, const char* help,
                   double min, double max) {
  const bool whole = std::string(value) != "SECONDS";
  return rare(between(row(name, whole ? ValueType::integer : ValueType::number, value,
                          fmt::format("{:g}", fallback).c_str(), help, kLimits),
                      min, max));
}

std::vector<OptionRow> limitRows() {
  const bridge::Limits d;
  return {
      limitRow("max-body", "MIB", double(d.bodyBytes / kMiB),
               "maximum size of a request; after decompression, four times this", 1, 1024),
      limitRow("memory", "MIB", double(d.memoryBytes / kMiB),
               "maximum address space of each program that the bridge starts; 0: no limit", 0, 1e6),
      limitRow("cpu-time", "SECONDS", double(d.cpuSeconds),
               "CPU time after which a program that the bridge started is interrupted", 1, 1e6),
      limitRow("request-timeout", "SECONDS", d.requestSeconds,
               "maximum time for a request to arrive and for its answer to be read", 0.1, 3600),
      limitRow("ping", "SECONDS", d.pingSeconds, "time between pings on a WebSocket", 0.1, 3600),
      limitRow("silence", "SECONDS", d.silenceSeconds,
               "close a WebSocket when its client has sent nothing for this long", 0.1, 3600),
      limitRow("grace", "SECONDS", d.graceSeconds,
               "cancel a client's jobs this long after --silence has passed", 0.1, 3600),
  };
}

std::string stateDir(const cli::Arguments& a) {
  if (a.has("state-dir")) return a.text("state-dir");
  const auto variable = [](const char* name) {
    const char* value = getenv(name);
    return std::string(value ? value : "");
  };
  // The XDG base directory rules ignore a relative path.
  if (const std::string state = variable("XDG_STATE_HOME"); !state.empty() && state[0] == '/') {
    return state + "/obby";
  }
  const std::string home = variable("HOME");
  return home.empty() ? "" : home + "/.local/state/obby";
}

// Returns the first option given that only a server uses, or an empty text.
std::string askedOfServer(const cli::Arguments& a) {
  for (const char* name : {"pair", "no-token", "port"}) {
    if (a.typed(name)) return name;
  }
  return {};
}

}  // namespace

cli::ToolSpec bridgeSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-bridge";
  spec.summary = "let Roblox Studio and other editors run searches and calibrations";
  spec.takesInputs = false;
  spec.examples = {
      {"Serve editors on this machine, and show a code for pairing a new editor",
       "obby-bridge --pair"},
      {"Serve until no editor has been connected for ten minutes", "obby-bridge --pair --idle 600"},
      {"Serve a program through standard input and output, one JSON request per line",
       "echo '{\"id\":1,\"method\":\"GET\",\"path\":\"/v1/info\"}' | obby-bridge --stdio"},
  };
  spec.options = {
      between(row("port", ValueType::integer, "PORT", kPort,
                  "listen on this port of the loopback interface; 0: on any free one", kClients),
              0, 65535),
      flagRow("pair", "show a code for pairing one new client", kClients),
      flagRow("no-token", "require no token: any program on this machine may send requests",
              kClients),
      flagRow("stdio", "serve the program that started this one, over standard input and output",
              kClients),
      between(row("idle", ValueType::number, "SECONDS", "0",
                  "exit when no client has been connected for this long; 0: never", kClients),
              0, 1e9),
      between(row("jobs", ValueType::integer, "N", "2",
                  "maximum number of searches and calibrations at a time", kJobs),
              1, 64),
      row("solve", ValueType::file, "PATH", "",
          "path of the obby-solve program to run [default: the one next to this program]", kJobs),
      row("state-dir", ValueType::file, "DIR", "",
          "folder for tokens, levels and answers [default: $XDG_STATE_HOME/obby, "
          "else ~/.local/state/obby]",
          kJobs),
  };
  for (OptionRow& limit : limitRows()) spec.options.push_back(std::move(limit));
  spec.notes =
      "Requests are accepted from this machine only, never from web pages, and only with the "
      "token of a paired client, unless --no-token is given. docs/bridge.md describes the "
      "protocol.";
  spec.files = {{"~/.local/state/obby",
                 "Tokens, levels and answers. If XDG_STATE_HOME is set, the folder is "
                 "$XDG_STATE_HOME/obby; --state-dir sets another one."}};
  return spec;
}

Result<bridge::Options> bridgeOptions(const cli::Context& context) {
  constexpr const char* kOneOfTwo = "leave out one of the two";
  const cli::Arguments& a = context.arguments();
  if (const std::string other = askedOfServer(a); a.flag("stdio") && !other.empty()) {
    return Error{{}, {}, "--stdio", fmt::format("cannot be combined with --{}", other), kOneOfTwo};
  }
  if (a.typed("pair") && a.flag("no-token")) {
    return Error{{}, {}, "--pair", "cannot be combined with --no-token", kOneOfTwo};
  }
  bridge::Options out;
  out.port = uint16_t(a.integer("port"));
  out.pair = a.flag("pair");
  out.needToken = !a.flag("no-token");
  out.idleSeconds = a.number("idle");
  out.solve = a.text("solve");
  out.stateDir = stateDir(a);
  if (out.stateDir.empty()) {
    return Error{{},
                 {},
                 "--state-dir",
                 "neither XDG_STATE_HOME nor HOME is set",
                 "give --state-dir DIR, a folder for tokens, levels and answers"};
  }
  bridge::Limits& l = out.limits;
  l.jobs = uint32_t(a.integer("jobs"));
  l.bodyBytes = uint64_t(a.integer("max-body")) * kMiB;
  l.inflatedBytes = 4 * l.bodyBytes;
  l.memoryBytes = uint64_t(a.integer("memory")) * kMiB;
  l.cpuSeconds = uint64_t(a.number("cpu-time"));
  l.requestSeconds = a.number("request-timeout");
  l.pingSeconds = a.number("ping");
  l.silenceSeconds = a.number("silence");
  l.graceSeconds = a.number("grace");
  return out;
}

}  // namespace obby::tools
