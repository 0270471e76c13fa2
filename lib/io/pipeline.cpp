#include "io/pipeline.h"

#include "io/version.h"

namespace obby::io {

struct Pipeline::Impl {
  RecordSource source;
  StreamIdentity identity;
  StreamWriter output;
  bool begun = false, budgetSpent = false, stoppedByError = false;

  Status begin() {
    if (begun) return {};
    begun = true;
    RecordBuilder builder;
    auto header = builder.root().initHeader();
    header.setSchemaMajor(kSchemaMajor);
    header.setSchemaMinor(kSchemaMinor);
    header.setTool(identity.tool);
    header.setVersion(identity.version);
    header.setSeed(identity.seed);
    header.setFloatPolicy(kFloatPolicy);
    return output.write(builder.reader());
  }

  Status one(const Record& record, const Handler& handle) {
    if (!record.known()) return output.pass(record);
    Result<Then> then = handle(record);
    if (then) return *then == Then::pass ? output.pass(record) : Status();
    if (output.failed()) return then.error();
    OBBY_RETURN_IF_ERROR(source.forgive(record, std::move(then.error())));
    return source.onError() == OnError::emit ? output.pass(record) : Status();
  }

  Status run(const Handler& handle) {
    for (;;) {
      OBBY_ASSIGN(const std::optional<Record> record, source.next());
      OBBY_RETURN_IF_ERROR(begin());
      if (!record) return {};
      OBBY_RETURN_IF_ERROR(one(*record, handle));
    }
  }

  schema::EndStatus status() const {
    const auto upstream = source.status();
    if (upstream == schema::EndStatus::INTERRUPTED || stoppedByError)
      return schema::EndStatus::INTERRUPTED;
    return budgetSpent ? schema::EndStatus::BUDGET : upstream;
  }

  Status finish() {
    if (stoppedByError && !begun) return {};  // nothing was done: leave no output
    OBBY_RETURN_IF_ERROR(begin());
    RecordBuilder builder;
    auto end = builder.root().initEnd();
    end.setStatus(status());
    end.setRecords(output.recordsWritten());
    end.setSkipped(source.skipped());
    end.setErrors(source.errors() + (stoppedByError ? 1 : 0));
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

void Pipeline::outOfBudget() { impl_->budgetSpent = true; }
Status Pipeline::finish() { return impl_->finish(); }

Status Pipeline::runAndFinish(const Handler& handle) {
  const Status ran = run(handle);
  if (impl_->output.failed()) return ran;
  const Status finished = finish();
  return ran ? finished : ran;
}

StreamWriter& Pipeline::output() { return impl_->output; }
RecordSource& Pipeline::source() { return impl_->source; }

}  // namespace obby::io
