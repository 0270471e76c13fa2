// Matches globs by the set of reachable places in the pattern. The time is at most the pattern's
// length times the path's.
#include "import/rojo/globs.h"

namespace obby::importer::rojo {
namespace {

// Marks the places reachable from `at` without a character of the path: stars may match nothing.
void reach(std::string_view glob, size_t at, std::vector<char>& places) {
  while (places[at] == 0) {
    places[at] = 1;
    if (at >= glob.size() || glob[at] != '*') return;
    if (glob.substr(at, 3) == "**/") reach(glob, at + 3, places);
    at += glob.substr(at, 2) == "**" ? 2 : 1;
  }
}

}  // namespace

bool matchesGlob(std::string_view glob, std::string_view path) {
  std::vector<char> now(glob.size() + 1, 0);
  reach(glob, 0, now);
  for (const char c : path) {
    std::vector<char> next(glob.size() + 1, 0);
    for (size_t at = 0; at < glob.size(); ++at) {
      if (now[at] == 0) continue;
      if (glob[at] == '*') {
        if (c != '/' || glob.substr(at, 2) == "**") reach(glob, at, next);
      } else if (glob[at] == c || (glob[at] == '?' && c != '/')) {
        reach(glob, at + 1, next);
      }
    }
    now.swap(next);
  }
  return now[glob.size()] != 0;
}

bool isIgnored(const std::vector<std::string>& globs, std::string_view path) {
  bool ignored = false;
  for (std::string_view glob : globs) {
    const bool takesBack = glob.starts_with('!');
    if (takesBack) glob.remove_prefix(1);
    if (matchesGlob(glob, path)) ignored = !takesBack;
  }
  return ignored;
}

}  // namespace obby::importer::rojo
