#!/usr/bin/env bash
# Fuzzes the readers of BVH, FBX and glTF, the driver box's protocol and its words under AddressSanitizer and UndefinedBehaviorSanitizer. What it finds lies in
# build/fuzz/findings; new inputs that reach new code are kept in build/fuzz/corpus for the next run.
# Usage: packaging/fuzz.sh [MINUTES] [bvh|fbx|gltf|driver_box|words...]   (default 10 minutes each, all)
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
minutes=${1:-10}
shift || true
targets=("$@")
[[ ${#targets[@]} -eq 0 ]] && targets=(bvh fbx gltf driver_box words)
packaging/install_dependencies.sh build run test fuzz
mkdir -p build/fuzz/findings
cmake --preset fuzz >build/fuzz/configure.log 2>&1 || { cat build/fuzz/configure.log; exit 1; }
cmake --build build/fuzz --target fuzz_corpus "${targets[@]/#/fuzz_}" >build/fuzz/build.log 2>&1 || { tail -n 30 build/fuzz/build.log; exit 1; }
build/fuzz/tests/fuzz/fuzz_corpus build/fuzz/corpus
data=${LIMBWAVE_DATA:-$(realpath -m ../shared/data)}
failed=0
for target in "${targets[@]}"; do
  # Small files of other programs too; large ones only make every try slow.
  names=(-name "*.$target")
  [[ $target == gltf ]] && names+=(-o -name '*.glb')
  find "$data/files" tests/fuzz/corpus -size -200k \( "${names[@]}" \) -exec cp -t "build/fuzz/corpus/$target" {} + 2>/dev/null || true
  dictionary=()
  [[ -f tests/fuzz/$target.dict ]] && dictionary=("-dict=tests/fuzz/$target.dict")
  echo "== $target for $minutes minutes"
  # A byte of words is eighty samples to decode: short inputs reach more in the same time.
  longest=262144
  [[ $target == words ]] && longest=2048
  # Memory: everything that a reader may take for a file of at most this size.
  build/fuzz/tests/fuzz/fuzz_"$target" "build/fuzz/corpus/$target" "${dictionary[@]}" \
    -max_total_time=$((minutes * 60)) -max_len=$longest \
    -rss_limit_mb=2048 -timeout=20 -print_final_stats=1 -artifact_prefix="build/fuzz/findings/$target-" \
    >"build/fuzz/$target.log" 2>&1 || { tail -n 40 "build/fuzz/$target.log"; failed=1; continue; }
  grep -E 'number_of_executed_units|average_exec|new_units_added|peak_rss' "build/fuzz/$target.log"
done
(( failed == 0 )) && echo "fuzz: no findings" || { echo "fuzz: see build/fuzz/findings" >&2; exit 1; }
