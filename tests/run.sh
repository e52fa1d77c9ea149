#!/bin/sh
# The whole default test suite: the set-up of app/start.sh, then every CTest test that is not labelled "long".
# Usage: sh tests/run.sh [arguments for ctest]
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cd "$root"
sh app/start.sh --setup-only
exec ctest --preset release --label-exclude '^long$' --parallel 2 "$@"
