// Connections of handlers: what the script does to end them.
#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

// Whether nobody plays on after the signal, so that what it ends is missed by nobody.
bool comesAtEnd(const std::string& signal) {
  static constexpr std::string_view kSignals[] = {"Destroying", "AncestryChanged", "PlayerRemoving",
                                                  "CharacterRemoving", "Died"};
  return std::find(std::begin(kSignals), std::end(kSignals), signal) != std::end(kSignals);
}

}  // namespace

// The handler of a signal of instances, which is followed later. One of a touch that connects
// itself anew goes on, whatever it ends: the first time stands for all.
Datum Reader::connected(Pending pending, const Datum& function, std::vector<Datum> arguments) {
  const Connection made{++connections_};
  const auto* closure = function.as<Closure>();
  const bool ofTouches = timeline_.trigger == Trigger::touch && pending.trigger == Trigger::touch;
  if (ofTouches && pending.touched == timeline_.touched && closure && closure->function == body_) {
    renewed_.insert(handler_);
    return {made};
  }
  pending.connection = made.number;
  if (pending.once) cut_.try_emplace(made.number, pending.line);
  later(std::move(pending), function, std::move(arguments));
  return {made};
}

// A handler that ends itself goes on to its last line.
void Reader::disconnect(const Connection& connection, int line) {
  if (comesAtEnd(timeline_.signal)) return;
  cut_.try_emplace(connection.number, line);
  if (connection.number == handler_ && !isUnsure()) ended_ = true;
}

void Reader::nameEnded() {
  for (const auto& [timeline, number] : handlers_) {
    const auto cut = cut_.find(number);
    if (cut == cut_.end() || renewed_.count(number) > 0) continue;
    reading_.timelines[timeline].cutLine = cut->second;
  }
}

}  // namespace obby::importer::luau
