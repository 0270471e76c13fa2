#include "io/read_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace obby::io {

namespace {

Error fileError(const std::string& path, const std::string& message) {
  Error error = makeError(message + std::strerror(errno));
  error.input = path == "-" ? "stdin" : path;
  return error;
}

struct Close {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};

}  // namespace

Result<std::string> readFile(const std::string& path) {
  const std::unique_ptr<std::FILE, Close> file(path == "-" ? stdin
                                                           : std::fopen(path.c_str(), "rb"));
  if (!file) return fileError(path, "cannot open: ");
  std::string bytes;
  char buffer[1 << 16];
  while (const size_t got = std::fread(buffer, 1, sizeof buffer, file.get()))
    bytes.append(buffer, got);
  if (std::ferror(file.get())) return fileError(path, "cannot read: ");
  return bytes;
}

}  // namespace obby::io
