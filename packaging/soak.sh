#!/usr/bin/env bash
# Long runs that are no part of the tests: a long recording whose memory must stay flat, recordings that are killed
# again and again, and a driver box at 140 kHz with 18 wires whose line has a fault every few seconds: every sample is
# accounted for, memory and CPU stay flat.
# Usage: packaging/soak.sh [MINUTES] [recording|box]   (default 30, both: half for the recording and half for the kills;
# all of it for the box, which needs 0.3 GB of disk a minute)
set -euo pipefail
minutes=${1:-30}
what=${2:-all}
[[ $minutes =~ ^[0-9]+$ && $minutes -ge 2 ]] || { echo "soak.sh: $minutes: give whole minutes, two at least" >&2; exit 2; }
[[ $what =~ ^(all|recording|box)$ ]] || { echo "soak.sh: $what: give recording or box, or nothing" >&2; exit 2; }
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
packaging/install_dependencies.sh build run test
preset=${LIMBWAVE_PRESET:-ci}  # another one of CMakePresets.json, already built
build=build/$preset
mkdir -p "$build"
cmake --preset "$preset" >"$build/configure.log" 2>&1 || { cat "$build/configure.log"; exit 1; }
targets=(limbwave limbwave-driver-box-emulator)
[[ $what == box ]] || targets+=(test_record_kill test_take)
cmake --build $build --target "${targets[@]}" >"$build/build.log" 2>&1 || { tail -n 30 "$build/build.log"; exit 1; }
work=$(mktemp -d)
recorder=
emulator=
trap 'for id in $recorder $emulator; do kill "$id" 2>/dev/null || true; done; rm -rf "$work"' EXIT
export LIMBWAVE_RESOURCES="$top/resources" LIMBWAVE_HOME="$work/home"

# CPU seconds of a process so far, in hundredths; resident memory in kB.
cpu() { awk '{sub(/.*\) /, ""); print $12 + $13}' "/proc/$1/stat" 2>/dev/null || true; }
resident() { awk '/VmRSS/ {print $2}' "/proc/$1/status" 2>/dev/null || true; }

soak_box() {
  local seconds=$((minutes * 60))
  echo "soak: a driver box with a fault every 4 s, for $seconds s"
  $build/app/cli/limbwave simulate "$work/base.take" --rig driver-box-body --motion walk --errors calibrated --seconds 20 >"$work/box.log" 2>&1 \
    || { cat "$work/box.log"; exit 1; }
  $build/app/driver_box_emulator/limbwave-driver-box-emulator --take "$work/base.take" \
    --link "$work/box" --log "$work/faults.log" --faults-every 4 --seed 5 </dev/null >"$work/emulator.log" 2>&1 &
  emulator=$!
  for _ in $(seq 100); do [[ -e $work/box ]] && break; sleep 0.1; done
  $build/app/cli/limbwave record "$work/box.take" --driver-box "$work/box" --seconds $seconds --json >"$work/record.json" 2>"$work/record.log" &
  recorder=$!
  local begin=$SECONDS minute=1 before before_box memory
  local -a loads=() memories=()
  before=$(cpu $recorder)
  while kill -0 $recorder 2>/dev/null; do
    sleep 1
    (( SECONDS - begin >= minute * 60 )) || continue
    memory=$(resident $recorder)
    [[ -z $memory ]] && break
    loads+=($(( $(cpu $recorder) - before )))
    memories+=("$memory")
    before=$(cpu $recorder)
    minute=$((minute + 1))
  done
  local status=0
  wait $recorder || status=$?
  recorder=
  kill "$emulator" 2>/dev/null || true
  emulator=
  (( status == 0 )) || { cat "$work/record.log"; echo "soak: the recording ended with exit status $status" >&2; exit 1; }
  cat "$work/record.json"
  echo "soak: CPU hundredths of a second by minute: ${loads[*]}"
  echo "soak: memory in kB by minute: ${memories[*]}"
  packaging/account_driver_box.py "$work/box.take" "$work/base.take" "$work/faults.log" || { echo "soak: samples are not accounted for" >&2; exit 1; }
  local count=${#memories[@]}
  (( count < 2 || memories[count - 1] <= memories[0] + 16384 )) || { echo "soak: memory grew" >&2; exit 1; }
  local third=$((count / 3)) early=0 late=0
  for ((i = 0; i < third; ++i)); do
    early=$((early + loads[i]))
    late=$((late + loads[count - 1 - i]))
  done
  # Other programs and their caches make CPU time vary by a quarter.
  (( late * 4 <= early * 5 + 4 )) || { echo "soak: CPU time grew from $early to $late" >&2; exit 1; }
  rm -rf "$work/box.take"
}

if [[ $what != recording ]]; then
  soak_box
  [[ $what == box ]] && { echo "soak: passed"; exit 0; }
fi

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
