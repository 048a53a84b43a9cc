#!/usr/bin/env bash
# installed.sh BUILD ROOT: installs the build under a prefix of its own, builds the program in
# tests/package against it, and lets both estimate the same trial.
set -eu
build=$1 example=$2/tests/package
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix

fail() {
  echo "$*" >&2
  exit 1
}

cmake --install "$build" --prefix "$prefix" >"$scratch/log"
for file in bin/brachium share/man/man1/brachium.1 share/bash-completion/completions/brachium \
  include/brachium/problems/estimate.h lib/cmake/brachium/brachium-config.cmake; do
  [ -s "$prefix/$file" ] || fail "$file was not installed"
done
if grep -rl "$2/" "$prefix/lib/cmake" "$prefix/include"; then fail "these name the source folder"; fi

cmake -S "$example" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
  >>"$scratch/log" 2>&1 && cmake --build "$scratch/build" >>"$scratch/log" 2>&1 ||
  { cat "$scratch/log" >&2; fail "the example was not built"; }

brachium=$prefix/bin/brachium
cd "$scratch"
"$brachium" simulate --scenario=reach --duration_s=16 --output=trial >/dev/null
"$brachium" reconstruct --trial=trial --output=estimate >/dev/null
build/flexion trial >flexion.csv

# The same column by the program, cut to as many digits.
awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; print "time_s,elbow_flexion_deg"; next }
  { printf "%.4f,%.3f\n", $column["time_s"], $column["elbow_flexion_deg"] }' \
  estimate/estimate.csv >expected.csv
[ "$(wc -l <expected.csv)" -gt 1000 ] || fail "the estimate is short"
cmp flexion.csv expected.csv
