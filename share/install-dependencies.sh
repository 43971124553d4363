#!/usr/bin/env bash
# Installs what TOSS needs to be built, tested and run on Debian 12. Needs root or sudo; does
# nothing where everything is there already. With --viewer, also what toss-viewer needs.
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache
  libmrpt-maps-dev libnanoflann-dev
  libopencv-dev libembree-dev libtbb-dev robin-map-dev
  libcli11-dev nlohmann-json3-dev zlib1g-dev libdeflate-dev liboctomap-dev
  pkg-config libpcap-dev liblzma-dev liblzf-dev
  libgtest-dev libgmock-dev libbenchmark-dev valgrind
  libgl1-mesa-dri libegl1
  mrpt-apps xvfb
)
[ "${1:-}" = --viewer ] && packages+=(libmrpt-gui-dev)

missing=()
for package in "${packages[@]}"; do
  dpkg-query --show --showformat='${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' ||
    missing+=("$package")
done
[ "${#missing[@]}" -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "install-dependencies: run this as root, or install sudo" >&2
    exit 1
  }
  as_root=(sudo)
fi
echo "installing: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"
