#include "bridge/secrets.h"

#include <errno.h>
#include <sys/stat.h>

#include "io/byte_source.h"
#include "io/output_file.h"
#include "io/read_file.h"
#include "io/sink.h"
#include "loopback/secrets.h"

namespace obby::bridge {
namespace {

using loopback::equalInConstantTime;
using loopback::kTokenBytes;
using loopback::randomBytes;
using loopback::randomHex;

constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789";
static_assert(kLetters.size() == 32, "five bits a letter, all alike");

// Returns a typed code in the form in which it is stored.
std::string plain(std::string_view typed) {
  std::string out;
  for (const char c : typed) {
    if (c == '-' || c == ' ') continue;
    out += c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
  }
  return out;
}

bool isToken(std::string_view text) {
  return text.size() == 2 * kTokenBytes &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

Pairing::Pairing(double now) : until_(now + kSeconds) {
  for (const char c : randomBytes(kCodeLetters)) code_ += kLetters[uint8_t(c) % kLetters.size()];
}

std::string Pairing::shown() const { return code_.substr(0, 4) + "-" + code_.substr(4); }

const char* Pairing::closed(double now) const {
  if (used_) return "the code has already been used";
  if (tries_ <= 0) return "too many wrong codes were tried";
  return now > until_ ? "the code has expired" : "";
}

bool Pairing::answer(std::string_view code, double now) {
  if (*closed(now) != 0) return false;
  tries_--;
  used_ = equalInConstantTime(plain(code), code_);
  return used_;
}

Result<Tokens> Tokens::open(std::string path, size_t max) {
  Tokens out;
  out.path_ = std::move(path);
  out.max_ = max;
  struct stat about {};
  if (stat(out.path_.c_str(), &about) != 0) {
    if (errno == ENOENT) return out;
    return io::fileError(out.path_, "cannot access this file");
  }
  if ((about.st_mode & 077) != 0) {
    return Error{out.path_,
                 {},
                 {},
                 "other users can read the tokens",
                 "run chmod 600 on this file, then pair again"};
  }
  OBBY_ASSIGN(const std::string text, io::readFile(out.path_));
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (!isToken(line))
      return Error{
          out.path_, {}, {}, "this is not a file of tokens", "remove the file, then pair again"};
    out.entries_.push_back({line, out.next_++});
  }
  return out;
}

int Tokens::clientOf(std::string_view token) const {
  int found = -1;
  for (const Entry& entry : entries_) {  // compares all entries, so that the time reveals nothing
    if (equalInConstantTime(entry.token, token)) found = entry.client;
  }
  return found;
}

Result<std::string> Tokens::add() {
  std::vector<Entry> entries = entries_;
  int next = next_;
  if (!path_.empty()) {  // another bridge with this folder may have added tokens
    OBBY_ASSIGN(const Tokens there, open(path_, max_));
    for (const Entry& entry : there.entries_) {
      if (clientOf(entry.token) < 0) entries.push_back({entry.token, next++});
    }
  }
  entries.push_back({randomHex(kTokenBytes), next++});
  if (entries.size() > max_) entries.erase(entries.begin(), entries.end() - ptrdiff_t(max_));
  OBBY_RETURN_IF_ERROR(write(entries));
  entries_ = std::move(entries);
  next_ = next;
  return entries_.back().token;
}

// Writes a whole new file, so that a full disk loses no token.
Status Tokens::write(const std::vector<Entry>& entries) const {
  if (path_.empty()) return {};
  std::string text;
  for (const Entry& entry : entries) text += entry.token + "\n";
  OBBY_ASSIGN(const auto file, io::OutputFile::create(path_, 0600));
  if (!io::sendAll(file->fd(), text, nullptr)) return io::fileError(path_, "cannot write");
  return file->finish(false);
}

}  // namespace obby::bridge
