#!/usr/bin/env bash
# Installs what is missing, builds, and opens the studio on a demo take. Without a display it runs the same demo through
# the command line and says where it left the files and pictures; their folder is build/demo, or LIMBWAVE_DEMO_FOLDER.
# Usage: packaging/run.sh [TAKE | RECORDING...]    a take to open, or recordings to import, instead of the demo
# LIMBWAVE_PRESET names another preset of CMakePresets.json than "release".
set -euo pipefail
case ${1:-} in
  -h | --help)
    sed -n '2,5s/^# //p' "$0"
    exit 0
    ;;
esac
# Before this script goes to its own folder: paths are those of the caller.
inputs=()
for input in "$@"; do
  [[ -e $input ]] || { echo "run.sh: $input: there is no such take or recording" >&2; exit 2; }
  inputs+=("$(realpath "$input")")
done
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
packaging/install_dependencies.sh build run

preset=${LIMBWAVE_PRESET:-release}
build=build/$preset
mkdir -p "$build"
[[ -f $build/build.ninja ]] || cmake --preset "$preset" >"$build/configure.log" 2>&1 || { cat "$build/configure.log"; exit 1; }
echo "run.sh: building (minutes at the first start, seconds later)"
cmake --build $build >"$build/build.log" 2>&1 || { tail -n 40 "$build/build.log"; echo "run.sh: the build failed; the whole log is $build/build.log" >&2; exit 1; }

limbwave="$top/$build/app/cli/limbwave"
studio="$top/$build/app/studio/limbwave-studio"
export LIMBWAVE_RESOURCES="$top/resources"

# A display that is named may be gone (an old ssh connection, cron): the program itself finds out.
has_display() {
  [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]] || return 1
  { (ulimit -c 0; timeout 60 "$studio" --version) >/dev/null 2>&1; } 2>/dev/null && return 0
  echo "run.sh: the display ${DISPLAY:-$WAYLAND_DISPLAY} does not answer"
  return 1
}
if has_display; then
  [[ ${#inputs[@]} -gt 0 ]] && exec "$studio" "${inputs[@]}"
  exec "$studio" --demo
fi

demo=${LIMBWAVE_DEMO_FOLDER:-$top/build/demo}
# Only what an earlier run has made is replaced.
if [[ -e $demo && ! -e $demo/.limbwave-demo ]] && [[ ! -d $demo || -n $(ls -A "$demo") ]]; then
  echo "run.sh: $demo was not made by this script; name a new folder with LIMBWAVE_DEMO_FOLDER" >&2
  exit 1
fi
rm -rf "$demo"
mkdir -p "$demo"
touch "$demo/.limbwave-demo"
if [[ -z ${XDG_RUNTIME_DIR:-} ]]; then  # as after a plain `su` or in a container; Qt would complain
  XDG_RUNTIME_DIR=$(mktemp -d)
  trap 'rm -rf "$XDG_RUNTIME_DIR"' EXIT
  export XDG_RUNTIME_DIR
fi
name=reach
take="$demo/reach.take"
if [[ ${#inputs[@]} -eq 0 ]]; then
  # A calibration library of its own: the demo leaves the user's alone.
  export LIMBWAVE_HOME="$demo/library"
  "$limbwave" simulate "$take" --motion reach --errors paper --seed 7
elif [[ -d ${inputs[0]} ]]; then
  take=${inputs[0]}
  name=$(basename "${take%.take}")
else
  name=$(basename "${inputs[0]%.*}")
  take="$demo/$name.take"
  "$limbwave" import "$take" "${inputs[@]}"
fi
"$limbwave" solve "$take"
[[ -e $take/truth.json ]] && "$limbwave" evaluate "$take"
"$limbwave" export "$take" -o "$demo/$name.bvh"
QT_QPA_PLATFORM=offscreen "$studio" --pictures "$demo" "$take"
echo "No display, so this ran through the command line. It left:"
echo "  take      $take"
echo "  clip      $take/solves/default/clip.glb"
echo "  BVH       $demo/$name.bvh"
echo "  skeleton  $demo/skeleton.png"
echo "  signals   $demo/signals.png"
