// Stands in for the viewer page in a build without npm: there is no template, and obby-view says
// so.
#include "view/page_template.h"

namespace obby::view {
std::span<const std::string_view> pageTemplate() { return {}; }
}  // namespace obby::view
