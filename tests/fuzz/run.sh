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

# Runs one target, and states in a file whether it passed.
run() {
  local target=$1
  local name=${target##*/}
  local log=$scratch/$name.log
  local max_len=4096
  local runs=150000
  # 32 megapixels of colour take 96 MB, twice that inside the JPEG decoder, and the sanitizer frees memory late.
  local limits=(-timeout=10 -malloc_limit_mb=256 -rss_limit_mb=1024)
  [[ $name == fuzz_color_image ]] && runs=30000
  [[ $name == fuzz_recording ]] && runs=20000 && max_len=16384
  local extent=(-seed=1 -runs="$runs")
  [[ -n $seconds ]] && extent=(-max_total_time="$seconds")
  cp -r "tests/fuzz/corpus/$name" "$scratch"
  if "$target" "${extent[@]}" -max_len="$max_len" "${limits[@]}" -print_final_stats=1 \
    -artifact_prefix="build/fuzz/failures/$name-" "$scratch/$name" >"$log" 2>&1; then
    echo "$name: passed, $(awk '/average_exec_per_sec/ { print $2 }' "$log") runs a second" | tee "$scratch/$name.passed"
  else
    reason=$(grep -m1 -E 'violated:|what\(\):|runtime error:|ERROR:' "$log" || tail -n1 "$log")
    echo "$name: failed, $reason; $(grep -o 'written to .*' "$log" || true)" | tee "$scratch/$name.failed"
  fi
}
export -f run
export seconds scratch

find build/fuzz/tests/fuzz -maxdepth 1 -name 'fuzz_*' -type f -executable | sort |
  xargs -P "$(nproc)" -I{} bash -c 'run {}'
passed=$(find "$scratch" -maxdepth 1 -name '*.passed' | wc -l)
failed=$(find "$scratch" -maxdepth 1 -name '*.failed' | wc -l)
echo "$passed passed, $failed failed"
((passed > 0 && failed == 0))
