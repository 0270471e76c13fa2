// The option table of obby-view, and its translation to lib/view's options.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"
#include "view/picture/picture.h"
#include "view/text_report.h"

namespace obby {

cli::ToolSpec viewSpec();

// Error: an option that has no effect on the output.
Status refuseIdle(const cli::Arguments& arguments);

// Error: an invalid --size.
Result<view::PictureOptions> pictureOptions(const cli::Arguments& arguments);
view::TextOptions textOptions(const cli::Context& context);

}  // namespace obby
