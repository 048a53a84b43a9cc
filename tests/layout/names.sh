#!/usr/bin/env bash
# names.sh ROOT: all headers go into one translation unit, no name twice, each named as .clang-tidy
# says. Exit 77: no clang-tidy here.
set -u
cd "$1" || exit 1
command -v clang-tidy >/dev/null || {
  echo "clang-tidy is not installed: names are not judged"
  exit 77
}
unit=$(mktemp --suffix=.cc)
trap 'rm -f "$unit"' EXIT
find problems solver io bin -name '*.h' | sort | sed 's/.*/#include "&"/' >"$unit"
clang-tidy --quiet --config-file=.clang-tidy --warnings-as-errors='*' --header-filter='.*' "$unit" -- \
  -std=c++20 -I. -isystem /usr/include/eigen3 2>/dev/null
