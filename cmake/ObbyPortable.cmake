# Static libraries for the simulator and the bridge: Cap'n Proto from its archives, fmt and xxhash
# from their headers, zlib by ZLIB_USE_STATIC_LIBS. Debian has no archive of fmt; --as-needed drops
# the shared library that its target names.
foreach(name kj capnp kj-async kj-http kj-gzip)
  find_library(OBBY_STATIC_${name} lib${name}.a REQUIRED)
  set_target_properties(CapnProto::${name} PROPERTIES IMPORTED_LOCATION ${OBBY_STATIC_${name}})
endforeach()
set_target_properties(fmt::fmt PROPERTIES INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
set_target_properties(PkgConfig::xxhash PROPERTIES INTERFACE_COMPILE_DEFINITIONS XXH_INLINE_ALL)
