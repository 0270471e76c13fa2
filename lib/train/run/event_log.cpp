#include "train/run/event_log.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <chrono>
#include <filesystem>

namespace obby::train {

namespace {

constexpr uint32_t kPolynomial = 0x82f63b78;  // polynomial of CRC-32C, bits reversed

constexpr std::array<uint32_t, 256> crcTable() {
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c >> 1) ^ ((c & 1) != 0 ? kPolynomial : 0);
    table[i] = c;
  }
  return table;
}

// Returns the value's bytes, little-endian.
template <class T>
std::string fixed(T value) {
  std::string out;
  for (size_t i = 0; i < sizeof(T); ++i) out += char((value >> (8 * i)) & 0xff);
  return out;
}

std::string varint(uint64_t value) {
  std::string out;
  for (; value >= 0x80; value >>= 7) out += char((value & 0x7f) | 0x80);
  return out + char(value);
}

// Wire types. A field is its number and wire type, then the value.
enum Wire { kVarint = 0, kFixed64 = 1, kBytes = 2, kFixed32 = 5 };
std::string key(int field, Wire wire) { return varint((uint64_t(field) << 3) | uint64_t(wire)); }
std::string number(int field, uint64_t value) { return key(field, kVarint) + varint(value); }
std::string real64(int field, double value) {
  return key(field, kFixed64) + fixed(std::bit_cast<uint64_t>(value));
}
std::string real32(int field, float value) {
  return key(field, kFixed32) + fixed(std::bit_cast<uint32_t>(value));
}
std::string bytes(int field, const std::string& value) {
  return key(field, kBytes) + varint(value.size()) + value;
}

// Field numbers of Event, SessionLog, Summary and Summary.Value.
constexpr int kWallTime = 1, kStep = 2, kFileVersion = 3, kSummary = 5, kSessionLog = 7;
constexpr int kStatus = 1, kStart = 1;
constexpr int kValue = 1, kTag = 1, kSimpleValue = 2;

double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string masked(std::string_view data) {
  const uint32_t crc = crc32c(data);
  return fixed(((crc >> 15) | (crc << 17)) + 0xa282ead8u);
}

std::string record(const std::string& data) {
  const std::string length = fixed(uint64_t(data.size()));
  return length + masked(length) + data + masked(data);
}

std::string event(uint64_t step, const std::string& content) {
  return record(real64(kWallTime, now()) + number(kStep, step) + content);
}

// TensorBoard reads the files of a folder in the order of their names.
std::string fileName() {
  char host[256] = "host";
  gethostname(host, sizeof host - 1);
  return fmt::format("events.out.tfevents.{:010}.{}.{}", uint64_t(now()), host, getpid());
}

}  // namespace

uint32_t crc32c(std::string_view data) {
  static constexpr auto kTable = crcTable();
  uint32_t crc = ~0u;
  for (const char c : data) crc = kTable[(crc ^ uint8_t(c)) & 0xff] ^ (crc >> 8);
  return ~crc;
}

Result<EventLog> EventLog::open(const std::string& folder, uint64_t kept) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{folder, {}, {}, "cannot create the folder: " + failed.message(), {}};
  OBBY_ASSIGN(io::Appender file, io::Appender::open(folder + "/" + fileName()));
  OBBY_RETURN_IF_ERROR(file.append(event(0, bytes(kFileVersion, "brain.Event:2"))));
  OBBY_RETURN_IF_ERROR(file.append(event(kept + 1, bytes(kSessionLog, number(kStatus, kStart)))));
  return EventLog(std::move(file));
}

void EventLog::write() {
  held_ = file_.append(waiting_);
  if (!held_) return;
  waiting_.clear();
  events_ = 0;
}

void EventLog::add(uint64_t iteration, std::span<const Metric> metrics) {
  std::string summary;
  for (const Metric& m : metrics) {
    summary += bytes(kValue, bytes(kTag, "train/" + m.name) + real32(kSimpleValue, float(m.value)));
  }
  waiting_ += event(iteration, bytes(kSummary, summary));
  ++events_;
  write();
}

Status EventLog::finish() {
  write();
  if (held_) return {};
  Error error = held_.error();
  error.hint = fmt::format("events missing at the end of the log: {}", events_);
  return error;
}

}  // namespace obby::train
