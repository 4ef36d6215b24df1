#!/usr/bin/env bash
# Long runs that are no part of the tests: a long recording whose memory must stay flat, then recordings that are killed
# again and again. Usage: packaging/soak.sh [MINUTES]   (default 30: half for the recording, half for the kills)
set -euo pipefail
minutes=${1:-30}
[[ $minutes =~ ^[0-9]+$ && $minutes -ge 2 ]] || { echo "soak.sh: $minutes: give whole minutes, two at least" >&2; exit 2; }
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
packaging/install_dependencies.sh build run test
preset=${LIMBWAVE_PRESET:-ci}  # another one of CMakePresets.json, already built
build=build/$preset
mkdir -p "$build"
cmake --preset "$preset" >"$build/configure.log" 2>&1 || { cat "$build/configure.log"; exit 1; }
cmake --build $build --target limbwave test_record_kill test_take >"$build/build.log" 2>&1 || { tail -n 30 "$build/build.log"; exit 1; }
work=$(mktemp -d)
recorder=
trap '[[ -z $recorder ]] || kill "$recorder" 2>/dev/null; rm -rf "$work"' EXIT
export LIMBWAVE_RESOURCES="$top/resources" LIMBWAVE_HOME="$work/home"

seconds=$((minutes * 30))
echo "soak: recording $seconds s from the simulator"
$build/app/cli/limbwave record "$work/long.take" --device simulator:walk --seconds $seconds >"$work/record.log" 2>&1 &
recorder=$!
first=0
last=0
begin=$SECONDS
while kill -0 $recorder 2>/dev/null; do
  sleep 2
  resident=$(awk '/VmRSS/ {print $2}' /proc/$recorder/status 2>/dev/null || true)
  [[ -z $resident ]] && break
  # What the session keeps is full after twenty seconds: ten of frames, kept in batches.
  (( SECONDS - begin >= 25 && first == 0 )) && first=$resident
  last=$resident
done
status=0
wait $recorder || status=$?
recorder=
cat "$work/record.log"
(( status == 0 )) || { echo "soak: the recording ended with exit status $status" >&2; exit 1; }
$build/app/cli/limbwave verify "$work/long.take"
$build/app/cli/limbwave info "$work/long.take" --json | python3 -c "
import json, sys
info = json.load(sys.stdin)
lost = [e for e in info['events'] if e['kind'] in ('dropped', 'line-in.sync-lost')]
print('soak: %.1f s recorded, %d losses' % (info['seconds'], len(lost)))
sys.exit(bool(lost) or info['seconds'] < $seconds)" || { echo "soak: the recording is not whole" >&2; exit 1; }
echo "soak: memory $first kB after 25 s, $last kB at the end"
(( first > 0 && last <= first + 4096 )) || { echo "soak: memory grew" >&2; exit 1; }

echo "soak: killed recordings for $seconds s"
begin=$SECONDS
rounds=0
while (( SECONDS - begin < seconds )); do
  $build/tests/take/test_take --gtest_filter='Killed*' --gtest_brief=1 >"$work/kill.log" 2>&1 || { cat "$work/kill.log"; exit 1; }
  $build/tests/integration/test_record_kill --gtest_brief=1 >"$work/kill.log" 2>&1 || { cat "$work/kill.log"; exit 1; }
  rounds=$((rounds + 1))
done
echo "soak: passed; $rounds rounds of killed recordings"
