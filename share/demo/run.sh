#!/usr/bin/env bash
# Makes a demo log of a street full of traffic, maps it, and scores the map:
# share/demo/run.sh [OUTPUT_FOLDER]
set -euo pipefail

top="$(cd "$(dirname "$0")/../.." && pwd)"
out="${1:-$top/build/demo}"
bash "$top/share/build.sh" release toss
toss="$top/build/apps/toss/toss"
mkdir -p "$out"

"$toss" simulate street "$out/street.rawlog" --frames 60 --seed 1
"$toss" map "$out/street.rawlog" --out "$out/result" --live-labels
"$toss" eval "$out/street.rawlog" "$out/result" --json "$out/scores.json" --picture "$out/errors.png"

echo
echo "The clean map:    $out/result/static_map.ply"
echo "Pictures of it:   $out/result/snapshots/"
echo "To look inside:   SceneViewer3D $out/result/scene.3Dscene"
