#!/usr/bin/env bash
# Runs the commands that the README and the pages in share/doc show, on small logs that stand for the
# reader's: documented_commands.sh SOURCE_FOLDER FOLDERS_OF_PROGRAMS WORK_FOLDER. Ends with an error
# at the first command that fails. Left out: windows, and what other programs than ours do.
set -euo pipefail

source_folder=$1
export PATH=$2:$PATH
work=$3
data=${TOSS_TEST_DATA:-}

rm -rf "$work"
mkdir -p "$work/fixtures/sequences" "$work/fixtures/data/00"
cd "$work/fixtures"
toss -q simulate crossing drive.rawlog --frames 20
toss -q simulate crossing sequences/07 --format kitti --frames 20
printf '%s\n' '# .PCD v0.7' 'VERSION 0.7' 'FIELDS x y z intensity' 'SIZE 4 4 4 4' 'TYPE F F F F' \
  'COUNT 1 1 1 1' 'WIDTH 3' 'HEIGHT 1' 'VIEWPOINT 0 0 2 1 0 0 0' 'POINTS 3' 'DATA ascii' \
  '5 0 0 0' '0 5 0 0' '5 5 1 1' >data/00/000000.pcd
sed 's/VIEWPOINT 0/VIEWPOINT 1/' data/00/000000.pcd >data/00/000001.pcd
if [ -n "$data" ]; then
  ln -s "$data/velodyne/sample_velodyne_vlp16_gps.pcap" v.pcap
  ln -s "$data/ouster/OS-1-128_v2.3.0_1024x10_lb_n3.pcap" o.pcap
  ln -s "$data/ouster/OS-1-128_v2.3.0_1024x10.json" o.json
  ln -s "$data/ouster/OS-1-128_v2.3.0_1024x10_lb_n3_poses_kitti.txt" poses
fi

# The commands of a page, one per line, without their comments.
commands_of() {
  awk '/^```bash/ { inside = 1; next } /^```/ { inside = 0 } inside' "$1" |
    sed -e ':join' -e '/\\$/ { N; s/\\\n//; b join }' -e 's/ #.*//' |
    grep -E '^toss(-viewer)? ' | grep -Ev '^toss-viewer [^-]*$|--camera'
}

# run_page NAME FIXTURE...: in a folder with these fixtures, each FIXTURE or FIXTURE=NAME_THERE.
run_page() {
  local page=$1 fixture
  shift
  mkdir -p "$work/$page"
  cd "$work/$page"
  for fixture in "$@"; do
    ln -s "$work/fixtures/${fixture%%=*}" "${fixture##*=}"
  done
  commands_of "$source_folder/$page" >commands
  [ -s commands ] || { echo "$page shows no command"; exit 1; }
  while read -r command; do
    echo "$page: $command"
    bash -c "$command" </dev/null >output 2>&1 || { cat output; exit 1; }
  done <commands
}

run_page share/doc/from-kitti.md sequences
run_page share/doc/from-pcd.md data
run_page share/doc/poses.md drive.rawlog
run_page share/doc/several-lidars.md
run_page share/doc/tuning.md drive.rawlog
if command -v toss-viewer >/dev/null; then
  run_page share/doc/viewer.md drive.rawlog
fi
if [ -z "$data" ]; then
  echo "SKIPPED: README.md, from-velodyne.md and from-ouster.md need TOSS_TEST_DATA"
  exit 0
fi
run_page share/doc/from-velodyne.md v.pcap=drive.pcap
run_page share/doc/from-ouster.md o.pcap=drive.pcap o.json=drive.json poses=drive.tum
run_page README.md drive.rawlog sequences data v.pcap o.pcap o.json
