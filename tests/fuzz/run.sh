#!/usr/bin/env bash
# Runs every fuzz target of build/fuzz: `tests/fuzz/run.sh SECONDS`, so long for each. Inputs that fail stay
# in build/fuzz/failures.
set -euo pipefail
seconds=${1:?usage: run.sh SECONDS}
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
  [[ $name == fuzz_recording ]] && max_len=16384
  cp -r "tests/fuzz/corpus/$name" "$scratch"
  if "$target" -seed=1 -max_total_time="$seconds" -max_len="$max_len" "${limits[@]}" -print_final_stats=1 \
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
