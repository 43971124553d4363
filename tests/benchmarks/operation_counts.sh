#!/usr/bin/env bash
# Counts the instructions that each stage takes per scan of one simulated log, and compares them
# with the checked-in counts, as times on a shared machine tell little:
# tests/benchmarks/operation_counts.sh [--update]
# Exit code 1 if a stage takes over 10 % more than tests/benchmarks/operation_counts.csv says;
# --update rewrites that file. Needs valgrind; takes a few minutes.
set -euo pipefail

cd "$(dirname "$0")/../.."
reference=tests/benchmarks/operation_counts.csv
scene=urban
scans=24
update=no
case "${1:-}" in
  --update) update=yes ;;
  "") ;;
  *) echo "usage: tests/benchmarks/operation_counts.sh [--update]" >&2; exit 2 ;;
esac
bash share/build.sh release toss

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
toss=build/apps/toss/toss
"$toss" --quiet simulate "$scene" "$work/log.rawlog" --frames "$scans" --seed 1
valgrind --tool=callgrind --callgrind-out-file="$work/counts" --log-file="$work/valgrind.log" \
  --toggle-collect='toss::Pipeline::process(*' --toggle-collect='toss::Pipeline::decideRest(*' \
  --toggle-collect='toss::Pipeline::settleNext(*' --toggle-collect='toss::Segmenter::segment(*' \
  "$toss" --quiet map "$work/log.rawlog" --out "$work/run" --threads 1 --no-snapshots \
  --live-labels ||
  { cat "$work/valgrind.log" >&2; exit 2; }
callgrind_annotate --inclusive=yes --threshold=100 "$work/counts" >"$work/functions"

# Instructions in a function and all that it calls, in millions per scan.
count() {
  awk -v name="$1(" -v scans="$scans" '
    (at = index($0, ":toss::" name)) && !found {
      found = 1
      gsub(/,/, "", $1)
      printf "%.3f", $1 / scans / 1e6
    }
    END { if (!found) printf "0" }' "$work/functions"
}
stages() {
  local inside=Pipeline::Implementation segment ground objects track boxes record claims decided
  segment="$(count Segmenter::segment)" ground="$(count GroundSegmentation::segment)"
  objects="$(count ObjectSegmentation::segment)" track="$(count "$inside::track")"
  boxes="$(count detectInstances)" record="$(count RecordBuilder::build)"
  claims="$(count HindsightClaims::add)" decided="$(count "$inside::decideAll")"
  echo "projection $(awk "BEGIN { print $segment - $ground - $objects }")"
  echo "ground $ground"
  echo "objects $objects"
  echo "boxes $boxes"
  echo "tracking $(awk "BEGIN { print $track - $boxes - $record }")"
  echo "claims $(awk "BEGIN { print $record + $claims }")"
  echo "visibility $(count "$inside::askViews")"
  echo "voting $(count "$inside::vote")"
  echo "labels $(count "$inside::labelLive")"
  # No scan of so short a log is complete before it ends.
  echo "mapping $(awk "BEGIN { print $decided - $claims }")"
  echo "settling $(count "$inside::settleFirst")"
}

stages >"$work/stages"
if [ "$update" = yes ]; then
  {
    echo "stage,million_instructions_per_scan"
    awk '{ printf "%s,%.3f\n", $1, $2 }' "$work/stages"
  } >"$reference"
fi
awk -F '[ ,]' '
  NR == FNR { if (FNR > 1) before[$1] = $2; next }
  {
    ratio = before[$1] > 0 ? $2 / before[$1] : 1
    slower = ratio > 1.1
    failed += slower
    printf "%-12s %9.3f M per scan, %.3f of the reference%s\n", $1, $2, ratio, \
           slower ? "  SLOWER" : ""
  }
  END { exit failed > 0 }' "$reference" "$work/stages"
