// Notes events that scripts listen to and values that they read, if nothing raised or changed them
// while the place ran. The level lacks their consequences.
#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "import/observed/roles.h"

namespace obby::importer {
namespace {

using Heeds = std::map<std::string, std::vector<engine::Heed>>;

constexpr std::string_view kProperty = "property ";  // before the name in change signals
// Values that the engine changes in play. Only scripts change other values, and the runtime sees
// those changes.
constexpr std::string_view kVaried[] = {
    "Occupant", "SeatPart",      "Sit",           "Steer",         "SteerFloat",
    "Throttle", "ThrottleFloat", "FloorMaterial", "MoveDirection", "Jump"};
// Other values that scripts read, most by a function.
constexpr std::string_view kRead[] = {"GetState",       "Velocity",
                                      "IsKeyDown",      "IsMouseButtonPressed",
                                      "GetKeysPressed", "GetMouseButtonsPressed"};
// Classes whose events do not matter to a course, or are raised by scripts.
constexpr std::string_view kClasses[] = {"BindableEvent",
                                         "RemoteEvent",
                                         "UnreliableRemoteEvent",
                                         "RunService",
                                         "Tween",
                                         "Sound",
                                         "SoundService",
                                         "MarketplaceService",
                                         "BadgeService",
                                         "LogService",
                                         "ScriptContext",
                                         "GuiService",
                                         "Lighting",
                                         "Camera",
                                         "Players",
                                         "DataModel",
                                         "TeleportService",
                                         "ContentProvider",
                                         "SocialService",
                                         "StarterGui",
                                         "VoiceChatService",
                                         "LocalizationService",
                                         "VRService",
                                         "HapticService",
                                         "TweenBase"};
// Events that the runtime raises itself, or that only affect appearance.
constexpr std::string_view kEvents[] = {"Changed",
                                        "AncestryChanged",
                                        "ChildAdded",
                                        "ChildRemoved",
                                        "DescendantAdded",
                                        "DescendantRemoving",
                                        "Destroying",
                                        "AttributeChanged",
                                        "CharacterAdded",
                                        "CharacterRemoving",
                                        "CharacterAppearanceLoaded",
                                        "Idled",
                                        "OnTeleport",
                                        "Touched",
                                        "TouchEnded",
                                        "Died",
                                        "HealthChanged",
                                        "StateEnabledChanged",
                                        "AnimationPlayed",
                                        "ApplyDescriptionFinished",
                                        "DidLoop",
                                        "KeyframeReached",
                                        "PromptShown",
                                        "PromptHidden",
                                        "MouseEnter",
                                        "MouseLeave",
                                        "MouseMoved",
                                        "MouseHoverEnter",
                                        "MouseHoverLeave",
                                        "MouseWheelForward",
                                        "MouseWheelBackward",
                                        "SelectionGained",
                                        "SelectionLost",
                                        "InputChanged",
                                        "Move",
                                        "Idle",
                                        "WheelForward",
                                        "WheelBackward",
                                        "WindowFocused",
                                        "WindowFocusReleased",
                                        "LastInputTypeChanged",
                                        "GamepadConnected",
                                        "GamepadDisconnected",
                                        "TextBoxFocused",
                                        "TextBoxFocusReleased",
                                        "Focused",
                                        "PointerAction"};

template <size_t kCount>
bool isIn(const std::string_view (&list)[kCount], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

// Returns true for touch screen events, which have the effects of keys and clicks.
bool isOfTouchScreen(std::string_view type, std::string_view event) {
  return type != "Part" && event.starts_with("Touch") && event != "Touched";
}

// Returns true if the course does not depend on the event or value.
bool isHarmless(std::string_view name) {
  const size_t dot = name.find('.');
  const std::string_view type = name.substr(0, dot), event = name.substr(dot + 1);
  if (event.starts_with(kProperty)) return !isIn(kVaried, event.substr(kProperty.size()));
  return isIn(kClasses, type) || isIn(kEvents, event) || isOfTouchScreen(type, event);
}

// Returns what did not happen: the event was not raised, or the value did not change.
std::string absence(std::string name) {
  const size_t property = name.find(kProperty), member = name.find('.') + 1;
  if (property != std::string::npos) name.erase(property, kProperty.size());
  const bool isValue = property != std::string::npos || isIn(kVaried, name.substr(member)) ||
                       isIn(kRead, name.substr(member));
  return name + (isValue ? " did not change" : " was not raised") + " while scripts ran; ";
}

class Unraised {
 public:
  explicit Unraised(const engine::Report& report) {
    engine::eachObservation(report, [this](const engine::Observation& seen) { add(seen); });
  }

  Heeds all() && {
    std::erase_if(heeds_, [&](const auto& entry) {
      return happened_.contains(entry.first) || isHarmless(entry.first);
    });
    return std::move(heeds_);
  }

 private:
  void add(const engine::Observation& seen) {
    heeds_.insert(seen.heeded.begin(), seen.heeded.end());
    happened_.insert(seen.happened.begin(), seen.happened.end());
  }

  Heeds heeds_;
  std::map<std::string, bool> happened_;
};

}  // namespace

void noteUnraised(RoleContext& context, const engine::Report& report) {
  for (const auto& [name, heeds] : Unraised(report).all())
    for (const engine::Heed& heed : heeds)
      context.level.noteUnmodelled("event that is not raised", context.tree, heed.target,
                                   absence(name) + lineReason(context.tree, heed.line));
}

}  // namespace obby::importer
