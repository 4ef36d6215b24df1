#!/usr/bin/env bash
# Runs a reader with its arguments, or says that it is not installed (exit 77: skipped).
set -euo pipefail
if [[ -z $1 || $1 == *-NOTFOUND || ! -x $1 ]]; then
  echo "skipped: the reader is not installed (Debian packages of section interop in packaging/dependencies.txt)"
  exit 77
fi
exec "$@"
