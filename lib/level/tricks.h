// Tricks as records name them and as Params::tricks holds them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/params.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Bits of Params::tricks. Those of a later schema are an error at `path`.
Result<uint16_t> tricksOf(capnp::List<schema::Trick>::Reader list, const std::string& path);

// "none", then the tricks in the order of the schema as options spell them, as in "held-jump", then
// "all".
std::vector<std::string> trickOptions();

// Bits of those. Error: a name that is none of them.
Result<uint16_t> tricksNamed(const std::vector<std::string>& options);

// The tricks of some bits, in the order of the schema.
std::vector<schema::Trick> tricksIn(uint16_t bits);

// Record: one with a field `tricks`. Leaves an absent field for no tricks.
template <class Record>
void setTricks(Record record, uint16_t bits) {
  if (bits == 0) return;
  const std::vector<schema::Trick> tricks = tricksIn(bits);
  auto list = record.initTricks(uint32_t(tricks.size()));
  for (uint32_t i = 0; i < list.size(); ++i) list.set(i, tricks[i]);
}

}  // namespace obby::level
