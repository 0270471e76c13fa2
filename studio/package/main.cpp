// package FOLDER FILE: writes the plugin in FOLDER as a model file; the build calls it.
#include <cstdio>
#include <fstream>

#include "package/package.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s FOLDER FILE\n", argv[0]);
    return 2;
  }
  const auto plugin = obby::studio::packagePlugin(argv[1]);
  if (!plugin) {
    std::fprintf(stderr, "%s\n", plugin.error().text().c_str());
    return 2;
  }
  std::ofstream file(argv[2], std::ios::binary);
  file << *plugin << std::flush;
  if (!file) {
    std::fprintf(stderr, "%s cannot be written\n", argv[2]);
    return 2;
  }
  return 0;
}
