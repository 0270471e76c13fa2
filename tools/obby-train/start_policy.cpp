#include "start_policy.h"

#include <fmt/format.h>

#include <utility>

#include "base/hash.h"
#include "io/read_file.h"
#include "policy/policy_file.h"

namespace obby::tools {

Result<std::optional<StartPolicy>> startPolicyOf(const cli::Context& context, train::Ranks& ranks) {
  const cli::Arguments& a = context.arguments();
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
