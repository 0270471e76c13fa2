// Explanations of unsolved queries name one change that makes the query solvable, reduced to the
// necessary amount. If no single change suffices, the answer has no explanation.
#include "solve/report/relaxation/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"

namespace obby::solve {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

struct Said {
  schema::RelaxationKind kind;
  double amount;
  int part, avoid;
  std::string field, text;
};
void PrintTo(const Said& s, std::ostream* out) { *out << s.text << " (" << s.amount << ")"; }

struct Explained {
  std::vector<Said> all;
  schema::Verdict verdict = schema::Verdict::SOLVED;
  std::string reason, bytes;

  const Said* of(schema::RelaxationKind kind) const {
    for (const Said& s : all) {
      if (s.kind == kind) return &s;
    }
    return nullptr;
  }
};

std::string explainWithoutTiming(std::string text) {
  const size_t at = text.find("\"timing\"");
  return at == std::string::npos ? text : text.erase(at, text.find('}', at) - at);
}

FilterOptions explaining(uint64_t maxSteps, int threads) {
  FilterOptions o;
  o.threads = threads;
  o.solver.explain = true;
  o.solver.progressRecords = false;
  o.solver.budget.attempts = 0;
  o.solver.budget.maxSteps = maxSteps;
  return o;
}

Explained parsed(const Filtered& f) {
  Explained result;
  EXPECT_TRUE(f.status) << f.status.error().text();
  const size_t at = f.output.find(R"({"type":"result")");
  EXPECT_NE(at, std::string::npos) << f.output;
  if (at == std::string::npos) return result;
  auto decoded = io::recordFromJson(f.output.substr(at, f.output.find('\n', at) - at));
  EXPECT_TRUE(decoded) << decoded.error().text();
  const auto record = decoded->reader().getResult();
  result.verdict = record.getVerdict();
  result.reason = record.getReason();
  result.bytes = explainWithoutTiming(f.output);
  for (const auto r : record.getRelaxations()) {
    result.all.push_back(
        {r.getKind(), double(r.getAmount()), r.getPart(), r.getAvoid(), r.getField(), r.getText()});
  }
  return result;
}

Explained explainAsk(const std::string& text, uint64_t maxSteps = 1'000'000, int threads = 2) {
  const LinesFile file(text);
  return parsed(runFilter(file.path(), explaining(maxSteps, threads)));
}

std::string level(const std::string& parts) {
  return R"({"type":"level","name":"scene","physics":{"fallenPartsHeight":-40},"parts":[)" + parts +
         R"(],"spawns":[{"position":[0,0,-2]}]})"
         "\n";
}
std::string query(const std::string& fields) {
  return R"({"type":"query","id":"q",)" + fields + "}\n";
}

// Three gaps of 8 studs, each of which requires a jump. A player can cross a gap of 6 without a
// jump, since the legs still catch the far side.
const std::string kFourStones = level(R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8]},)"
                                      R"({"name":"B","position":[0,-0.5,-20],"size":[8,1,8]},)"
                                      R"({"name":"C","position":[0,-0.5,-36],"size":[8,1,8]},)"
                                      R"({"name":"D","position":[0,-0.5,-52],"size":[8,1,8]})");
const std::string kFourth = R"("goal":{"position":[0,2,-52],"size":[8,4,8]})";

TEST(Explain, CountsTheJumpsThatAreNeeded) {
  const Explained e = explainAsk(kFourStones + query(kFourth + R"(,"maxJumps":1)"));
  const Said* jumps = e.of(schema::RelaxationKind::JUMPS);
  ASSERT_NE(jumps, nullptr) << e.reason;
  EXPECT_EQ(jumps->amount, 2);
  EXPECT_EQ(jumps->text, "solvable with 3 jumps instead of 1");
  EXPECT_EQ(jumps->field, "maxJumps");
  std::string advice = e.all.front().text;
  advice.front() = 'S';
  EXPECT_THAT(e.reason, HasSubstr(" is allowed. "));
  EXPECT_THAT(e.reason, testing::EndsWith(" " + advice + "."));
}

TEST(Explain, CountsTheJumpsOfASegment) {
  const Explained e = explainAsk(
      kFourStones +
      query(kFourth +
            R"(,"segmentJumps":1,"waypoints":[{"region":{"position":[0,2,-20],"size":[8,4,8]}}])"));
  const Said* jumps = e.of(schema::RelaxationKind::JUMPS);
  ASSERT_NE(jumps, nullptr) << e.reason;
  EXPECT_EQ(jumps->amount, 1);
  EXPECT_EQ(jumps->field, "segmentJumps");
  EXPECT_EQ(jumps->text, "solvable with 2 jumps from the last waypoint to the goal instead of 1");
}

// The straight line to the goal's box is 40 studs long, and the player walks at 16 studs/s.
TEST(Explain, SaysHowLongItTakes) {
  const Explained e = explainAsk(kFourStones + query(kFourth + R"(,"timeLimit":1.5)"));
  const Said* time = e.of(schema::RelaxationKind::TIME);
  ASSERT_NE(time, nullptr) << e.reason;
  const double limit = 1.5 + time->amount;
  EXPECT_GT(limit, 40 / 16.0);
  EXPECT_LT(limit, 40 / 16.0 + 0.6);
  EXPECT_THAT(time->text, HasSubstr(" s instead of 1.5"));
}

TEST(Explain, ALittleLessTimeThanItSaysIsNotEnough) {
  const auto solvedIn = [](double seconds) {
    const LinesFile file(kFourStones +
                         query(kFourth + R"(,"timeLimit":)" + std::to_string(seconds)));
    FilterOptions o = explaining(600'000, 2);
    o.solver.explain = false;
    return runFilter(file.path(), std::move(o)).counts.solved == 1;
  };
  const Explained e = explainAsk(kFourStones + query(kFourth + R"(,"timeLimit":2)"));
  const Said* time = e.of(schema::RelaxationKind::TIME);
  ASSERT_NE(time, nullptr) << e.reason;
  EXPECT_TRUE(solvedIn(2 + time->amount));
  EXPECT_FALSE(solvedIn(2 + time->amount - 0.2));
}

// Returns a level with a step up from the floor, and a query whose player must stand on the step.
std::string stepUp(double top) {
  return level(R"({"name":"Floor","position":[0,-0.5,-4],"size":[8,1,8]},)"
               R"({"name":"Ledge","position":[0,)" +
               std::to_string(top - 2) + R"(,-12],"size":[8,4,8]})") +
         query(R"("maxJumps":0,"goal":{"position":[0,)" + std::to_string(top + 0.7) +
               R"(,-14],"size":[4,0.6,4]})");
}

TEST(Explain, LowersAPartByNoMoreThanNeeded) {
  const auto walkable = [](double top) {
    const LinesFile file(stepUp(top));
    FilterOptions o = explaining(60'000, 2);
    o.solver.explain = false;
    return runFilter(file.path(), std::move(o)).counts.solved == 1;
  };
  double truth = 5;
  while (truth > 0 && !walkable(truth)) truth -= 0.1;
  ASSERT_GT(truth, 0.5);
  const double top = truth + 1.55;
  const Explained e = explainAsk(stepUp(top));
  const Said* lowered = e.of(schema::RelaxationKind::LOWERED);
  ASSERT_NE(lowered, nullptr) << e.reason;
  EXPECT_EQ(lowered->part, 1);
  EXPECT_NEAR(lowered->amount, top - truth, 0.11);
  EXPECT_THAT(lowered->text, HasSubstr("solvable with 'Ledge' 1."));
  const Said* jumps = e.of(schema::RelaxationKind::JUMPS);
  ASSERT_NE(jumps, nullptr) << e.reason;
  EXPECT_EQ(jumps->text, "solvable with 1 jump instead of 0");
}

TEST(Explain, SaysHowMuchHigherJumpsShouldBe) {
  const Explained e =
      explainAsk(level(R"({"name":"Floor","position":[0,-0.5,-4],"size":[8,1,8]},)"
                       R"({"name":"Ledge","position":[0,10.5,-14],"size":[8,1,8]})") +
                 query(R"("goal":{"position":[0,11.7,-14],"size":[4,0.6,4]})"));
  const Said* higher = e.of(schema::RelaxationKind::JUMP_HEIGHT);
  ASSERT_NE(higher, nullptr) << e.reason;
  EXPECT_GT(higher->amount, 0.5);
  EXPECT_LT(higher->amount, 3);
  EXPECT_THAT(higher->text, testing::StartsWith("solvable if jumps were "));
  EXPECT_THAT(higher->text, testing::EndsWith(" %) higher"));
}

// Returns a level with a corridor. With kLava as `more`, a curtain of lava hangs across it.
std::string corridor(const std::string& more) {
  return level(R"({"name":"Floor","position":[0,-0.5,-15],"size":[8,1,38]},)"
               R"({"name":"Lamp","position":[0,30,-30],"size":[1,1,1],"solid":false,"kill":{}})" +
               more);
}
const std::string kEnd = R"("goal":{"position":[0,2,-30],"size":[8,4,4]})";
const std::string kLava =
    R"(,{"name":"Lava","position":[0,40,-14],"size":[40,100,2],"solid":false,"kill":{}})";

TEST(Explain, NamesTheKillPartInTheWay) {
  const Explained e = explainAsk(corridor(kLava) + query(kEnd));
  EXPECT_EQ(e.verdict, schema::Verdict::UNKNOWN);
  ASSERT_THAT(e.all, SizeIs(1)) << e.reason;
  EXPECT_EQ(e.all[0].kind, schema::RelaxationKind::KILL_PART);
  EXPECT_EQ(e.all[0].part, 2);
  EXPECT_EQ(e.all[0].amount, 0);
  EXPECT_EQ(e.all[0].text, "solvable if 'Lava' were harmless");
}

TEST(Explain, NamesTheAvoidRegionInTheWay) {
  const std::string avoid =
      R"("avoid":[{"position":[90,0,0]},{"name":"dark","position":[0,20,-14],"size":[20,60,2]}])";
  const Explained e = explainAsk(corridor("") + query(kEnd + "," + avoid));
  ASSERT_THAT(e.all, SizeIs(1)) << e.reason;
  EXPECT_EQ(e.all[0].kind, schema::RelaxationKind::AVOID);
  EXPECT_EQ(e.all[0].avoid, 1);
  EXPECT_EQ(e.all[0].field, "avoid[1]");
  EXPECT_EQ(e.all[0].text, "solvable if entering avoid region 'dark' were allowed");
}

TEST(Explain, NamesTheForbiddenState) {
  const Explained e =
      explainAsk(kFourStones + query(kFourth + R"(,"forbid":["climbing","jumping"])"));
  const Said* state = e.of(schema::RelaxationKind::FORBIDDEN);
  ASSERT_NE(state, nullptr) << e.reason;
  EXPECT_EQ(state->field, "forbid[1]");
  EXPECT_EQ(state->text, "solvable if jumping were allowed");
  EXPECT_THAT(e.all, SizeIs(1));
}

TEST(Explain, SaysHowMuchHealthItCosts) {
  const std::string burning =
      R"(,{"name":"Embers","position":[0,40,-14],"size":[40,100,2],"solid":false,"kill":{"damage":30,"cooldown":5}})";
  const Explained e = explainAsk(corridor(burning) + query(kEnd + R"(,"maxDamage":10)"));
  const Said* damage = e.of(schema::RelaxationKind::DAMAGE);
  ASSERT_NE(damage, nullptr) << e.reason;
  EXPECT_EQ(damage->amount, 20);
  EXPECT_EQ(damage->text, "solvable with 30 health lost instead of 10");
  const Said* part = e.of(schema::RelaxationKind::KILL_PART);
  ASSERT_NE(part, nullptr) << e.reason;
  EXPECT_EQ(part->part, 2);
  EXPECT_THAT(e.reason, HasSubstr("lost more health than allowed, the last of it to 'Embers'"));
}

TEST(Explain, MakesNoClaimIfNoChangeHelps) {
  const Explained e =
      explainAsk(corridor("") + query(R"("goal":{"position":[0,400,-30],"size":[8,4,4]})"));
  EXPECT_EQ(e.verdict, schema::Verdict::UNREACHABLE);
  EXPECT_THAT(e.all, IsEmpty());
  EXPECT_THAT(e.reason, HasSubstr("No single change that was tried makes the query solvable."));
}

TEST(Explain, MakesNoClaimIfTwoChangesAreNeeded) {
  const std::string behind =
      R"(,{"name":"Lava 2","position":[0,40,-22],"size":[40,100,2],"solid":false,"kill":{}})";
  EXPECT_THAT(explainAsk(corridor(kLava + behind) + query(kEnd)).all, IsEmpty());
  const Explained e = explainAsk(kFourStones + query(kFourth + R"(,"maxJumps":1,"timeLimit":1.5)"));
  EXPECT_THAT(e.all, IsEmpty());
}

TEST(Explain, SaysNothingUnlessAsked) {
  const LinesFile file(kFourStones + query(kFourth + R"(,"maxJumps":1)"));
  FilterOptions o = explaining(100'000, 1);
  o.solver.explain = false;
  const Explained e = parsed(runFilter(file.path(), std::move(o)));
  EXPECT_THAT(e.all, IsEmpty());
  EXPECT_THAT(e.reason, Not(HasSubstr("single change")));
}

TEST(Explain, SaysNothingOfSolvedQueries) {
  const Explained e = explainAsk(kFourStones + query(kFourth));
  EXPECT_EQ(e.verdict, schema::Verdict::SOLVED);
  EXPECT_THAT(e.all, IsEmpty());
  EXPECT_THAT(e.reason, Not(HasSubstr("single change")));
}

// The verdict `unreachable` stands, and the reason does not mention untried changes.
TEST(Explain, StopsOnRequest) {
  const std::atomic<bool> stop{true};
  const LinesFile file(stepUp(40));
  FilterOptions o = explaining(600'000, 1);
  o.solver.budget.stop = &stop;
  const Explained e = parsed(runFilter(file.path(), std::move(o)));
  EXPECT_EQ(e.verdict, schema::Verdict::UNREACHABLE);
  EXPECT_THAT(e.all, IsEmpty());
  EXPECT_THAT(e.reason, Not(HasSubstr("single change")));
}

TEST(Explain, GivesTheSameBytesOnAnyNumberOfThreads) {
  for (const std::string& text : {kFourStones + query(kFourth + R"(,"maxJumps":1)"),
                                  corridor(kLava) + query(kEnd), stepUp(6)}) {
    const Explained one = explainAsk(text, 300'000, 1), three = explainAsk(text, 300'000, 3);
    EXPECT_FALSE(one.all.empty()) << one.reason;
    EXPECT_EQ(one.bytes, three.bytes);
  }
}

}  // namespace
}  // namespace obby::solve
