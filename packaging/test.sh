#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests. --all adds format and static checks, the slow tests
# and those with other programs (Blender, npm readers). Usage: packaging/test.sh [--all]
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
all=false
[[ ${1:-} == --all ]] && all=true
sections=(build run test)
$all && sections+=(interop)
packaging/install_dependencies.sh "${sections[@]}"
export LIMBWAVE_DATA=${LIMBWAVE_DATA:-$(realpath -m ../shared/data)}
[[ -d $LIMBWAVE_DATA ]] || echo "test.sh: no recordings in $LIMBWAVE_DATA (set LIMBWAVE_DATA); tests that need them say so and skip"

step() { echo "== $* ($(date +%H:%M:%S))"; }
if $all; then
  step "format"
  packaging/check_format.sh
fi
step "build"
mkdir -p build/ci
cmake --preset ci >build/ci/configure.log 2>&1 || { cat build/ci/configure.log; exit 1; }
cmake --build build/ci >build/ci/build.log 2>&1 || { grep -E 'error|FAILED|warning' -A5 build/ci/build.log | head -n 60; tail -n 20 build/ci/build.log; exit 1; }
if $all; then
  step "clang-tidy"
  packaging/check_tidy.sh build/ci || { echo "test.sh: clang-tidy has findings, see above"; exit 1; }
  step "npm readers"
  (cd tests/interop && npm ci --silent --no-audit --no-fund)
fi
step "tests"
if $all; then
  ctest --preset ci -j 2
else
  ctest --preset ci -j 2 -LE 'slow|interop'
fi
if $all; then
  step "demo without a display"
  env -u DISPLAY -u WAYLAND_DISPLAY LIMBWAVE_PRESET=ci LIMBWAVE_DEMO_FOLDER="$top/build/demo-test" packaging/run.sh
fi
