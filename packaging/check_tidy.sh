#!/usr/bin/env bash
# Runs clang-tidy over our sources, one process a core. A file whose preprocessed text and configuration passed before
# is not checked again. Usage: check_tidy.sh BUILD_FOLDER (built before, for generated headers)
set -euo pipefail
cd "$(dirname "$0")/.."
database=$(realpath "$1")/tidy
python3 packaging/tidy_commands.py "$1" "$database"
export database
export cache=${XDG_CACHE_HOME:-$HOME/.cache}/limbwave-tidy
mkdir -p "$cache"
configuration=$( { cat .clang-tidy; clang-tidy --version; } | sha256sum | cut -c1-16)
tests_configuration=$( { cat tests/.clang-tidy; clang-tidy --version; } | sha256sum | cut -c1-16)
export configuration tests_configuration
check() {
  local file=$1 command key log
  command=$(python3 packaging/tidy_commands.py --preprocess "$database" "$PWD/$file") || return 0
  key=$(eval "$command" 2>/dev/null | sed "s|$PWD||g" | sha256sum | cut -c1-32)-$configuration
  [[ $file == tests/* ]] && key=${key%-*}-$tests_configuration
  [[ -e $cache/$key ]] && return 0
  log=$(mktemp)
  if clang-tidy -p "$database" --quiet "$file" >"$log" 2>&1; then
    touch "$cache/$key"
    rm -f "$log"
  else
    grep -vE 'warnings generated|^Suppressed|^Use -header-filter' "$log" | head -n 60
    rm -f "$log"
    return 1
  fi
}
export -f check
git ls-files 'core/*.cpp' 'app/*.cpp' 'ui/*.cpp' | xargs -P "$(nproc)" -I{} bash -c 'check {}'
