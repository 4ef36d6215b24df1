#!/usr/bin/env bash
# Long runs that are no part of the tests: a long recording whose memory must stay flat, and many killed recordings.
# Usage: packaging/soak.sh [MINUTES]   (default 30; the kills take about as long again)
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
minutes=${1:-30}
cd "$top"
packaging/install_dependencies.sh build run test
cmake --preset ci >/dev/null
cmake --build build/ci --target limbwave test_record_kill test_take >build/ci/build.log 2>&1 || { tail -n 30 build/ci/build.log; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LIMBWAVE_RESOURCES="$top/resources" LIMBWAVE_HOME="$work/home"

echo "recording $minutes minutes from the simulator"
build/ci/app/cli/limbwave record "$work/long.take" --device simulator:walk --seconds $((minutes * 60)) &
recorder=$!
first=0
last=0
while kill -0 $recorder 2>/dev/null; do
  sleep 10
  resident=$(awk '/VmRSS/ {print $2}' /proc/$recorder/status 2>/dev/null || true)
  [[ -z $resident ]] && break
  [[ $first -eq 0 ]] && first=$resident
  last=$resident
done
wait $recorder
build/ci/app/cli/limbwave verify "$work/long.take"
echo "memory: $first kB after ten seconds, $last kB at the end"
(( last <= first + first / 4 + 8192 )) || { echo "soak: memory grew" >&2; exit 1; }

echo "killed recordings"
build/ci/tests/take/test_take --gtest_filter='Killed*' --gtest_repeat=$minutes --gtest_brief=1
build/ci/tests/integration/test_record_kill --gtest_repeat=$((1 + minutes / 2)) --gtest_brief=1
echo "soak: passed"
