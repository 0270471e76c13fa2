#include "bridge/reply.h"

#include "bridge/json.h"

namespace obby::bridge {

Reply refuse(int status, const Error& error) {
  JsonObject out;
  out.text("error", error.message);
  if (!error.hint.empty()) out.text("cure", error.hint);
  if (!error.place.empty()) out.text("place", error.place);
  if (!error.path.empty()) out.text("path", error.path);
  return {status, out.whole()};
}

}  // namespace obby::bridge
