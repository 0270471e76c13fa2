#include "io/pipeline.h"

#include <algorithm>

#include "io/record_storage.h"
#include "io/version.h"

namespace obby::io {

struct Pipeline::Impl {
  RecordSource source;
  StreamIdentity identity;
  StreamWriter output;
  bool begun = false, budgetSpent = false, stoppedByError = false;
  int64_t leftOut = 0;  // records left out, in addition to those that the source counts
  SourceSummary elsewhere = {};

  Status begin() {
    if (begun) return {};
    begun = true;
    RecordBuilder builder;
    auto header = builder.root().initHeader();
    header.setSchemaMajor(kSchemaMajor);
    header.setSchemaMinor(std::max(kSchemaMinor, source.schemaMinor()));
    header.setTool(identity.tool);
    header.setVersion(identity.version);
    header.setSeed(identity.seed);
    header.setFloatPolicy(kFloatPolicy);
    return output.write(builder.reader());
  }

  Status one(const Record& record, const Handler& handle) {
    if (!record.known()) return pass(record);
    Result<Then> then = handle(record);
    if (then) return *then == Then::pass ? pass(record) : Status();
    if (output.failed()) return then.error();
    OBBY_RETURN_IF_ERROR(source.forgive(record, std::move(then).error()));
    return source.onError() == OnError::emit ? pass(record) : Status();
  }

  // Passes a record on. A record that the output's format cannot hold is left out, whatever onError
  // is. A record that could not be read was already reported and counted as skipped.
  Status pass(const Record& record) {
    const bool unreadable = record.storage().unreadable;
    Status passed = output.pass(record);
    if (passed && unreadable) leftOut--;
    if (passed || output.failed()) return passed;
    if (unreadable) {
      source.warn(record, std::move(passed).error());
      return {};
    }
    if (source.onError() == OnError::emit) leftOut++;
    return source.forgive(record, std::move(passed).error());
  }

  Status forgiveLate(const Record& record, Error error) {
    if (output.failed()) return error;
    if (error.input.empty()) error.input = record.input();
    OBBY_RETURN_IF_ERROR(source.forgive(record, std::move(error)));
    if (source.onError() == OnError::skip) leftOut--;
    return {};
  }

  Status run(const Handler& handle) {
    for (;;) {
      OBBY_ASSIGN(const std::optional<Record> record, source.next());
      OBBY_RETURN_IF_ERROR(begin());
      if (!record) return {};
      OBBY_RETURN_IF_ERROR(one(*record, handle));
    }
  }

  SourceSummary read() const {
    SourceSummary all = elsewhere;
    all.add({source.status(), source.skipped(), source.errors()});
    return all;
  }

  schema::EndStatus status() const {
    if (stoppedByError && !source.stopped()) return schema::EndStatus::FAILED;
    SourceSummary all = read();
    if (budgetSpent) all.add({schema::EndStatus::BUDGET});
    return all.status;
  }

  Status finish() {
    if (stoppedByError && !begun) return {};  // nothing was done, so there is no output
    OBBY_RETURN_IF_ERROR(begin());
    RecordBuilder builder;
    auto end = builder.root().initEnd();
    end.setStatus(status());
    end.setRecords(output.recordsWritten());
    end.setSkipped(uint64_t(int64_t(read().skipped) + leftOut));
    end.setErrors(read().errors + (stoppedByError ? 1 : 0));
    OBBY_RETURN_IF_ERROR(output.write(builder.reader()));
    return output.close();
  }
};

Pipeline::Pipeline(SourceOptions source, StreamIdentity identity, StreamWriter output)
    : impl_(std::make_unique<Impl>(
          Impl{RecordSource(std::move(source)), std::move(identity), std::move(output)})) {}
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline::~Pipeline() = default;

Status Pipeline::run(const Handler& handle) {
  Status status = impl_->run(handle);
  impl_->stoppedByError = !status;
  return status;
}

Status Pipeline::write(schema::Record::Reader record) {
  OBBY_RETURN_IF_ERROR(impl_->begin());
  return impl_->output.write(record);
}

void Pipeline::readElsewhere(const SourceSummary& read) { impl_->elsewhere = read; }
void Pipeline::outOfBudget() { impl_->budgetSpent = true; }

Status Pipeline::forgiveLate(const Record& record, Error error) {
  return impl_->forgiveLate(record, std::move(error));
}

Status Pipeline::finish(Status work) {
  if (work) {
    if (!impl_->stoppedByError) impl_->source.warnIfFailed();
    return impl_->finish();
  }
  impl_->stoppedByError = true;
  // Ignores further errors: the first error is reported.
  if (!impl_->output.failed()) (void)impl_->finish();
  return work;
}

Status Pipeline::runAndFinish(const Handler& handle) { return finish(run(handle)); }

StreamWriter& Pipeline::output() { return impl_->output; }
RecordSource& Pipeline::source() { return impl_->source; }

}  // namespace obby::io
