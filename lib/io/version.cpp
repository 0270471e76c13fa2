#include "io/version.h"

namespace obby::io {

const char* toolVersion() { return OBBY_VERSION; }

}  // namespace obby::io
