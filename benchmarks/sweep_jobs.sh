#!/usr/bin/env bash
# sweep_jobs.sh [TRIALS [POINTS]]: tasks of a sweep a second against the number of jobs: so many
# simulated trials of 90 s, smoother and luinge at so many points each. On a machine with other work
# go by the processor's seconds for a task: they grow where jobs stand in each other's way.
set -euo pipefail
trials=${1:-4} points=${2:-5}
brachium=$(dirname "${BASH_SOURCE[0]}")/../build/bin/brachium
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for seed in $(seq "$trials"); do
  "$brachium" simulate --scenario=daily_brisk --duration_s=90 --seed="$seed" \
    --output="$folder/trials/$seed" >/dev/null
done
grid=1:30:$points:log
"$brachium" sweep plan --trials="$folder/trials/*" --method=smoother,luinge --output="$folder/sweep" \
  --vary="elbow_adduction_sigma_deg=$grid;luinge_adduction_sigma_deg=$grid"

tasks=$((2 * trials * points))
TIMEFORMAT='%R %U'
echo "jobs  seconds  tasks/s  processor s/task"
for jobs in $(seq "$(nproc)"); do
  rm -rf "$folder/sweep/results"
  spent=$({ time "$brachium" sweep run --manifest="$folder/sweep/manifest.jsonl" --jobs="$jobs" \
    >/dev/null; } 2>&1)
  awk -v jobs="$jobs" -v tasks="$tasks" \
    '{ printf "%4d %8.1f %8.2f %17.3f\n", jobs, $1, tasks / $1, $2 / tasks }' <<<"$spent"
done
"$brachium" sweep merge --manifest="$folder/sweep/manifest.jsonl"
