// The bridge as a whole. It serves until it is stopped.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "base/result.h"
#include "bridge/limits.h"
#include "io/sink.h"

namespace obby::bridge {

struct Options {
  Limits limits;
  uint16_t port = 0;       // 0 for any free port
  bool pair = false;       // offer a pairing code
  bool needToken = true;   // if false, any program on this machine may use the bridge
  double idleSeconds = 0;  // the bridge ends after this time without a client; 0 for never
  std::string stateDir;    // the bridge's own folder, made if needed
  std::string solve;       // path of obby-solve; empty for the one next to this program
};

// Reports to users, each a line without its newline.
struct Reports {
  std::function<void(const std::string&)> say;  // address and pairing code
  std::function<void(const std::string&)> warn;
  std::function<void(const std::string&)> note;  // receives verbose output
};

// Serves over HTTP. Ends without an error when `stop` is set: jobs are interrupted and waited for.
// Errors: the port, the folder or a program cannot be used.
Status serveHttp(const Options& options, const std::atomic<bool>& stop, const Reports& reports);

// Serves over standard input and `output`. Also ends when the input ends.
Status serveStdio(const Options& options, const std::atomic<bool>& stop, const Reports& reports,
                  io::Sink output);

}  // namespace obby::bridge
