#!/usr/bin/env bash
# Installs the packages of the named sections of dependencies.txt that are missing; says what it does.
# Usage: install_dependencies.sh build run ...
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
command -v dpkg-query >/dev/null || { echo "packaging: this is not a Debian-like system; install what $here/dependencies.txt lists by hand" >&2; exit 0; }
missing=()
for section in "$@"; do
  while read -r package; do
    # A program that came another way than by its package (a newer npm, say) counts as installed.
    case "$package" in nodejs) program=node ;; *) program=$package ;; esac
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' && continue
    [[ $section == interop ]] && command -v "$program" >/dev/null && continue
    missing+=("$package")
  done < <(awk -v wanted="[$section]" '/^\[/ {inside = ($0 == wanted); next} inside && NF && $1 !~ /^#/ {print $1}' "$here/dependencies.txt")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0
as_root=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo >/dev/null || { echo "packaging: missing ${missing[*]}; install them as root: apt-get install ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "packaging: installing ${#missing[@]} packages${as_root:+ with sudo} (minutes on a new machine): ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q >/dev/null
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >/dev/null
