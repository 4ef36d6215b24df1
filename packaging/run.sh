#!/usr/bin/env bash
# Installs what is missing, builds, and opens the studio on a demo take. Without a display it runs the same demo through
# the command line and says where it left the files and pictures. Usage: packaging/run.sh [TAKE]
# LIMBWAVE_PRESET names another preset of CMakePresets.json than "release".
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
packaging/install_dependencies.sh build run

build=build/${LIMBWAVE_PRESET:-release}
[[ -f $build/build.ninja ]] || cmake --preset "${LIMBWAVE_PRESET:-release}" >"$top/.configure.log" 2>&1 || { cat "$top/.configure.log"; exit 1; }
rm -f "$top/.configure.log"
echo "run.sh: building (minutes at the first start, seconds later)"
cmake --build $build >"$build/build.log" 2>&1 || { tail -n 40 "$build/build.log"; echo "run.sh: the build failed; the whole log is $build/build.log" >&2; exit 1; }

limbwave="$top/$build/app/cli/limbwave"
studio="$top/$build/app/studio/limbwave-studio"
export LIMBWAVE_RESOURCES="$top/resources"

if [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]]; then
  [[ $# -gt 0 ]] && exec "$studio" "$@"
  exec "$studio" --demo
fi

demo=${LIMBWAVE_DEMO_FOLDER:-$top/build/demo}
rm -rf "$demo"
mkdir -p "$demo"
# A calibration library of its own: the demo leaves the user's alone.
export LIMBWAVE_HOME="$demo/library"
"$limbwave" simulate "$demo/reach.take" --motion reach --errors paper --seed 7
"$limbwave" solve "$demo/reach.take"
"$limbwave" evaluate "$demo/reach.take"
"$limbwave" export "$demo/reach.take" -o "$demo/reach.bvh"
if [[ -z ${XDG_RUNTIME_DIR:-} ]]; then  # as after a plain `su` or in a container; Qt would complain
  XDG_RUNTIME_DIR=$(mktemp -d)
  trap 'rm -rf "$XDG_RUNTIME_DIR"' EXIT
  export XDG_RUNTIME_DIR
fi
QT_QPA_PLATFORM=offscreen "$studio" --pictures "$demo" "$demo/reach.take"
echo "No display, so the demo ran through the command line. It left:"
echo "  take      $demo/reach.take"
echo "  clip      $demo/reach.take/solves/default/clip.glb"
echo "  BVH       $demo/reach.bvh"
echo "  skeleton  $demo/skeleton.png"
echo "  signals   $demo/signals.png"
