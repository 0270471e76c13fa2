// The pieces of the page's data.
#pragma once

#include "view/budget.h"
#include "view/json_text.h"
#include "view/report.h"

namespace obby::view {

void writeLevel(JsonText& json, const LevelEntry& entry, uint32_t ticksShown, uint32_t trackStride);
void writeQuery(JsonText& json, const QueryEntry& entry, const Budget& budget);

}  // namespace obby::view
