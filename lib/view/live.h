// obby-view --live: a page on the loopback interface that shows a stream as it comes.
//
// Two threads. The one that reads, made here, folds records into the GrowingReport and replays
// them. The caller's runs the event loop: some times a second it takes what has changed into the
// LiveData, which it alone has, and serves pages from that.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "base/result.h"
#include "view/growing_report.h"
#include "view/page.h"

namespace obby::view {

struct LiveOptions {
  uint16_t port = 0;          // 0: any free one
  bool endWithPages = false;  // ends when the stream has ended and no page is open
  PageOptions page;
};

// What is said to people, a line each, without its newline.
struct LiveReports {
  std::function<void(const std::string&)> address;  // that opens the page
  std::function<void(const std::string&)> note;     // for those who want to know everything
};

// Reads the stream into the report, up to GrowingReport::end(), or until `halt` is set.
using LiveReader = std::function<void(const std::atomic<bool>& halt)>;

// Serves until `stop` is set. Errors: the port; a build without the page; the event loop fails.
Status serveLive(GrowingReport& report, const LiveReader& read, const LiveOptions& options,
                 const std::atomic<bool>& stop, const LiveReports& reports);

}  // namespace obby::view
