// A policy in a level: all that a decision needs beside the level, the query and the world.
#pragma once

#include "policy/network.h"

namespace obby::policy {

// Plain data, for device code.
struct PolicyView {
  SurroundingsView surroundings;
  NetworkView network;
};

template <class Table>
OBBY_DEVICE void forTables(PolicyView& p, Table&& table) {
  forTables(p.surroundings, table);
  forTables(p.network, table);
}

}  // namespace obby::policy
