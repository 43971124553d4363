#!/usr/bin/env bash
# Installs what is missing and builds a preset: share/build.sh [PRESET [TARGET...]]
set -euo pipefail

cd "$(dirname "$0")/.."
preset="${1:-release}"
shift || true
bash share/install-dependencies.sh
cmake --preset "$preset" >/dev/null
if [ "$#" -gt 0 ]; then
  cmake --build --preset "$preset" --target "$@"
else
  cmake --build --preset "$preset"
fi
