# A struct with former names, for former_names_test.cpp.
@0xb1f0c7d25e9a6438;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::io::renamed");

using Obby = import "/schema/obby.capnp";

enum Kind {
  plain @0;
  sliding @1 $Obby.formerly("slippery");
}

struct Body {
  name @0 :Text;
  mass @1 :Float64 $Obby.formerly("weight");
  kind @2 :Kind;
  others @3 :List(Body) $Obby.formerly("children");
}
