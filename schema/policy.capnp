# A policy file (policy.obp): a trained network, the data needed to use it, and the history of its training.
#
# One Cap'n Proto message, not packed. Numbers are little-endian floats in the order in which they are read. `hash`
# is XXH3 (64 bit) over the bytes of means, scales, and each layer's weights and biases, in that order.
@0xd3b1a7f20c5e4986;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::schema");

struct PolicyFile {
  version @0 :UInt32;             # version of this layout, now 1
  observationVersion @1 :UInt32;  # meaning of the inputs: kObservationVersion of lib/policy/observation.h
  moves @2 :UInt32;               # logits of the last layer; the value follows them, then padding
  means @3 :List(Float32);        # an input is clamped to (raw - mean) x scale, at most 5 either way
  scales @4 :List(Float32);
  layers @5 :List(PolicyLayer);   # all rectified, except the last
  hash @6 :UInt64;
  training @7 :PolicyTraining;
  valueMean @8 :Float32;       # reward = mean + deviation x output of the value head; not in `hash`, and
  valueDeviation @9 :Float32;  # used only to continue training; a deviation of 0 means unknown, as in older files
}

struct PolicyLayer {
  inputs @0 :UInt32;
  outputs @1 :UInt32;
  weights @2 :List(Float32);  # (inputs, outputs)
  biases @3 :List(Float32);   # (outputs)
}

struct PolicyTraining {
  # For information only, with one exception: training that starts from the policy weighs its normalisers by
  # `decisions`.
  command @0 :Text;
  version @1 :Text;       # version of the program
  seed @2 :UInt64;
  decisions @3 :UInt64;   # decisions that it learned from, including those of the policy where training started
  seconds @4 :Float64;    # wall-clock time
  hardest @5 :Float32;    # max difficulty of its levels at the end
  solved @6 :Float32;     # share of attempts solved at the end
  start @7 :Text;         # hash of the policy it started from; empty if there is none
}
