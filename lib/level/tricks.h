// Converts tricks between records, options and Params::tricks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/params.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Returns bits of Params::tricks. A trick of a later schema is an error at `path`.
Result<uint16_t> tricksOf(capnp::List<schema::Trick>::Reader list, const std::string& path);

// Returns "none", then the tricks in the schema's order as options spell them ("held-jump"), then
// "all".
std::vector<std::string> trickOptions();

// Returns the bits of these options. An unknown name is an error.
Result<uint16_t> tricksNamed(const std::vector<std::string>& options);

// Returns the name as words: "held jump".
std::string trickName(schema::Trick trick);

// Returns the tricks of some bits, in the schema's order.
std::vector<schema::Trick> tricksIn(uint16_t bits);

// Sets the field `tricks` of a record. Leaves it absent for no tricks.
template <class Record>
void setTricks(Record record, uint16_t bits) {
  if (bits == 0) return;
  const std::vector<schema::Trick> tricks = tricksIn(bits);
  auto list = record.initTricks(uint32_t(tricks.size()));
  for (uint32_t i = 0; i < list.size(); ++i) list.set(i, tricks[i]);
}

}  // namespace obby::level
