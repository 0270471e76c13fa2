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
    "ScriptedConstraint.WhatAScriptSetsForCertainCountsAsTheFiles",  // joints that scripts set
    "ScriptedConstraint.AServoSteppedUnderAnUnknownConditionIsAGuess",  // joints that scripts set
    "ScriptedConstraint.WhatAHingeTurnsToAndFroIsHeld",  // joints that scripts set
    "ScriptedConstraint.AJointThatAScriptTurnsIsNamed",  // joints that scripts set
    "ScriptedConstraint.WhatATouchSetsIsNamed",  // joints that scripts set
    "ScriptedConstraint.AnArmGoesWithABaseThatIsTweened",  // joints that scripts set
    "ScriptedStart.SwitchesThatAScriptSetsAtOnceAreSet",  // not looked at yet
    "ScriptedStart.WhatAConditionDecidesIsNamedNotSet",  // not looked at yet
    "ScriptedStart.WhatIsDestroyedIsLeftOut",  // not looked at yet
    "ScriptedStart.WhatMayBePutBackStaysAndIsNamed",  // not looked at yet
    "ScriptedStart.AMovedPartIsWhereTheScriptPutsIt",  // not looked at yet
    "ScriptedStart.SizesAreSetAsTheEngineTakesThem",  // not looked at yet
    "ScriptedStart.AnchorsAreThoseOfTheStart",  // not looked at yet
    "ScriptedStart.WhatAScriptJoinsItselfStaysAnchoredAndIsNamed",  // not looked at yet
    "ScriptedStart.APlatformThatItsScriptPutsThereBeforeItMovesIsImportedAsBefore",  // not looked at yet
    "ScriptedStart.APlaceThatAnotherScriptMovesFromIsNamed",  // not looked at yet
    "ScriptedStart.ManyPlacesOfManyPartsAreFollowedWithinABudget",  // not looked at yet
    "SecondReading.ALeverThatTheSameBodySetsWakesTheTrap",  // needs a probe after a probe
    "SecondReading.WhatHarmsFromTheSecondTouchOnIsAGuess",  // needs a probe after a probe
    "SecondReading.ANameMayBeALever",  // needs a probe after a probe
    "SecondReading.WhatABranchSetsThatMayNotBeTakenIsOneOfTwo",  // needs a probe after a probe
    "SecondReading.WhatASetUpMayHaveSetIsOneOfTwo",  // needs a probe after a probe
    "SecondReading.AStateInWhichThePlayerIsDeadIsHarm",  // needs a probe after a probe
    "SecondReading.WhatAScriptTurnsInPlayMayWakeATrap",  // needs a probe after a probe
    "SecondReading.AGoalByItsNameStaysOne",  // needs a probe after a probe
    "SecondReading.IsNamedBesideWhatComesButOnce",  // needs a probe after a probe
    "SecondReading.OnlyHarmCounts",  // needs a probe after a probe
    "SecondReading.HarmByAPartThatIsNotKnownIsNamed",  // needs a probe after a probe
    "Signals.HandlersInVariablesMayBeDisconnected",  // needs a second touch
    "Stages.TemplateCheckpointScriptMakesACheckpoint",  // not looked at yet
    "StudioPlace.is_read_as_the_place_that_it_is_of",  // not looked at yet
    "Unmodelled.ButtonsThatOpenSomethingElse",  // not looked at yet
    "Unmodelled.SpeedPadsSeatsToolsTerrainGroups",  // not looked at yet
    "Unmodelled.StagesBuiltAtRunTimeAndForeignCode",  // not looked at yet
    "Unmodelled.ModulesKitTagsAndTellingNames",  // not looked at yet
    "Unmodelled.HarmByExplosions",  // not looked at yet
    "Unmodelled.HarmToWhoEntersTheZoneOfAModule",  // not looked at yet
    "Unmodelled.EachPoseOfALoopDoesNotCostAllPartsOfItsModel",  // not looked at yet
    "WokenRoles.HarmByTheContentsOfAPart",  // needs a probe after a probe
    "WokenRoles.HarmByNoPartIsNamed",  // needs a probe after a probe
    "WokenRoles.AWokenScriptMayBeTheLeverOfATrap",  // needs a probe after a probe
    "WokenRoles.AMotionFromTheStartIsAGuess",  // needs a probe after a probe
    "WokenRoles.ATimerIsAGuessOrAButton",  // needs a probe after a probe
    "WokenRoles.WhatItChangesAsItBeginsIsNamed",  // needs a probe after a probe
    "WokenRoles.OtherTouchesAreGuesses",  // needs a probe after a probe
    "WokenRoles.WhatIsCertainComesBeforeTheirGuesses",  // needs a probe after a probe
    "WokenRoles.TheirCheckpointsLeaveThoseOfNames",  // needs a probe after a probe
    "Arcs.WhatIsWeldedToADoorGoesRoundIt",  // joints that scripts set
    "Carrying.SliderSteppedByAScript",  // joints that scripts set
    "Carrying.ASliderIsSteppedWhenItsScriptHasWaited",  // joints that scripts set
    "Carrying.ASliderThatIsSentBackTooSoonDoesNotArrive",  // joints that scripts set
    "Carrying.ASliderWhoseLoopWaitsFirstGoesToAllItsGoals",  // joints that scripts set
    "Carrying.ASliderThatIsSentToOnePlaceEachFrameArrives",  // joints that scripts set
    "Carrying.WhatASliderMotorMovesIsHeldWhereItsWayIsNotKnown",  // joints that scripts set
    "Doubt.AMotionThatWaitsForASignalIsAGuess",  // not looked at yet
    "EndedHandlers.WhatComesAtTheFirstTouchOnlyIsNamed",  // needs a second touch
    "EndedHandlers.AHandlerOfEachFrameEndsWhereItDisconnectsItself",  // needs a second touch
    "EndedHandlers.WhatComesAtOneFrameAfterASignalIsNotDoneAtTheStart",  // needs a second touch
    "EndedHandlers.AHandlerGoesOnUntilAThreadOfItsEndsIt",  // needs a second touch
    "EndedHandlers.AMotionThatAnotherThreadEndsIsNamed",  // needs a second touch
    "HandlerFlags.WhatIsNeverSetBackIsNamed",  // needs a second touch
    "HandlerFlags.TheyMayBeFieldsValuesAndAttributes",  // needs a second touch
    "HandlerFlags.PartsThatShareAFlagAreReadAlike",  // needs a second touch
    "HandlerFlags.WhatKillsOnceEachCharacterKills",  // needs a second touch
    "HandlerValues.WhatAnEndlessLoopSetsToAndFroMayBeEither",  // harm that comes and goes
    "HandlerValues.ACounterOfManyPartsLeavesThemAlike",  // needs a probe after a probe
    "Movers.AVelocityThatALoopTurnsRoundIsAMotion",  // joints and body movers that scripts set
    "Movers.ALinearVelocityGoesToAndFro",  // joints and body movers that scripts set
    "Movers.AVelocityThatATouchTurnsRoundIsNamed",  // joints and body movers that scripts set
    "Movers.AVelocityCountsFromWhereAScriptPlacesThePart",  // joints and body movers that scripts set
    "Movers.APlaceThatATweenSwingsIsAMotion",  // joints and body movers that scripts set
    "Movers.ASwingOfALocalScriptCountsAsOtherEndlessMotions",  // joints and body movers that scripts set
    "Movers.APlaceThatALoopTweensIsReachedAsTheTweenIs",  // joints and body movers that scripts set
    "Movers.LongTweensThatAreCutAgainAndAgainTakeNoMemory",  // joints and body movers that scripts set
    "Movers.WhatIsAlignedWithATweenedPartGoesWithIt",  // joints and body movers that scripts set
    "Movers.WhatALocalScriptSetsIsForOnePlayer",  // joints and body movers that scripts set
    "OtherScripts.ALeverOfAnotherScriptWakesTheTrap",  // needs a probe after a probe
    "OtherScripts.ItCountsWheneverItIsSet",  // needs a probe after a probe
    "OtherScripts.TwoLeversWakeATrapTogether",  // needs a probe after a probe
    "OtherScripts.WhatTheFirstReadingHasFoundStays",  // needs a probe after a probe
    "OtherScripts.WhatIsTooMuchToKeepIsNamed",  // needs a probe after a probe
    "OtherScripts.ATrapThatAsksForTooMuchToKeepIsFound",  // needs a probe after a probe
    "OtherScripts.ALeverWakesItsOwnTrapAlone",  // needs a probe after a probe
    "OtherScripts.WhatAClientSetsStaysThere",  // needs a probe after a probe
    "OtherScripts.FieldsOfAllScriptsMayBeEither",  // needs a probe after a probe
    "Places.ZandersTestLevel",  // not looked at yet
    "Places.JeffersonsFirstObby",  // not looked at yet
    "ScriptValues.AttributesThatALoopSetsAreNotKnownElsewhere",  // harm that comes and goes
    "ScriptValues.AColourThatTurnsMayBeAny",  // harm that comes and goes
    "ScriptedChanges.WhatComesLaterIsNamedNotDone",  // not looked at yet
    "ScriptedChanges.TheStartIsSetAndWhatFollowsIsNamed",  // not looked at yet
    "ScriptedChanges.SizesThatChangeByAndByAreNamed",  // not looked at yet
    "ScriptedChanges.EveryPartOfAModelCounts",  // not looked at yet
    "Doubt.HarmByAPartThatIsNotKnownIsNamed",  // a probe leaves before a slow poll
    "HandlerFlags.WhatIsSetBackComesAgain",  // needs a second touch
    "HandlerValues.ALoopOfAHandlerCountsFromWhereTheScriptHasBegun",  // not looked at yet
    "JumpPad.CharacterVelocityKeepsWhatTheScriptKeeps",  // not run since its parts stand apart
    "Kill.PollingTheContentsOfAHazard",  // the part stands at the spawn
    "Removal.WhatAButtonPutsBackIsNamed",  // not looked at yet
    "Removal.WhatATouchTakesOutVanishes",  // what Debris holds is not waited for
    "ScriptValues.AFunctionMayGiveOneOfTwo",  // not looked at yet
    "WokenScripts.AClientWakesOnlyClients",  // not looked at yet
    "WokenScripts.OneWakesTheOther",  // not looked at yet
};
// clang-format on

inline bool isReadTest() {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(test->test_suite_name()) + "." + test->name();
  return std::find(std::begin(kReadTests), std::end(kReadTests), name) != std::end(kReadTests);
}

}  // namespace obby::test
