// Formats the explanation: world, roles, omissions.
#include "import/records/explain.h"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <tuple>
#include <vector>

#include "io/text.h"
#include "io/utf8.h"

namespace obby::importer {
namespace {

constexpr float kDegrees = 180 / 3.14159265f;  // degrees per radian
constexpr size_t kPartWidth = 34, kRoleWidth = 10, kWidth = 100, kNoteIndent = 8;

// Counts characters, not bytes.
size_t widthOf(std::string_view text) {
  size_t width = 0;
  for (char c : text) width += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return width;
}

std::string oneLine(std::string_view raw) { return io::tamed(raw, false); }

// Returns the byte at which the `character`th character begins.
size_t byteAt(std::string_view text, size_t character) {
  size_t at = 0;
  for (size_t seen = 0; at < text.size(); ++at)
    if ((static_cast<unsigned char>(text[at]) & 0xc0) != 0x80 && seen++ == character) break;
  return at;
}

// beginning() and ending() return at most `width` characters of a text, from its start or its end.
std::string beginning(std::string_view raw, size_t width) {
  const std::string text = oneLine(raw);
  return widthOf(text) <= width ? text : text.substr(0, byteAt(text, width - 3)) + "...";
}
std::string ending(std::string_view raw, size_t width) {
  const std::string text = oneLine(raw);
  const size_t all = widthOf(text);
  return all <= width ? text : "..." + text.substr(byteAt(text, all - (width - 3)));
}

std::string padded(std::string text, size_t width) {
  text.append(width - widthOf(text), ' ');
  return text;
}

// Breaks a text at spaces into lines of at most kWidth, with the second and later ones indented.
std::string wrapped(std::string_view raw, size_t indent) {
  const std::string text = oneLine(raw);
  std::string out;
  size_t begin = 0, margin = 0;
  while (begin < text.size()) {
    const size_t width = kWidth - margin;
    size_t length = byteAt(std::string_view(text).substr(begin), width);
    if (begin + length < text.size()) {
      const size_t space = text.rfind(' ', begin + length);
      if (space != std::string::npos && space > begin) length = space - begin;
    }
    out += std::string(margin, ' ') + text.substr(begin, length) + '\n';
    begin = text.find_first_not_of(' ', begin + length);
    margin = indent;
  }
  return out;
}

std::string numbersOf(const PartDraft& part, const std::string& role) {
  if (role == "kill" && part.kill)
    return part.kill->damage < 100 ? fmt::format("takes {} health; ", part.kill->damage) : "";
  if (role == "conveyor" && part.conveyor)
    return fmt::format("{:.4g} studs/s; ", length(part.conveyor->velocity));
  if (role == "jumpPad" && part.jumpPad)
    return fmt::format("{:.4g} studs/s; ", length(part.jumpPad->velocity));
  if (role == "vanish" && part.vanish)
    return fmt::format("{} {:.3g} s, away {:.3g} s; ",
                       part.vanish->timer ? "solid" : "vanishes after", part.vanish->delay,
                       part.vanish->away);
  if (role == "checkpoint" && part.checkpoint) return fmt::format("stage {}; ", *part.checkpoint);
  if (role == "motion" && part.motion) {
    const Motion& m = *part.motion;
    if (m.spin) return fmt::format("turns {:.3g} degrees/s; ", m.spin->speed * kDegrees);
    if (!m.keys.empty())
      return fmt::format("{} in {:.3g} s; ", io::plural(m.keys.size(), "pose"), m.keys.back().time);
  }
  return "";
}

std::string row(const std::string& part, const std::string& role, const std::string& why) {
  const size_t rest = kWidth - kPartWidth - kRoleWidth - 2;
  std::string line = padded(part, kPartWidth) + ' ' +
                     padded(beginning(role, kRoleWidth), kRoleWidth) + ' ' + beginning(why, rest);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

// Returns the path below the level's own.
std::string shortPath(const LevelDraft& level, const std::string& path) {
  const std::string root = level.path + '/';
  return path.rfind(root, 0) == 0 ? path.substr(root.size()) : path;
}

std::string roles(const LevelDraft& level, const Tree& tree) {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, size_t> index;
  std::vector<std::pair<Key, int>> rows;
  for (const PartDraft& part : level.parts)
    for (const Evidence& evidence : part.evidence) {
      const Key key{
          shortPath(level, tree.path(part.id)), evidence.role,
          (evidence.guessed ? "guessed: " : "") + numbersOf(part, evidence.role) + evidence.reason};
      const auto [it, isNew] = index.try_emplace(key, rows.size());
      if (isNew) rows.emplace_back(key, 0);
      ++rows[it->second].second;
    }
  std::string text = row("part", "role", "evidence");
  if (rows.empty()) text += "(no part has a role)\n";
  for (const auto& [key, count] : rows) {
    const std::string times = count > 1 ? fmt::format(" x{}", count) : "";
    text += row(ending(std::get<0>(key), kPartWidth - times.size()) + times, std::get<1>(key),
                std::get<2>(key));
  }
  return text;
}

std::string counted(const std::string& title,
                    const std::map<std::string, UnmodelledDraft>& entries) {
  if (entries.empty()) return {};
  std::string text = "\n" + title + "\n";
  for (const auto& [kind, entry] : entries) {
    text += wrapped(fmt::format("{:>6}  {}: {}", entry.count, kind, entry.note), kNoteIndent);
    text += wrapped("        for example " + entry.example, kNoteIndent);
  }
  return text;
}

}  // namespace

std::string explain(const LevelDraft& level, const Tree& tree) {
  const World& w = level.world;
  std::string text = wrapped(
      fmt::format("level {} from {} ({})", level.name, level.file, level.format), kNoteIndent);
  text +=
      fmt::format("{} read, {} kept, {} left out; {}\n", io::plural(level.partsRead, "part"),
                  level.parts.size(), level.partsCulled, io::plural(level.spawns.size(), "spawn"));
  text += fmt::format(
      "gravity {:.5g} studs/s^2, walk speed {:.5g} studs/s, jump speed {:.5g} studs/s, "
      "fall height {:.6g} studs\n\n",
      w.gravity, w.walkSpeed, w.jumpSpeed, w.fallenPartsHeight);
  text += roles(level, tree);
  text += counted("not modelled", level.unmodelled);
  text += counted("left out or noted", level.ignored);
  return text;
}

}  // namespace obby::importer
