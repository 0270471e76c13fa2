// The bridge as a whole: serves until it is told to end.
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
  uint16_t port = 0;       // 0: any free one
  bool pair = false;       // offer a code
  bool needToken = true;   // false: whoever runs a program on this machine may ask
  double idleSeconds = 0;  // ends when nobody was there for so long; 0: never
  std::string stateDir;    // folder of its own, made if need be
  std::string solve;       // obby-solve; empty: the one beside this program
};

// What is said to people; each a line without its newline.
struct Reports {
  std::function<void(const std::string&)> say;  // where it listens, the code
  std::function<void(const std::string&)> warn;
  std::function<void(const std::string&)> note;  // for those who want to know everything
};

// Over HTTP. Ends well when `stop` is set: jobs are interrupted and waited for. Errors: the port,
// the folder, the programs.
Status serveHttp(const Options& options, const std::atomic<bool>& stop, const Reports& reports);

// Over standard input and `output`; ends with the input, too.
Status serveStdio(const Options& options, const std::atomic<bool>& stop, const Reports& reports,
                  io::Sink output);

}  // namespace obby::bridge
