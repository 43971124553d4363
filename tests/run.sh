#!/usr/bin/env bash
# Installs what is missing, builds everything, and runs all tests. Real data is taken from
# TOSS_TEST_DATA (default: ../shared/data beside the checkout); its tests are skipped where it is
# absent.
set -euo pipefail

cd "$(dirname "$0")/.."
bash share/build.sh release
export TOSS_TEST_DATA="${TOSS_TEST_DATA:-$PWD/../shared/data}"
ctest --preset release --parallel "$(nproc)" "$@"
