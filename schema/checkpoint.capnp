# A checkpoint of obby-train: all state that decides what it learns next, so that interrupted training resumes exactly
# where it stopped.
#
# One Cap'n Proto message, not packed. It has no settings and no levels. A resumed run gets the settings again, and
# `settings` and the levels' hashes tell whether they are the same. Levels are made again from their numbers.
@0xa9d40f6e2b7c3158;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::schema");

struct SavedTraining {
  hash @0 :UInt64;     # XXH3 (64 bit) over the whole file with these eight bytes as 0
  version @1 :UInt32;  # of this layout: 5
  observationVersion @2 :UInt32;  # as in policy.capnp
  stateLayout @3 :UInt64;  # XXH3 over names, types and sizes of the fields of sim::World and sim::LooseBody
  program @4 :Text;    # version of the program, for information
  settings @5 :List(SavedSetting);
  seconds @6 :Float64;  # wall-clock time of all runs so far, for information
  iterations @7 :UInt64;
  decisions @8 :UInt64;
  solved @9 :Float64;   # share of playthroughs solved, smoothed
  hardest @10 :Float32;  # max difficulty of the next levels
  seen @11 :SavedSums;  # of observations
  learner @12 :SavedLearner;
  envGroups @13 :List(SavedEnvGroup);  # those of rank 0, then of rank 1, ...
  history @14 :SavedHistory;     # for the learning curve only
}

struct SavedSetting {
  name @0 :Text;
  value @1 :Text;  # numbers as the shortest decimal that reads back the same
}

struct SavedHistory {
  each @0 :UInt32;        # iterations per point
  iterations @1 :UInt32;  # since the last point
  reward @2 :Float64;     # their sum
  points @3 :List(SavedPoint);
}

struct SavedPoint {
  decisions @0 :UInt64;
  solved @1 :Float32;
  hardest @2 :Float32;
  reward @3 :Float32;  # per decision, mean since the last point
}

struct SavedSums {
  sum @0 :List(Float64);
  squares @1 :List(Float64);
  rows @2 :Float64;
}

struct SavedLearner {
  # Weights and the means of gradients and their squares (Adam): for each layer (inputs, outputs), then its biases.
  weights @0 :List(Float32);
  momentum @1 :List(Float32);
  squares @2 :List(Float32);
  steps @3 :UInt64;  # of Adam
  valueMean @4 :Float32;  # of the value head (Pop-Art)
  valueDeviation @5 :Float32;
  returns @6 :SavedSums;
}

struct SavedEnvGroup {
  places @0 :List(SavedPlace);
}

struct SavedEnvGroups {
  # Sent by each rank to the first one, for the file.
  envGroups @0 :List(SavedEnvGroup);
}

struct SavedPlace {
  # A level with its worlds. Worlds and dynamic bodies are the bytes of sim::World (lib/sim/world.h) and sim::LooseBody
  # (lib/sim/loose.h), which have no padding, one after another.
  taken @0 :UInt64;      # levels so far, with this one: its number in the source
  hardest @1 :Float32;   # difficulty with which it was requested
  levelHash @2 :UInt64;  # of the level, which must match
  played @3 :UInt32;     # playthroughs of it
  worlds @4 :Data;       # (players)
  loose @5 :Data;        # (players, dynamic bodies of the level)
  reached @6 :Data;      # states to begin from
  least @7 :List(Float32);   # (players), min studs left to the goal in this playthrough
  ticks @8 :List(UInt32);    # (players), of this playthrough
  fromStart @9 :List(Bool);  # (players)
  nextHardest @10 :Float32;  # difficulty with which the next level will be requested
  reachedLeast @11 :List(Float32);  # (reached), `least` of the player who was there
  solvedOnce @12 :Bool;  # a player has solved the level from the start
}
