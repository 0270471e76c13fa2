#include "io/lost_level.h"

#include <capnp/serialize.h>
#include <kj/exception.h>

#include "base/spelling.h"
#include "io/schema_plan.h"

namespace obby::io {

namespace {

std::string_view behindBlanks(std::string_view text) {
  const size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

}  // namespace

// Searches the text, because a line that is cut off or not JSON may still begin like a level.
bool mayBeLevel(std::string_view line) {
  constexpr std::string_view kMember = "\"type\"", kLevel = "level";
  const std::vector<std::string> kinds = recordPlan().names();
  bool other = false;
  for (size_t at = line.find(kMember); at != std::string_view::npos; at = line.find(kMember)) {
    line.remove_prefix(at + kMember.size());
    const std::string_view colon = behindBlanks(line);
    if (!colon.starts_with(':')) continue;
    const std::string_view value = behindBlanks(colon.substr(1));
    if (!value.starts_with('"')) continue;
    const std::string_view kind = value.substr(1, value.find('"', 1) - 1);
    if (kind.starts_with(kLevel) || nearestName(kind, kinds) == kLevel) return true;
    other = true;
  }
  return !other;
}

bool mayBeLevel(const std::vector<uint64_t>& words) {
  try {
    capnp::FlatArrayMessageReader message(
        kj::arrayPtr(reinterpret_cast<const capnp::word*>(words.data()), words.size()));
    return message.getRoot<schema::Record>().isLevel();
  } catch (const kj::Exception&) {
    return true;
  }
}

bool namesNoLevel(const Record& record) {
  if (!record.known()) return false;
  const schema::Record::Reader r = record.reader();
  switch (r.which()) {
    case Kind::QUERY: return r.getQuery().getLevel().size() == 0;
    case Kind::RESULT: return r.getResult().getLevel().size() == 0;
    case Kind::TRAJECTORY: return r.getTrajectory().getLevel().size() == 0;
    case Kind::PROGRESS:
      return r.getProgress().hasBest() && r.getProgress().getBest().getLevel().size() == 0;
    default: return false;
  }
}

}  // namespace obby::io
