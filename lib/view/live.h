// obby-view --live: a page on the loopback interface that shows a stream as it arrives.
//
// There are two threads. The reading thread, created here, adds records to the GrowingReport and
// replays them. The caller's thread runs the event loop. Several times a second it copies changes
// into the LiveData, which it owns, and serves pages from there.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "base/result.h"
#include "view/growing_report.h"
#include "view/page.h"

namespace obby::view {

struct LiveOptions {
  uint16_t port = 0;          // 0: any free port
  bool endWithPages = false;  // end when the stream has ended and no page is open
  PageOptions page;
};

// Messages for users, one line each without a newline.
struct LiveReports {
  std::function<void(const std::string&)> address;  // the address of the page
  std::function<void(const std::string&)> note;     // details, for a verbose mode
};

// Reads the stream into the report until its end, and calls GrowingReport::end(), or stops early if
// `halt` is set.
using LiveReader = std::function<void(const std::atomic<bool>& halt)>;

// Serves until `stop` is set. Errors: the port is not available, the build has no page, or the
// event loop fails.
Status serveLive(GrowingReport& report, const LiveReader& read, const LiveOptions& options,
                 const std::atomic<bool>& stop, const LiveReports& reports);

}  // namespace obby::view
