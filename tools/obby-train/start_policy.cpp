#include "start_policy.h"

#include <fmt/format.h>

#include <utility>

#include "base/hash.h"
#include "io/read_file.h"
#include "policy/policy_file.h"

namespace obby::tools {

namespace {

std::string optionOf(const cli::Arguments& a) {
  return a.has("start-from") ? "with --start-from " + a.text("start-from")
                             : std::string("without --start-from");
}

// The first rank's file is read for all: another that was given to others would be passed over.
Status sameOnAll(const cli::Arguments& a, train::Ranks& ranks) {
  const std::string mine = optionOf(a), firsts = ranks.share(mine);
  if (mine == firsts) return {};
  return makeError(fmt::format("it was started {}, and rank 0 {}", mine, firsts),
                   "give all ranks the same options and files");
}

}  // namespace

Result<std::optional<StartPolicy>> startPolicyOf(const cli::Context& context, train::Ranks& ranks) {
  const cli::Arguments& a = context.arguments();
  OBBY_RETURN_IF_ERROR(ranks.agree(sameOnAll(a, ranks)));
  if (!a.has("start-from")) return std::optional<StartPolicy>();
  const std::string& path = a.text("start-from");
  OBBY_ASSIGN(std::string bytes, ranks.agree(ranks.first() ? io::readFile(path, &context.stop())
                                                           : Result<std::string>(std::string())));
  bytes = ranks.share(std::move(bytes));
  OBBY_ASSIGN(const policy::PolicyFile file, ranks.agree(policy::readPolicy(bytes, path)));
  auto start = train::startFrom(file);
  if (!start) start.error().input = path;
  OBBY_ASSIGN(train::Start begun, ranks.agree(std::move(start)));
  const uint64_t hash = hashBytes(bytes.data(), bytes.size());
  return std::optional(
      StartPolicy{std::move(begun), fmt::format("a policy of hash {:016x}", hash)});
}

}  // namespace obby::tools
