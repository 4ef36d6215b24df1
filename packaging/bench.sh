#!/usr/bin/env bash
# Builds and runs all benchmarks and the accuracy table. Usage: packaging/bench.sh [NAME...]
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
packaging/install_dependencies.sh build run test
export LIMBWAVE_RESOURCES="$top/resources" LIMBWAVE_DATA=${LIMBWAVE_DATA:-$(realpath -m ../shared/data)}
cmake --preset ci >/dev/null
cmake --build build/ci >build/ci/build.log 2>&1 || { tail -n 30 build/ci/build.log; exit 1; }
for program in build/ci/tests/bench/*; do
  [[ -f $program && -x $program ]] || continue
  name=$(basename "$program")
  [[ $# -gt 0 && " $* " != *" $name "* ]] && continue
  echo "== $name"
  "$program"
done
