// package FOLDER COURSE FILE: writes the plugin in FOLDER and the calibration course to a model
// file. The build calls it.
#include <cstdio>
#include <fstream>

#include "package/package.h"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s FOLDER COURSE FILE\n", argv[0]);
    return 2;
  }
  const auto plugin = obby::studio::packagePlugin(argv[1], argv[2]);
  if (!plugin) {
    std::fprintf(stderr, "%s\n", plugin.error().text().c_str());
    return 2;
  }
  std::ofstream file(argv[3], std::ios::binary);
  file << *plugin << std::flush;
  if (!file) {
    std::fprintf(stderr, "%s cannot be written\n", argv[3]);
    return 2;
  }
  return 0;
}
