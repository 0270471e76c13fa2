// The option table of obby-view, and what it comes to.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"
#include "view/picture/picture.h"
#include "view/text_report.h"

namespace obby {

cli::ToolSpec viewSpec();

// Error: an option is typed that does nothing for what is written, or served.
Status refuseIdle(const cli::Arguments& arguments);

// Error: --size is none.
Result<view::PictureOptions> pictureOptions(const cli::Arguments& arguments);
view::TextOptions textOptions(const cli::Context& context);

}  // namespace obby
