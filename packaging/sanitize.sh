#!/usr/bin/env bash
# Builds tests with sanitizers and runs them; a finding fails the run. Usage: packaging/sanitize.sh asan|tsan [FILTER]
#
#   asan   AddressSanitizer with its leak check, and UndefinedBehaviorSanitizer: all tests of core but those that work
#          in real time, and the studio's models and geometry (they need no window; what Qt, fontconfig and Mesa leave
#          allocated is in tests/support/lsan_suppressions.txt)
#   tsan   ThreadSanitizer: whatever has threads: the ring, sound cards, the live session with its recordings and the
#          simulator, the take's recorder, the studio's job runner (the sound libraries and Qt are not instrumented:
#          what comes from inside them is in tests/support/tsan_suppressions.txt)
#
# FILTER: an extended regular expression for the names of the test programs below. Tests that need recordings find them
# in LIMBWAVE_DATA and skip without.
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
kind=${1:-}
filter=${2:-.}
export LIMBWAVE_DATA=${LIMBWAVE_DATA:-$(realpath -m ../shared/data)} LIMBWAVE_RESOURCES="$top/resources"
case $kind in
  asan)
    programs=(base/test_base geometry/test_geometry signal/signal_test acquire/test_acquire decode/decode_test
      body/test_body calibrate/test_calibrate estimate/test_estimate estimate/test_chain motion/motion_test
      interchange/interchange_test interchange/fbx_test interchange/export_test take/test_take simulate/simulate_test
      evaluate/evaluate_test solve/test_solve solve/test_live solve/test_live_recording solve/test_library_choice
      integration/test_live_equals_offline integration/test_wav_to_bvh integration/test_line_in_accuracy
      ui/common/ui_models_test ui/common/ui_job_runner_test ui/timeline/timeline_geometry_test)
    export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:check_initialization_order=1
    export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
    export LSAN_OPTIONS="suppressions=$top/tests/support/lsan_suppressions.txt:print_suppressions=0"
    ;;
  tsan)
    programs=(base/test_base acquire/test_sound_card take/test_take solve/test_live solve/test_live_recording
      ui/common/ui_job_runner_test)
    export TSAN_OPTIONS="suppressions=$top/tests/support/tsan_suppressions.txt:halt_on_error=0:second_deadlock_stack=1"
    ;;
  *)
    sed -n '2,13s/^# \{0,1\}//p' "$0"
    exit 2
    ;;
esac
chosen=()
for program in "${programs[@]}"; do
  [[ $program =~ $filter ]] && chosen+=("$program")
done
[[ ${#chosen[@]} -gt 0 ]] || { echo "sanitize.sh: no test program matches $filter" >&2; exit 2; }
packaging/install_dependencies.sh build run test
build=build/$kind
mkdir -p "$build"
cmake --preset "$kind" >"$build/configure.log" 2>&1 || { cat "$build/configure.log"; exit 1; }
echo "sanitize.sh: building ${#chosen[@]} test programs (log: $build/build.log)"
cmake --build "$build" --target "${chosen[@]##*/}" >"$build/build.log" 2>&1 || { tail -n 40 "$build/build.log"; exit 1; }
# ThreadSanitizer of GCC 12 does not know where kernels of today put programs in memory.
run=()
[[ $kind == tsan ]] && run=(setarch -R)
failed=()
for program in "${chosen[@]}"; do
  log="$build/${program##*/}.log"
  options=(--gtest_brief=1)
  [[ $program == *job_runner* ]] && options=(-silent)
  if QT_QPA_PLATFORM=offscreen "${run[@]}" "$build/tests/$program" "${options[@]}" >"$log" 2>&1; then
    echo "clean   $program  $(grep -aoE '\[  PASSED  \] [0-9]+ tests?|Totals: .*' "$log" | tail -n 1)"
  else
    echo "FAILED  $program  (log: $log)"
    grep -aE 'ERROR:|WARNING: ThreadSanitizer|runtime error|FAILED|FAIL!|SUMMARY' "$log" | head -n 12 || true
    failed+=("$program")
  fi
done
[[ ${#failed[@]} -eq 0 ]] || exit 1
