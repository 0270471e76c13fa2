#include "cli/written_files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "io/output_file.h"

namespace obby::cli {
namespace {

// The identity of a file.
struct Place {
  bool there = true, regular = false;
  dev_t device = 0;
  ino_t number = 0;
  std::filesystem::path path;  // path of a file that does not exist, with links resolved

  bool operator==(const Place& other) const {
    if (there != other.there) return false;
    if (!there) return path == other.path;
    return regular && other.regular && device == other.device && number == other.number;
  }
};

// `standard` is the stream that "-" means.
Place placeOf(const std::string& path, int standard) {
  Place out;
  struct stat info {};
  const bool isStream = path == "-";
  if ((isStream ? fstat(standard, &info) : stat(path.c_str(), &info)) == 0) {
    out.regular = S_ISREG(info.st_mode);
    out.device = info.st_dev;
    out.number = info.st_ino;
  } else if (!isStream) {
    out.there = false;
    std::error_code unseen;
    const auto here = std::filesystem::current_path(unseen);
    const std::string file = io::linkTarget(path);  // a link to a missing file stands for that file
    out.path = std::filesystem::weakly_canonical(here / file, unseen);
    if (unseen) out.path = std::filesystem::path(file).lexically_normal();
  }
  return out;
}

// A file that must not be replaced, and the words that follow "the file is also" in the error.
struct Kept {
  std::string said;
  Place place;
};

std::vector<Kept> readBy(const Arguments& arguments, std::span<const WrittenFile> written) {
  std::vector<Kept> out;
  for (const std::string& input : arguments.inputs)
    out.push_back({"an input", placeOf(input, STDIN_FILENO)});
  for (const auto& option : arguments.values) {
    const Arguments::Value& value = option.second;
    if (value.row.type != ValueType::file || value.row.renewed || !value.given) continue;
    const auto isIt = [&](const WrittenFile& file) { return file.option == option.first; };
    if (std::any_of(written.begin(), written.end(), isIt)) continue;
    for (const std::string& path : value.texts) {
      if (!path.empty()) out.push_back({"used by --" + option.first, placeOf(path, STDIN_FILENO)});
    }
  }
  return out;
}

}  // namespace

Status refuseOverwriting(const Arguments& arguments, std::span<const WrittenFile> written) {
  std::vector<Kept> kept = readBy(arguments, written);
  for (const WrittenFile& file : written) {
    if (file.path.empty()) continue;
    const bool standard = file.path == "-";
    Place place = placeOf(file.path, STDOUT_FILENO);
    const auto same = std::find_if(kept.begin(), kept.end(),
                                   [&](const Kept& other) { return other.place == place; });
    if (same != kept.end()) {
      return Error{{},
                   {},
                   standard ? std::string() : "--" + file.option,
                   (standard ? "standard output is redirected to a file that is also "
                             : fmt::format("'{}' is also ", file.path)) +
                       same->said,
                   standard ? "write to another file" : "name another file"};
    }
    kept.push_back({standard ? "used by standard output" : fmt::format("used by --{}", file.option),
                    std::move(place)});
  }
  return {};
}

}  // namespace obby::cli
