#include "package/package.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "bridge/limits.h"
#include "io/place_xml.h"
#include "io/read_file.h"
#include "io/version.h"

namespace obby::studio {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEntry = "init.server.luau";
constexpr const char* kEnding = ".luau";

void open(io::PlaceXml& xml, const char* className, const std::string& name,
          std::string_view source = {}) {
  xml.begin(className, name);
  if (!source.empty()) xml.source(source);
  xml.endProperties();
}

std::string versionModule() {
  return fmt::format(
      "--!strict\n-- The tools that this plugin was built with, and the protocol of their bridge.\n"
      "return table.freeze({{ version = \"{}\", protocol = {} }})\n",
      io::toolVersion(), bridge::kProtocol);
}

// Returns a module with the text of the calibration course. The plugin parses it when needed.
Result<std::string> courseModule(const std::string& file) {
  OBBY_ASSIGN(const std::string text, io::readFile(file));
  return fmt::format(
      "--!strict\n-- The calibration course and its manoeuvres, records a line each.\n"
      "return table.freeze({{ text = [==[\n{}]==] }})\n",
      text);
}

Status addFolder(io::PlaceXml& xml, const fs::path& folder);

Status addEntry(io::PlaceXml& xml, const fs::directory_entry& entry) {
  if (entry.is_directory()) {
    open(xml, "Folder", entry.path().filename());
    OBBY_RETURN_IF_ERROR(addFolder(xml, entry.path()));
    xml.end();
    return {};
  }
  if (entry.path().extension() != kEnding || entry.path().filename() == kEntry) return {};
  OBBY_ASSIGN(const std::string source, io::readFile(entry.path().string()));
  open(xml, "ModuleScript", entry.path().stem(), source);
  xml.end();
  return {};
}

Status addFolder(io::PlaceXml& xml, const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::directory_entry> entries;
  for (const auto& entry : fs::directory_iterator(folder, failed)) entries.push_back(entry);
  if (failed) return Error{folder.string(), {}, {}, failed.message(), {}};
  std::sort(entries.begin(), entries.end());
  for (const auto& entry : entries) OBBY_RETURN_IF_ERROR(addEntry(xml, entry));
  return {};
}

}  // namespace

Result<std::string> packagePlugin(const std::string& folder, const std::string& course) {
  OBBY_ASSIGN(const std::string courseText, courseModule(course));
  OBBY_ASSIGN(const std::string entry, io::readFile((fs::path(folder) / kEntry).string()));
  std::string items = io::kXmlBegin;
  io::PlaceXml xml(items);
  open(xml, "Script", "obby", entry);
  OBBY_RETURN_IF_ERROR(addFolder(xml, folder));
  open(xml, "ModuleScript", "version", versionModule());
  xml.end();
  open(xml, "ModuleScript", "courseText", courseText);
  xml.end();
  xml.end();
  return items + io::kXmlEnd;
}

}  // namespace obby::studio
