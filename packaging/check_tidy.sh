#!/usr/bin/env bash
# Runs clang-tidy over our sources, one process a core. A file whose preprocessed text and configuration passed before
# is not checked again. Usage: check_tidy.sh BUILD_FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath "$1")
export build
export cache=${XDG_CACHE_HOME:-$HOME/.cache}/limbwave-tidy
mkdir -p "$cache"
# clang cannot read GCC's precompiled headers; without them the files compile just the same.
database=$(mktemp -d)
export database
trap 'rm -rf "$database"' EXIT
sed -E 's/-Winvalid-pch//g; s/-include [^ ]*cmake_pch\.hxx//g' "$build/compile_commands.json" >"$database/compile_commands.json"
configuration=$( { cat .clang-tidy; clang-tidy --version; } | sha256sum | cut -c1-16)
export configuration
check() {
  local file=$1 command key
  command=$(python3 packaging/preprocess_command.py "$build/compile_commands.json" "$PWD/$file") || return 0
  key=$(eval "$command" 2>/dev/null | sed "s|$PWD||g" | sha256sum | cut -c1-32)-$configuration
  [[ -e $cache/$key ]] && return 0
  if clang-tidy -p "$database" --quiet "$file" >"$cache/$$.log" 2>&1; then
    touch "$cache/$key"
    rm -f "$cache/$$.log"
  else
    grep -vE 'warnings generated|^Suppressed|^Use -header-filter' "$cache/$$.log" | head -n 60
    rm -f "$cache/$$.log"
    return 1
  fi
}
export -f check
git ls-files 'core/*.cpp' 'app/*.cpp' 'ui/*.cpp' | xargs -P "$(nproc)" -I{} bash -c 'check {}'
