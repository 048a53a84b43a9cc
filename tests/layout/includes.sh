#!/usr/bin/env bash
# includes.sh ROOT: who may include whom is bin -> {io, solver} -> problems; flags are bin's alone.
set -u
cd "$1" || exit 1
failed=0

# refuse ROOM PATTERN WHY: no source in ROOM includes what PATTERN matches.
refuse() {
  [ -n "$(find "$1" -name '*.h' -o -name '*.cc')" ] || { echo "$1: no sources"; failed=1; }
  if grep -rnE --include='*.h' --include='*.cc' "^ *# *include *[<\"]($2)" "$1"; then
    echo "$1: $3"
    failed=1
  fi
}

refuse problems '(io|solver|bin|tests)/|nlohmann/' 'problems includes neither files nor methods'
refuse io '(solver|bin|tests)/|ceres/' 'io knows problems only'
refuse solver '(io|bin|tests)/|nlohmann/' 'solver knows problems only'
refuse bin 'tests/' 'the program does not include tests'
for room in problems io solver; do refuse "$room" 'gflags/' 'flags belong to bin'; done
exit $failed
