#include "bridge/reply.h"

#include "io/json_writer.h"

namespace obby::bridge {

Reply refuse(int status, const Error& error) {
  io::JsonWriter out;
  out.open('{').field("error", error.message);
  if (!error.hint.empty()) out.field("cure", error.hint);
  if (!error.place.empty()) out.field("place", error.place);
  if (!error.path.empty()) out.field("path", error.path);
  return {status, out.finish()};
}

}  // namespace obby::bridge
