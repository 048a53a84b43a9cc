#!/usr/bin/env bash
# file_size.sh ROOT: no source is longer than one sitting.
set -u
cd "$1" || exit 1
longest=400
failed=0
while IFS= read -r -d '' file; do
  lines=$(wc -l <"$file")
  [ "$lines" -le "$longest" ] || { echo "$file has $lines lines, more than $longest"; failed=1; }
done < <(find bin io solver problems \( -name '*.h' -o -name '*.cc' \) -print0)
exit $failed
