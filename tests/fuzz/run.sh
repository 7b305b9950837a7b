#!/usr/bin/env bash
# Runs every fuzz target of build/fuzz. Without an argument each gets the same inputs whenever it is built from
# the same sources (about ten seconds of them), so that a test passes or fails again; `tests/fuzz/run.sh
# SECONDS` searches for new failures for so long. Inputs that fail stay in build/fuzz/failures.
set -euo pipefail
seconds=${1:-}
cd "$(dirname "$0")/../.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p build/fuzz/failures

# 32 megapixels of colour take 96 MB, twice that inside the JPEG decoder, and the sanitizer frees memory late.
limits=(-timeout=10 -malloc_limit_mb=256 -rss_limit_mb=1024)

passed=0
failed=0
for target in build/fuzz/tests/fuzz/fuzz_*; do
  [[ -f $target && -x $target ]] || continue
  name=${target##*/}
  log=$scratch/$name.log
  max_len=4096
  runs=150000
  [[ $name == fuzz_color_image ]] && runs=30000
  [[ $name == fuzz_recording ]] && runs=20000 && max_len=16384
  extent=(-seed=1 -runs="$runs")
  [[ -n $seconds ]] && extent=(-max_total_time="$seconds")
  cp -r "tests/fuzz/corpus/$name" "$scratch"
  if "$target" "${extent[@]}" -max_len="$max_len" "${limits[@]}" -print_final_stats=1 \
    -artifact_prefix="build/fuzz/failures/$name-" "$scratch/$name" >"$log" 2>&1; then
    passed=$((passed + 1))
    echo "$name: passed, $(awk '/average_exec_per_sec/ { print $2 }' "$log") runs a second"
  else
    failed=$((failed + 1))
    reason=$(grep -m1 -E 'violated:|what\(\):|runtime error:|ERROR:' "$log" || tail -n1 "$log")
    echo "$name: failed, $reason; $(grep -o 'written to .*' "$log" || true)"
  fi
done
echo "$passed passed, $failed failed"
((passed > 0 && failed == 0))
