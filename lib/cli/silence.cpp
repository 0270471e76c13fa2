#include "cli/silence.h"

#include <fcntl.h>
#include <unistd.h>

namespace obby::cli {

Silence::Silence(int descriptor) : descriptor_(descriptor), kept_(dup(descriptor)) {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, descriptor_);
  close(nowhere);
}

Silence::~Silence() {
  dup2(kept_, descriptor_);
  close(kept_);
}

}  // namespace obby::cli
