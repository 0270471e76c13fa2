// Follows one script's text with the values it states, and notes what it does to the world and
// when. Nothing that a script could call exists here: there are no side effects, calls into the
// unknown give unknown values, and a step budget bounds the work. Where a condition is unknown both
// branches are followed; waits move the clock of the timeline.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/luau/ast.h"
#include "import/luau/assignments.h"
#include "import/luau/changes.h"
#include "import/luau/datum.h"
#include "import/luau/guard.h"
#include "import/luau/pending.h"
#include "import/luau/playing.h"
#include "import/luau/timeline_room.h"
#include "import/luau/values.h"
#include "import/luau/variables.h"
#include "import/script_reading.h"
#include "import/tree.h"

namespace obby::importer::luau {

using namespace obby::luau;

constexpr size_t kAncestorsPerStep = 8;
constexpr size_t kMaxTimelines = 50000;  // of a script
constexpr int kMaxCount = 2000;          // rounds of a counted loop

class Reader {
 public:
  // `budget` bounds the steps of the reading; what is left of it remains there. `room`: the most
  // events and timelines, without that of the script itself. `changes`: of all scripts, once they
  // have been read; null: they have not. It must outlive the reader.
  Reader(const Tree& tree, InstanceId script, size_t& budget, size_t room,
         const Changes* changes = nullptr);
  // The chunk must outlive the call only.
  ScriptReading read(const Chunk& chunk);
  // Once it is read: what it sets to something else than the file has, but for poses, and what its
  // handlers ask for as they are read a second time. Of either no more than kMaxKeys.
  const Keys& changed() const { return changed_; }
  const Keys& asked() const { return asked_; }
  // Whether events or timelines were left out, as there was no room for them; what else was read is
  // whole.
  bool isFull() const { return room_.isFull(); }

 private:
  enum class Flow { on, nextRound, leaveLoop, leaveFunction, stop };

  // reader.cpp: timelines
  void follow(const Pending& pending);
  void openTimeline(const Pending& pending);
  void keepTimeline();
  void followEachFrame(const Pending& pending);
  bool spend(size_t steps = 1);  // false when the budget is gone
  Scope* newScope(Scope* parent);
  // Whether the handler that is followed has made the scope or table itself.
  bool isOwn(size_t born) const { return inHandler_ && born == followed_; }

  // statements.cpp
  Flow walk(const Block& block, bool ownScope = true);
  Flow statement(const Stat& stat);
  struct Asked {
    Truth truth = Truth::yes;
    bool always = false, never = false;  // holds for every player, or for none
  };
  Asked asked(const Expr& condition);
  Flow branch(const Stat& stat);
  void giveBack(const Stat& stat);
  void doubt(Flow flow, int line);
  bool isUnsure() const { return unsure_ > 0 || left_ || skipped_; }
  Flow assign(const Stat& stat);
  void bindLocals(const Stat& stat);
  void bindFunction(const Stat& stat);
  void setIndexed(const Datum& object, const Datum& key, const Datum& value, int line);

  // threads.cpp
  Datum call(const Closure& closure, const std::vector<Datum>& arguments);
  bool endlessCall(const Closure& closure);
  void later(Pending pending, const Datum& function, std::vector<Datum> arguments);
  // task.spawn, delay and the like: beside what follows.
  void beside(const Datum& function, const std::vector<Datum>& arguments, double delay);

  // loops.cpp
  // One round of a loop; what ends only the round shows no more.
  Flow walkRound(const Block& body);
  Flow whileLoop(const Stat& stat);
  Flow countingLoop(const Stat& stat, bool repeats);
  void await();
  bool hasAwaited() const { return timeline_.awaits <= timeline_.events.size(); }
  void beginLoop();
  void leaveLoop();
  // What comes before a round, from 0; false: the loop is over.
  using RoundStart = std::function<bool(int round)>;
  // `begins` may be empty. `sure`: the loop ends by no condition.
  Flow foreverLoop(const Block& body, const RoundStart& begins, bool sure);
  Flow endlessFor(const Stat& stat, double from, double by, double rounds);
  Flow numericFor(const Stat& stat);
  Flow genericFor(const Stat& stat);
  using State = std::map<std::pair<InstanceId, std::string>, Datum>;
  State trackedState() const;

  // ways_out.cpp: how a loop ends by what stands in it
  std::set<std::string> pathsOf(const Expr& condition);
  bool assigns(const Block& body, const std::set<std::string>& paths, bool maybe = false);
  bool canLeave(const Block& body, bool inner);  // `inner`: of a loop in the loop
  bool isTold(const Expr& condition);
  bool countsToWayOut(const Block& body);
  int lateWayOut(const Block& round, const Block& body);
  void noteWayOut(Flow flow, int line);
  void keepWayOut(const Block& body);

  // evaluate.cpp: expressions
  Datum evaluate(const Expr& expr);
  Datum evaluated(const Expr& expr);
  std::vector<Datum> evaluateAll(const std::vector<ExprPtr>& list, size_t from);
  Datum nameValue(const std::string& name);
  Datum binary(const Expr& expr);
  Datum logical(const Expr& expr);
  Datum unsureValue(const Expr& expr);
  Datum tableValue(const Expr& expr);
  Datum field(const Datum& object, const std::string& name);
  Datum indexed(const Datum& object, const Datum& key);

  // calls.cpp: waits, threads, signals, methods
  Datum callValue(const Expr& expr);
  std::optional<Datum> scheduled(const std::string& name, const std::vector<Datum>& arguments);
  Datum methodValue(const Expr& expr);
  Datum methodOf(const Datum& object, const std::string& name, const std::vector<Datum>& arguments,
                 int line);
  Signal signalOf(const Expr& expr);
  Datum waitForSignal(const Expr& expr);
  void waitFor(double seconds, double least);
  Datum connect(const Expr& expr, const std::vector<Datum>& arguments, bool once);

  // connections.cpp: handlers that the script ends
  Datum connected(Pending pending, const Datum& function, std::vector<Datum> arguments);
  void disconnect(const Connection& connection, int line);
  void nameEnded();

  // second_reading.cpp: harm that a handler does once something has changed in play
  bool mentionsHarm() const;
  void keepHarmless(const Pending& pending);
  void readAgain();
  void noteTurn(InstanceId id, const std::string& name, const std::optional<Datum>& old,
                const Datum& now);
  void noteChange(InstanceId id, const std::string& name, const Datum& now);
  bool isTurned(InstanceId id, const std::string& name);

  // tweens.cpp: what plays, and what it makes of properties on the way
  void play(Tween* tween, int line);
  bool closesChain(const Tween* tween);
  void keepStart(Tween& tween);
  void takeUp(const Tween& tween, ScriptEvent& event, double done);
  void drive(const Tween& tween, const ScriptEvent& event);
  void comeBack(const Tween& tween, const ScriptEvent& event);
  bool isPlaying(const Tween* tween);
  Played* lastPlayed(const Tween* tween);
  double secondsLeft(const Tween* tween);  // until it is over
  void stop(const Tween* tween, bool pauses);
  void halt(const Tween* tween, const ScriptEvent& event);
  void finishTweens();
  void leaveGoing();
  void endGoing();
  double secondsOn(const Going& going) const { return time_ - going.goal.time + going.goal.done; }
  bool isOn(const Going& going) const;
  Pose poseOf(const Going& going) const;
  Datum valueOf(const Going& going) const;
  // Where a part, or what a model is placed by, is by now if it is at `pose` once all tweens are
  // over; NaN where the text does not tell.
  Pose tweenedFrame(InstanceId id, Pose pose) const;
  // What a tween makes of another property by now; nothing: none drives it.
  std::optional<Datum> tweenedValue(InstanceId id, const std::string& name) const;

  // instances.cpp: what instances answer
  Datum instanceField(InstanceId id, const std::string& name);
  std::optional<Datum> writtenField(InstanceId id, const std::string& name);
  std::optional<Datum> fileField(InstanceId id, const std::string& name) const;
  Datum colorOf(InstanceId id, const std::string& name) const;
  Datum instanceMethod(InstanceId id, const std::string& name, const std::vector<Datum>& arguments,
                       int line);
  Datum instanceSearch(InstanceId id, const std::string& name, const std::vector<Datum>& arguments,
                       bool* handled);
  Datum strangerMethod(const std::string& owner, const std::string& name,
                       const std::vector<Datum>& arguments, int line);
  Datum madeField(Made* made, const std::string& name);
  Datum newInstance(const std::vector<Datum>& arguments, int line);
  Datum createTween(const std::vector<Datum>& arguments, int line);
  Datum tweenField(const Tween* tween, const std::string& name);
  Datum children(InstanceId id, bool all);
  Datum serviceNamed(const std::string& name) const;

  // frames.cpp: poses of parts, and of models by what pivotOf takes for theirs
  Pose frameOf(InstanceId id);
  std::optional<Pose> movedFrame(InstanceId id);  // nothing: as in the file
  const Pose* writtenFrame(InstanceId id) const;
  const Pose& fileFrame(InstanceId id);
  Pose pivotOffset(InstanceId id) const;
  ScriptEvent& setFrame(InstanceId id, const Datum& value, int line);
  void setPivot(InstanceId id, const Datum& value, int line);
  void takeAlong(InstanceId model, const Pose& by);
  void setPoseGoals(const Tween& tween, int line);

  // once.cpp: what a handler does but once, as a flag keeps it from the next time
  void guard(const Stat& stat, size_t branch, size_t event);
  void closeGuards(size_t from);
  bool asksFlag(const Expr& expr, size_t& looked) const;
  bool outlives(const Expr& expr, Scope* scope, Scope* outside) const;
  Datum flagOf(const Expr& expr, Scope* scope, Scope* outside);
  Truth nextTime(const Expr& expr, Scope* scope, Scope* outside);
  void nameOnce(const Pending& pending);

  // effects.cpp: what assignments do
  void setField(const Datum& object, const std::string& name, const Datum& value, int line);
  void setInstance(InstanceId id, const std::string& name, const Datum& value, int line);
  void setStranger(const std::string& owner, const std::string& name, const Datum& value, int line);
  void setMade(Made* made, const std::string& name, const Datum& value, int line);
  void write(InstanceId id, const std::string& name, Datum value);
  void setParent(InstanceId id, const Datum& parent, int line);
  std::optional<bool> leadsToWorld(const Datum& parent);
  bool isInWorld(InstanceId id);
  void clear(InstanceId id, int line);
  Datum destroyLater(const std::string& method, const std::vector<Datum>& arguments, int line);
  // The new event, until the next one; without room for it one that no timeline has.
  ScriptEvent& emit(EventKind kind, InstanceId target, std::string property, int line);

  const Tree& tree_;
  ScriptReading reading_;
  Timeline timeline_;
  double time_ = 0;
  Scope* scope_;
  std::deque<Pending> pending_;
  std::vector<Played> played_;             // tweens of this timeline whose end sets something off
  std::map<const Tween*, double> paused_;  // those to go on, with the seconds that they have done
  int tweens_ = 0;                         // made so far
  // What the script wrote, and what was there before the current handler and the current endless
  // loop wrote it.
  using Old = std::map<Key, std::optional<Datum>>;
  std::map<Key, Datum> written_;
  Old beforeHandler_, beforeLoop_;
  bool mayHarm_ = false;                     // the text names health, or what takes it
  bool again_ = false;                       // handlers that have harmed nobody are read anew
  std::vector<Pending> harmless_;            // those, of touches
  std::set<int> heals_;                      // lines of them that give health
  Keys turned_;                              // set to something else in play, but for poses
  Keys changed_, asked_;                     // see changed() and asked()
  const Changes* changes_;                   // of all scripts, or null
  std::map<Key, std::vector<Going>> going_;  // what may still be driven
  size_t followed_ = 0;                      // timelines before this one
  std::map<InstanceId, Pose> fileFrames_;
  bool inHandler_ = false, triggered_ = false;
  int connections_ = 0;             // made so far
  int handler_ = 0;                 // the connection of the handler that is followed; 0: none
  bool ended_ = false;              // that one comes no more
  std::map<int, int> cut_;          // connections that the script ends, with the line that does it
  std::map<size_t, int> handlers_;  // timelines that connections have made
  const Function* body_ = nullptr;  // of the handler that is followed
  std::set<int> renewed_;           // connections whose handlers connect themselves anew
  Assignments assignments_;
  Variables variables_;
  std::vector<Guard> guards_;  // of the handler that is followed
  Arena arena_;
  Datum returned_;
  Datum maybeReturned_;            // by the function that is called, if a branch was taken
  bool mayReturn_ = false;         // there is such a branch
  size_t statements_ = 0;          // begun so far
  size_t idleSteps_ = 0;           // of handlers of each frame, in rounds that do nothing
  bool finishing_ = false;         // following what the ends of tweens set off
  InstanceId zone_ = kNoInstance;  // the part whose contents the script asked for last
  int unsure_ = 0;                 // open branches whose condition is unknown
  // A branch of this kind has left the function, or the round of the loop: what follows may not be.
  bool left_ = false, skipped_ = false;
  int loops_ = 0;  // that are open around what is followed
  struct Endless {
    int loops = 0;  // open in its rounds
    size_t calls = 0;
    int wayOut = 0;  // the line of one that may be taken
  };
  Endless endless_;       // the loop that is followed, if the timeline is in one
  size_t doubts_ = 0;     // ways out of a loop or function that may be taken, so far
  bool vague_ = false;    // the timeline has waited for a time that is not known
  bool stopped_ = false;  // an endless loop was met inside a call: what follows is never reached
  struct Active {
    const Function* function = nullptr;
    double time = 0;
    size_t event = 0;  // index of its first event
  };
  std::vector<Active> active_;     // functions that are being called, the outermost first
  std::vector<std::string> tags_;  // that it has asked CollectionService for
  size_t& budget_;
  TimelineRoom room_;
};

}  // namespace obby::importer::luau
