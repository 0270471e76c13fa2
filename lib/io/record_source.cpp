// RecordSource: joins several inputs, and forgives errors as the user wishes.
#include <fmt/format.h>

#include <algorithm>

#include "io/lost_level.h"
#include "io/pipeline.h"
#include "io/read_file.h"
#include "io/record_storage.h"
#include "io/version.h"

namespace obby::io {
namespace {

constexpr uint64_t kMaxWarnings = 10;

// Returns how severe an end status is.
int gravity(schema::EndStatus status) {
  switch (status) {
    case schema::EndStatus::COMPLETE: return 0;
    case schema::EndStatus::BUDGET: return 1;
    case schema::EndStatus::INTERRUPTED: return 2;
    case schema::EndStatus::FAILED: break;
  }
  return 3;
}

}  // namespace

void SourceSummary::add(const SourceSummary& other) {
  if (gravity(other.status) > gravity(status)) status = other.status;
  skipped += other.skipped;
  errors += other.errors;
}

struct RecordSource::Impl {
  SourceOptions options;
  std::optional<StreamReader> reader;
  size_t nextInput = 0;
  SourceSummary summary;
  uint64_t warnings = 0;
  uint32_t schemaMinor = 0;
  bool wasStopped = false;
  std::optional<Error> incomplete;  // error of the first end record with the most severe status
  // Place of the last level, if it could not be read; otherwise empty.
  std::string lostLevel;

  bool stopped() const {
    return (options.stop && options.stop->load()) || (reader && reader->stopped());
  }

  void takeEnd(const Record& record) {
    const schema::End::Reader end = record.reader().getEnd();
    const schema::EndStatus before = summary.status;
    summary.add({end.getStatus(), end.getSkipped(), end.getErrors()});
    if (summary.status == before || whole()) return;
    incomplete = Error{reader->name(),
                       record.place(),
                       {},
                       failed() ? "the tool that wrote this input stopped at an error"
                                : "the tool that wrote this input was interrupted",
                       {}};
  }

  bool failed() const { return summary.status == schema::EndStatus::FAILED; }
  bool whole() const {
    return summary.status == schema::EndStatus::COMPLETE ||
           summary.status == schema::EndStatus::BUDGET;
  }

  void report(const Error& error) {
    summary.errors++;
    if (options.report) options.report(error);
  }

  void warnOf(const Record& record) {
    for (Error error : record.storage().misspelt) {
      if (!options.warn || warnings++ >= kMaxWarnings) return;
      error.input = reader->name();
      error.place = record.place();
      options.warn(error);
    }
  }

  // `lost` is true if the record was a level, or may have been.
  void skip(const Error& error, bool lost) {
    if (lost) lostLevel = error.input + (error.place.empty() ? "" : ":" + error.place);
    report(error);
    summary.skipped++;
  }

  // Skips a record of a level that was lost. Otherwise it would be used with another level.
  bool leaveOut(const Record& record) {
    if (lostLevel.empty() || !namesNoLevel(record)) return false;
    skip({reader->name(), record.place(), "level",
          fmt::format(
              "this record names no level, and the record at {}, which may be its level, could not "
              "be read",
              lostLevel),
          "fix that record, or name the level in this one"},
         false);
    return true;
  }

  // Returns a copy of the record that can be passed on, but not handled.
  static Record bytesOf(const Record& record) {
    const Record::Storage& read = record.storage();
    auto storage = std::make_shared<Record::Storage>();
    storage->unreadable = true;
    storage->format = read.format;
    storage->raw = read.raw;
    storage->input = read.input;
    storage->place = read.place;
    return Record(std::move(storage));
  }

  // Opens the next input. Returns false if there is none.
  Result<bool> advance() {
    if (nextInput == options.inputs.size()) return false;
    const std::string& path = options.inputs[nextInput++];
    auto opened = options.open ? options.open(path) : StreamReader::open(path, options.stop);
    if (opened) {
      reader = *std::move(opened);
    } else if (!stopped() || !isInterrupted(opened.error())) {  // a requested stop is no error
      if (!options.open || options.onError == OnError::stop) return opened.error();
      skip(opened.error(), true);
    }
    return true;
  }

  Result<std::optional<Record>> next() {
    while (!stopped()) {
      if (!reader) {
        OBBY_ASSIGN(const bool more, advance());
        if (!more) return std::optional<Record>();
        continue;
      }
      auto got = reader->next();
      if (!got) {
        if (options.onError == OnError::stop || !reader->canContinue()) return got.error();
        skip(got.error(), reader->lostLevel());
        if (options.onError == OnError::emit) return std::optional<Record>(reader->unread());
        continue;
      }
      if (stopped()) break;
      if (!*got) {
        reader.reset();
        continue;
      }
      const Record& record = **got;
      if (record.known() && record.which() == Kind::LEVEL) lostLevel.clear();
      if (record.known() && record.which() == Kind::HEADER) {
        if (record.reader().getHeader().getSchemaMajor() == kSchemaMajor)
          schemaMinor = std::max(schemaMinor, record.reader().getHeader().getSchemaMinor());
        continue;
      }
      if (record.known() && record.which() == Kind::END) {
        takeEnd(record);
        continue;
      }
      warnOf(record);
      if (!leaveOut(record)) return got;
      if (options.onError == OnError::emit) return std::optional<Record>(bytesOf(record));
    }
    wasStopped = true;
    return std::optional<Record>();
  }
};

RecordSource::RecordSource(SourceOptions options) : impl_(std::make_unique<Impl>()) {
  impl_->options = std::move(options);
}
RecordSource::RecordSource(RecordSource&&) noexcept = default;
RecordSource::~RecordSource() = default;

Result<std::optional<Record>> RecordSource::next() { return impl_->next(); }

Status RecordSource::forgive(const Record& record, Error error) {
  if (error.input.empty() && impl_->reader) error.input = impl_->reader->name();
  if (error.place.empty()) error.place = record.place();
  if (impl_->options.onError == OnError::stop) return error;
  impl_->report(error);
  if (impl_->options.onError == OnError::skip) impl_->summary.skipped++;
  return {};
}

bool RecordSource::stopped() const {
  return impl_->wasStopped || (impl_->options.stop && impl_->options.stop->load());
}

schema::EndStatus RecordSource::status() const {
  return stopped() ? schema::EndStatus::INTERRUPTED : impl_->summary.status;
}

uint64_t RecordSource::skipped() const { return impl_->summary.skipped; }
uint64_t RecordSource::errors() const { return impl_->summary.errors; }
SourceSummary RecordSource::summary() const { return impl_->summary; }

Status RecordSource::checkWhole() const {
  if (!impl_->incomplete) return {};
  Error error = *impl_->incomplete;
  if (impl_->options.onError != OnError::stop) {
    if (impl_->options.warn) impl_->options.warn(error);
    return {};
  }
  error.hint = "rerun that tool, or accept the incomplete stream with --on-error skip";
  return error;
}

void RecordSource::warnIfFailed() const {
  if (impl_->failed() && impl_->options.warn) impl_->options.warn(*impl_->incomplete);
}

Error RecordSource::lacking(Error error) const { return impl_->incomplete.value_or(error); }

void RecordSource::warn(const Record& record, Error error) {
  if (error.input.empty()) error.input = record.input();
  if (error.place.empty()) error.place = record.place();
  if (impl_->options.warn) impl_->options.warn(error);
}

void RecordSource::ignoreErrors() {
  impl_->options.onError = OnError::skip;
  impl_->options.report = nullptr;
  impl_->options.warn = nullptr;
}

OnError RecordSource::onError() const { return impl_->options.onError; }
uint32_t RecordSource::schemaMinor() const { return impl_->schemaMinor; }

}  // namespace obby::io
