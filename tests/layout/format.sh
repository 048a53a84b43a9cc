#!/usr/bin/env bash
# format.sh ROOT: every source looks as clang-format leaves it. Other versions of the tool differ, so
# only Debian 12's judges; exit 77: not judged here.
set -u
cd "$1" || exit 1
[[ "$(clang-format --version 2>/dev/null)" == *"version 14."* ]] || {
  echo "clang-format 14 is not installed: formatting is not judged"
  exit 77
}
failed=0
while IFS= read -r -d '' file; do
  clang-format --dry-run -Werror "$file" >/dev/null 2>&1 || { echo "$file is not formatted"; failed=1; }
done < <(find bin io solver problems tests benchmarks \( -name '*.h' -o -name '*.cc' \) -print0)
exit $failed
