#!/usr/bin/env bash
# top_level.sh ROOT: the repository's top level holds the rooms and nothing else.
set -u
cd "$1" || exit 1
failed=0
for entry in * .[!.]*; do
  [ -e "$entry" ] || continue
  case $entry in
    CMakeLists.txt | README.md | LICENSE | CHANGELOG.md) ;;
    bin | io | solver | problems | tests | benchmarks) ;;
    .ci | .clang-format | .clang-tidy | .git | .gitignore | .cache) ;;
    build* | results) ;;
    *) echo "the top level does not know '$entry'"; failed=1 ;;
  esac
done
exit $failed
