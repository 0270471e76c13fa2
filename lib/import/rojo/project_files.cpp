#include "import/rojo/project_files.h"

#include <algorithm>

#include "io/read_file.h"

namespace obby::importer::rojo {
namespace {

bool isBelow(const fs::path& path, const fs::path& root) {
  return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

Error fileError(const fs::path& path, std::string message, std::string hint = {}) {
  return Error{path.string(), {}, {}, std::move(message), std::move(hint)};
}

}  // namespace

void ProjectFiles::allow(const fs::path& path) {
  std::error_code error;
  fs::path root = fs::canonical(path, error);
  if (!error) roots_.push_back(std::move(root));
}

bool ProjectFiles::isFolder(const fs::path& path) const {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool ProjectFiles::isFile(const fs::path& path) const {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool ProjectFiles::enter(const fs::path& folder) {
  std::error_code error;
  fs::path real = fs::canonical(folder, error);
  if (!error && std::find(open_.begin(), open_.end(), real) != open_.end()) return false;
  open_.push_back(std::move(real));
  return true;
}

Status ProjectFiles::check(const fs::path& path) const {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error) return fileError(path, "cannot be read: " + error.message());
  const bool isIn = std::any_of(roots_.begin(), roots_.end(),
                                [&](const fs::path& root) { return isBelow(real, root); });
  if (isIn) return {};
  return fileError(path, "leads out of the project's folder to " + real.string(),
                   "if it belongs to the project, add it as a $path in default.project.json");
}

Result<std::vector<std::string>> ProjectFiles::list(const fs::path& folder) {
  OBBY_RETURN_IF_ERROR(check(folder));
  std::error_code error;
  std::vector<std::string> names;
  fs::directory_iterator at(folder, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    if (filesLeft_-- == 0) {
      filesLeft_ = 0;
      return fileError(folder, "the project has more than 100,000 files");
    }
    names.push_back(at->path().filename().string());
  }
  if (error) return fileError(folder, "cannot be read: " + error.message());
  std::sort(names.begin(), names.end());
  return names;
}

Result<std::string> ProjectFiles::read(const fs::path& file) {
  OBBY_RETURN_IF_ERROR(check(file));
  OBBY_ASSIGN(std::string bytes, io::readFile(file.string(), stop_, bytesLeft_));
  bytesLeft_ -= std::min<uint64_t>(bytesLeft_, bytes.size());
  return bytes;
}

std::string withUnixLines(std::string text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i)
    if (text[i] != '\r' || text.substr(i, 2) != "\r\n") out += text[i];
  return out;
}

}  // namespace obby::importer::rojo
