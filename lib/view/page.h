// The report as one self-contained HTML file. docs/page-data.md describes its data.
#pragma once

#include <string>

#include "base/result.h"
#include "view/report.h"

namespace obby::view {

struct PageOptions {
  bool full = false;      // no thinning at any size
  std::string generator;  // "obby-view 0.1.0"
};

// Returns true if the build has the page bundle. pageMissing() is the error for one without it.
bool pageAvailable();
Error pageMissing();

// Pages of at least this size in bytes deserve a warning. The size includes the thinned
// data and the page itself.
inline constexpr size_t kPageWarning = 22u << 20;

// Returns the page's data as JSON, safe inside a script element.
std::string pageData(const Report& report, const PageOptions& options);

// Returns the whole page. Errors: a build without the bundle, or a page beyond the limit of
// budget.h.
Result<std::string> htmlPage(const Report& report, const PageOptions& options);

// Returns the page without data, which it requests from its server. Error: a build without the
// bundle.
Result<std::string> livePage();

}  // namespace obby::view
