// Splits records of any size into messages of bounded size.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace obby::bridge {

// Returns the messages that carry one record of a job, in order. This is one message
// `{"job":"j1","type":"record","record":{...}}`. If that is longer than `limit` bytes, there are
// several `{"job":"j1","type":"fragment","index":0,"count":3,"text":"..."}` whose joined texts are
// the record's JSON. `record` is JSON; limit >= 1024.
std::vector<std::string> recordMessages(std::string_view job, std::string_view record,
                                        uint64_t limit);

}  // namespace obby::bridge
