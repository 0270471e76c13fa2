// The report as one self-contained HTML file. docs/page-data.md describes its data.
#pragma once

#include <string>

#include "base/result.h"
#include "view/report.h"

namespace obby::view {

struct PageOptions {
  bool full = false;      // thin nothing out, whatever the size
  std::string generator;  // "obby-view 0.1.0"
};

// True in a build with the page bundle; pageMissing() says what to do about one without.
bool pageAvailable();
Error pageMissing();

// Bytes from which on a page deserves a warning: the data is thinned to less, the rest is the
// page's own.
inline constexpr size_t kPageWarning = 22u << 20;

// The page's data as JSON, safe inside a script element.
std::string pageData(const Report& report, const PageOptions& options);

// The whole page. Errors: a build without the bundle; a page over the limit of budget.h.
Result<std::string> htmlPage(const Report& report, const PageOptions& options);

// The page without data: it asks the server that it came from for them. Error: a build without the
// bundle.
Result<std::string> livePage();

}  // namespace obby::view
