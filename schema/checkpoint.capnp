# A checkpoint of obby-train: all state that its further learning depends on. Interrupted training resumes exactly where
# it stopped.
#
# It is one Cap'n Proto message, not packed. It has no settings and no levels. A resumed run is given the settings
# again; `settings` and the levels' hashes tell whether they are the same. Levels are made again from their numbers.
@0xa9d40f6e2b7c3158;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::schema");

struct SavedTraining {
  hash @0 :UInt64;     # XXH3 (64 bit) of the whole file, with these eight bytes as 0
  version @1 :UInt32;  # version of this layout, now 5
  observationVersion @2 :UInt32;  # as in policy.capnp
  stateLayout @3 :UInt64;  # XXH3 of the names, types and sizes of the fields of sim::World and sim::RigidBody
  program @4 :Text;    # version of the program, for information
  settings @5 :List(SavedSetting);
  seconds @6 :Float64;  # wall-clock time of all runs so far, for information
  iterations @7 :UInt64;
  decisions @8 :UInt64;
  solved @9 :Float64;   # share of attempts solved, smoothed
  hardest @10 :Float32;  # max difficulty of the next levels
  seen @11 :SavedSums;  # sums of the observations
  learner @12 :SavedLearner;
  envGroups @13 :List(SavedEnvGroup);  # env groups of rank 0, then those of rank 1, ...
  obsoleteHistory @14 :AnyPointer;  # points of a learning curve, in files of earlier versions
}

struct SavedSetting {
  name @0 :Text;
  value @1 :Text;  # numbers as the shortest decimal that reads back the same
}

struct SavedSums {
  sum @0 :List(Float64);
  squares @1 :List(Float64);
  rows @2 :Float64;
}

struct SavedLearner {
  # Weights and the means of gradients and their squares (Adam). Each layer has (inputs, outputs), then its biases.
  weights @0 :List(Float32);
  momentum @1 :List(Float32);
  squares @2 :List(Float32);
  steps @3 :UInt64;  # number of Adam steps
  valueMean @4 :Float32;  # mean of the value head's targets (Pop-Art)
  valueDeviation @5 :Float32;
  returns @6 :SavedSums;
}

struct SavedEnvGroup {
  places @0 :List(SavedPlace);
}

struct SavedEnvGroups {
  # Each rank sends its env groups to the first rank for the file.
  envGroups @0 :List(SavedEnvGroup);
}

struct SavedPlace {
  # A level with its worlds. The worlds and dynamic bodies are the bytes of sim::World (lib/sim/world.h) and
  # sim::RigidBody (lib/sim/rigid_body.h), one after another. Both have no padding.
  taken @0 :UInt64;      # number of levels so far, including this one, which is its number in the source
  hardest @1 :Float32;   # difficulty with which it was requested
  levelHash @2 :UInt64;  # hash of the level, which must match
  played @3 :UInt32;     # attempts at the level
  worlds @4 :Data;       # (players)
  bodies @5 :Data;       # (players, dynamic bodies of the level)
  reached @6 :Data;      # states that attempts can start from
  minLeft @7 :List(Float32);   # (players), min studs left to the goal in this attempt
  ticks @8 :List(UInt32);    # (players), ticks of this attempt
  fromStart @9 :List(Bool);  # (players)
  nextHardest @10 :Float32;  # difficulty with which the next level will be requested
  reachedMinLeft @11 :List(Float32);  # (reached), `minLeft` of the player who reached the state
  solvedOnce @12 :Bool;  # a player has solved the level from the start
}
