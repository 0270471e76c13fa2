// Tests whose scenes still have their scripts read instead of run, and what they wait for:
// - keys by samples: motions have keys from samples, not from tweens; what ends before the probes
//   begin is at its end;
// - needs a probe after a probe: what one part does once another one has been touched;
// - needs a second touch: whether a part does again what it did;
// - harm that comes and goes: a probe comes at one time only.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace obby::test {

// clang-format off
constexpr std::string_view kReadTests[] = {
    "Signals.TheEndOfATweenIsKnown",  // keys by samples
    "TweenOverlap.ALaterTweenOfTheSamePropertyEndsTheFirst",  // keys by samples
    "TweenOverlap.AnEasedTweenIsCutOnItsWay",  // keys by samples
    "TweenOverlap.OfTwoThatArePlayedAtOnceTheLastCounts",  // keys by samples
    "TweenOverlap.DifferentPropertiesGoSideBySide",  // keys by samples
    "TweenOverlap.APlatformMayGoToAndFroAndTurn",  // keys by samples
    "TweenOverlap.ALoopMayTurnWhatATweenMoves",  // keys by samples
    "TweenOverlap.ATurnThatBeganLaterIsBehind",  // keys by samples
    "TweenOverlap.ALoopGoesOnBesideATurn",  // keys by samples
    "TweenOverlap.SwingsOfCommonRoundsAreOneMotion",  // keys by samples
    "TweenOverlap.ALoopThatWaitsFirstIsOneRoundLong",  // keys by samples
    "TweenOverlap.WhatIsTweenedToOnePlaceEachFrameIsThere",  // keys by samples
    "TweenOverlap.TweensThatCutEachOtherInALoopSwing",  // keys by samples
    "TweenOverlap.ALoopThatChangesMoreIsOneRoundLong",  // keys by samples
    "TweenOverlap.PlayOfWhatPlaysDoesNothing",  // keys by samples
    "TweenOverlap.WhatIsCancelledStaysOnItsWay",  // keys by samples
    "TweenOverlap.WhatIsPausedGoesOnWithWhatIsLeft",  // keys by samples
    "TweenOverlap.WhatIsPausedInItsDelayWaitsForTheRest",  // keys by samples
    "TweenOverlap.AnEndlessTweenThatALoopPausesIsNamed",  // keys by samples
    "TweenOverlap.WhatIsTooLongIsNotCalledMixedUp",  // keys by samples
    "TweenOverlap.APoseMayBeSetBesideAnEndlessTween",  // keys by samples
    "TweenOverlap.WhatMakesNoSingleMotionIsNamed",  // keys by samples
    "TweenOverlap.OfTwoScriptsThatMoveAPartTheFirstCounts",  // keys by samples
    "TweenReading.APoseOnTheWayIsWhereItHasComeTo",  // keys by samples
    "TweenReading.AWholeCFrameAndAPivotAreOnTheWayToo",  // keys by samples
    "TweenReading.WhatReversesIsBackWhereItBegan",  // keys by samples
    "TweenReading.OtherPropertiesAreOnTheWayToo",  // keys by samples
    "TweenReading.WaitingForAnEndTakesWhatIsLeft",  // keys by samples
    "TweenReading.AfterAWaitOfUnknownTimeATweenIsOver",  // keys by samples
    "TweenReading.AfterAWaitForWhatItReachesATweenIsOver",  // keys by samples
    "TweenReading.ALoopMayTurnWhatAnotherLoopTweens",  // keys by samples
    "TweenReading.WhatTheTextDoesNotTellIsNamed",  // keys by samples
    "Tween.EndlessWholeTurnsAreASpin",  // keys by samples
    "Tween.LongTurnsGoTheWholeWay",  // keys by samples
    "Tween.WhatTurnsAboutTwoAxesFollowsItsAngles",  // keys by samples
    "Tween.GoalsOfOneTweenAreReachedTogether",  // keys by samples
    "Tween.AWayBackRunsTimeBackwards",  // keys by samples
    "Tween.AnUnknownGoalOfAPoseLeavesThePartWhereItIs",  // keys by samples
    "Tween.ALoopAfterItTakesNothingAway",  // keys by samples
    "Tween.AnEndlessOneBeginsWhereTheOneBeforeItEnds",  // keys by samples
    "Tween.AComputedTimeIsAGuess",  // keys by samples
    "Tween.OfManyRoundsTheFirstOnesAreDone",  // keys by samples
    "Tween.OneThatRepeatsForLongerThanAMotionCanIsEndless",  // keys by samples
    "Tween.HostileTurnsHaveFewKeys",  // keys by samples
    "ForLoops.ThatCountForEverAreEndless",  // keys by samples
    "ForLoops.ThatOutlastAMotionAreEndless",  // keys by samples
    "ForLoops.OfManyRoundsWithoutAWaitAreNamed",  // keys by samples
    "ForLoops.ThatCountForDaysAndOnlyWaitArePassedOver",  // keys by samples
    "ForLoops.ThatCountForEverMayBeLeft",  // keys by samples
    "ForLoops.AWayThatALoopLeavesIsAMotionThatComesOnce",  // keys by samples
    "ForLoops.AWayOfAModelThatEndsByWhereItIs",  // keys by samples
    "Luau.BrokenTextKeepsWhatCanBeRead",  // not looked at yet
    "Luau.EndsOfTweensThatAreNotFollowedAreNamed",  // not looked at yet
    "Luau.BigTablesAndLongTextsTakeMoreSteps",  // not looked at yet
    "Luau.RoundsThatAreNotFollowedAreNamed",  // not looked at yet
    "Motion.TweenBetweenMarkerPartsInALoop",  // keys by samples
    "Motion.EndlessTweenThatReversesGoesThereAndBack",  // keys by samples
    "Motion.StepsThereAndBackWithPauses",  // keys by samples
    "Motion.SpinRatesFollowTheWaits",  // keys by samples
    "Motion.AKillPartMaySpinToo",  // keys by samples
    "Motion.ModelsTurnAboutTheirPivot",  // keys by samples
    "Motion.WhatIsInAModelIsReadWhereTheModelHasTakenIt",  // keys by samples
    "Motion.ModelsTurnAboutTheEditedPivotOfTheirPrimaryPart",  // keys by samples
    "Motion.WhatATouchStartsIsNamedNotMoved",  // keys by samples
    "Phase.TheWaitBeforeWhatRepeatsIsItsOffset",  // keys by samples
    "Phase.PlatformsOfOneScriptGoOneAfterTheOther",  // keys by samples
    "Phase.WhatComesButOnceWaitsWithItsKeys",  // keys by samples
    "Phase.WhatWaitsForMoreThanTwentyMinutesRests",  // keys by samples
    "Phase.ARoundMayTakeTwentyMinutes",  // keys by samples
    "PoseSteps.AWayThatALoopMakesIsAMotionThatComesOnce",  // keys by samples
    "PoseSteps.BeginWhereTheScriptPutsThePartOnceItHasWaited",  // keys by samples
    "PoseSteps.AreNamedWhereAnotherThreadPutsThePartElsewhereLater",  // keys by samples
    "PoseSteps.MayTurn",  // keys by samples
    "PoseSteps.WhatTheTextDoesNotTellIsNamedNotMoved",  // keys by samples
    "PoseSteps.LeaveAPartToWhatMovesItForEver",  // keys by samples
    "ScriptLoops.AFunctionThatCallsItselfForEverIsALoop",  // keys by samples
    "ScriptWaits.HowATweenEndedIsKnown",  // keys by samples
    "ScriptWaits.ATweenThatMayPlayIsNotKnownToBeOver",  // keys by samples
    "ScriptWaits.ATweenThatAnotherOneCutsDoesNotSurelyComplete",  // keys by samples
    "ScriptWaits.RoundsThatAreNotFollowedAreNamed",  // keys by samples
    "ScriptLoops.VelocitiesThatChangeAreNamed",  // not looked at yet
    "ScriptLoops.WhatEachFrameDoesFromATouchOnIsNamed",  // not looked at yet
    "ScriptLoops.WhatStandsBehindALoopThatEndsItselfIsRead",  // not looked at yet
};
// clang-format on

inline bool isReadTest() {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(test->test_suite_name()) + "." + test->name();
  return std::find(std::begin(kReadTests), std::end(kReadTests), name) != std::end(kReadTests);
}

}  // namespace obby::test
