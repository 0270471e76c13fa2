// A small level whose parts have paths, tags and a GUID, for tests that name places.
#pragma once

#include "io/json_codec.h"

namespace obby::support {

inline io::RecordBuilder tower() {
  return *io::recordFromJson(
      R"({"type":"level","name":"tower","parts":[)"
      R"({"name":"Base","position":[0,0,0],"size":[8,1,8]},)"
      R"({"name":"Lava","position":[0,0,-10],"size":[2,1,2],"source":{"path":"Workspace/S1/Lava"},"tags":["Kill"]},)"
      R"({"name":"Lava","position":[0,0,-20],"size":[2,1,2],"source":{"path":"Workspace/S2/Lava"},"tags":["Kill","Hot"]},)"
      R"({"name":"Top","position":[0,9,-30],"size":[4,1,2],"rotation":[0,0,0.70710678,0.70710678],)"
      R"("source":{"path":"Workspace/S2/Top","guid":"AB12"},"checkpoint":{"stage":2}}],)"
      R"("spawns":[{"position":[0,0.5,0],"part":0}]})");
}

}  // namespace obby::support
