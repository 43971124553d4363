#!/usr/bin/env bash
# Scores TOSS, its parts and other methods on all simulated scenes and on the real sequence, and
# writes share/doc/results.md with plots and pictures: tests/benchmarks/scoreboard.sh [--quick]
# [OPTION...]; see --help. Without --quick it takes up to an hour on two cores. The real sequence is
# taken from TOSS_TEST_DATA (default: ../shared/data beside the checkout) and left out where it is
# absent. OctoMap's row needs liboctomap-dev.
set -euo pipefail

cd "$(dirname "$0")/../.."
bash share/build.sh release scoreboard
real="${TOSS_TEST_DATA:-../shared/data}/kitti-tracking-0000"
options=()
[ -d "$real" ] && options+=(--real "$real")
commit="$(git describe --always --dirty 2>/dev/null || true)"
[ -n "$commit" ] && options+=(--commit "$commit")
exec build/tests/benchmarks/scoreboard share/doc "${options[@]}" "$@"
