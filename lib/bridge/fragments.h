// Messages of bounded size out of records of any size.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace obby::bridge {

// The members of the messages that carry one record of a job, in order: one message
// `"job":"j1","type":"record","record":{...}`, or where that is longer than `limit` bytes several
// `"job":"j1","type":"fragment","index":0,"count":3,"text":"..."` whose texts, joined, are the
// record's JSON. `record` is JSON; limit >= 1024.
std::vector<std::string> recordMessages(std::string_view job, std::string_view record,
                                        uint64_t limit);

}  // namespace obby::bridge
