// Turns an order into a command line and its input.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <thread>

#include "base/spelling.h"
#include "bridge/order.h"
#include "bridge/service.h"
#include "io/json_writer.h"
#include "io/text.h"

namespace obby::bridge {
namespace {

constexpr const char* kNoCalibrate = "there is no obby-calibrate next to obby-bridge";

// Adds the level's own queries in the order of `ask`, or all of them if it is empty.
std::optional<Reply> addOwnQueries(const StoredLevel& level, const std::vector<std::string>& ask,
                                   std::string& out) {
  std::vector<std::string> ids;
  for (const std::string& line : level.queries) ids.push_back(queryIdOfLine(line));
  if (ask.empty()) {
    for (const std::string& line : level.queries) out.append(line).append("\n");
  }
  for (const std::string& wanted : ask) {
    const auto found = std::find(ids.begin(), ids.end(), wanted);
    if (found == ids.end()) {
      const std::string near = nearestName(wanted, ids);
      return refuse(404, "the level has no query " + io::quoted(wanted),
                    near.empty() ? "see the queries in the reply to POST /v1/levels"
                                 : "did you mean " + near + "?");
    }
    out.append(level.queries[size_t(found - ids.begin())]).append("\n");
  }
  return {};
}

}  // namespace

Reply Service::putJob(std::shared_ptr<Client> client, const std::string& body) {
  const auto order = parseOrder(body, limits_);
  if (!order) return refuse(400, order.error());
  const uint64_t number = jobs_.nextNumber();
  auto planned = plan(*order, *client, number);
  if (const Reply* refusal = std::get_if<Reply>(&planned)) return *refusal;
  Job* job = jobs_.submit(std::move(client), std::move(std::get<JobPlan>(planned)), number);
  if (!job) {
    return refuse(429, fmt::format("{} jobs are already waiting", limits_.waiting),
                  "cancel one, or wait for one to end");
  }
  return {202, io::JsonWriter()
                   .open('{')
                   .field("job", job->id())
                   .field("state", nameOf(job->state()))
                   .field("session", session_)
                   .field("cursor", job->firstCursor())
                   .finish()};
}

std::variant<JobPlan, Reply> Service::plan(const Order& order, Client& client, uint64_t number) {
  const bool solve = order.task == Task::solve;
  if (!solve && programs_.calibrate.empty())
    return refuse(501, kNoCalibrate, "install all of obby");
  const auto level = store_.get(order.level);
  if (!level) return refuse(500, level.error());
  if (!*level) return refuse(404, "there is no level with this id", "send it to /v1/levels again");
  JobPlan out;
  out.command = {solve ? programs_.solve : programs_.calibrate,
                 {"--progress=json", "--json-errors"},
                 limits_.memoryBytes,
                 limits_.maxCpuSeconds(std::max(1u, std::thread::hardware_concurrency()))};
  std::vector<std::string>& arguments = out.command.arguments;
  arguments.insert(arguments.end(), order.arguments.begin(), order.arguments.end());
  if (!order.physics.empty()) out.input = order.physics + "\n";
  out.input += (*level)->levels;
  if (!solve)
    arguments.emplace_back("--verbose");  // obby-calibrate then reports its result in words
  if (solve) {
    arguments.emplace_back("--on-error=skip");  // a bad query does not stop the others
    out.answerPath = store_.answerPath(session_, fmt::format("j{}", number));
    if (auto wrong = addWarmStart(order, client, out)) return *std::move(wrong);
    if (order.records.empty()) {
      if (auto wrong = addOwnQueries(**level, order.ask, out.input)) return *std::move(wrong);
    }
  }
  for (const std::string& line : order.records) out.input.append(line).append("\n");
  arguments.emplace_back("-");
  return out;
}

std::optional<Reply> Service::addWarmStart(const Order& order, Client& client, JobPlan& to) {
  if (order.warm.empty()) return {};
  const Job* earlier = jobs_.find(client, order.warm);
  std::error_code ignored;  // a bridge that started since may have removed old answers
  if (!earlier || !earlier->answerKept() ||
      !std::filesystem::exists(earlier->answerPath(), ignored)) {
    return refuse(409, "the answer of job " + order.warm + " is not kept", "leave out 'warm'");
  }
  to.command.arguments.push_back("--warm=" + earlier->answerPath());
  to.warm = earlier->number();
  return {};
}

}  // namespace obby::bridge
