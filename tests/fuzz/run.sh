#!/bin/sh
# Fuzzes with libFuzzer, address and undefined-behaviour sanitizers, for as long as one likes.
# Usage: sh tests/fuzz/run.sh [HARNESS|all] [SECONDS]    (default: all, 600 s each)
# What is found lies in build/fuzz/findings/HARNESS; new inputs that reach new code in build/fuzz/corpus/HARNESS.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
cd "$root"
harnesses='config overrides csv measured curve manifest summary checkpoint'
wanted=${1-all} seconds=${2-600}
[ "$wanted" = all ] || harnesses=$wanted

fail() {
  printf 'run.sh: %s\n' "$*" >&2
  exit 1
}

need_clang() {
  command -v clang++ >/dev/null 2>&1 && ls /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-* >/dev/null 2>&1 && return
  # shellcheck disable=SC2016  # the backquotes are for the reader
  fail 'libFuzzer is not installed (some 400 MB). As root, run:

  apt-get update && apt-get install -y --no-install-recommends clang libclang-rt-14-dev

then sh tests/fuzz/run.sh again. Without it, `ctest --preset asan -L fuzz` does the short runs under the same sanitizers.'
}

build() {
  [ -f build/fuzz/build.ninja ] || cmake --preset fuzz >&2
  # shellcheck disable=SC2046  # a list of words
  cmake --build --preset fuzz --target $(for h in $harnesses; do printf 'fuzz_%s ' "$h"; done) >&2
}

tell() {
  printf '\n%s: FOUND something:\n' "$1"
  ls "build/fuzz/findings/$1"
  cat <<END
To look at one:   build/fuzz/tests/fuzz/fuzz_$1 build/fuzz/findings/$1/FILE
To make it small: build/fuzz/tests/fuzz/fuzz_$1 -minimize_crash=1 -max_total_time=60 build/fuzz/findings/$1/FILE
To make it a test: copy the small one to tests/fuzz/corpus/$1/ with a name that says what it is (every test run replays that folder),
mend the core, and write down what must not be accepted as a case of tests/unit.
END
}

# Runs one harness; fails where it found something.
fuzz() {
  new="build/fuzz/corpus/$1" found="build/fuzz/findings/$1"
  mkdir -p "$new" "$found"
  printf '== %s for %s s\n' "$1" "$seconds" >&2
  if "build/fuzz/tests/fuzz/fuzz_$1" -max_total_time="$seconds" -max_len=20000 -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1024 \
    -print_final_stats=1 -artifact_prefix="$found/" "$new" "tests/fuzz/corpus/$1" >"build/fuzz/$1.log" 2>&1; then
    grep -E 'number_of_executed_units|^Done|cov:' "build/fuzz/$1.log" | tail -n 3
  else
    grep -E 'ERROR|runtime error|does not hold|SUMMARY' "build/fuzz/$1.log" | head -n 5
    tell "$1"
    return 1
  fi
}

need_clang
build
status=0
for harness in $harnesses; do
  fuzz "$harness" || status=1
done
exit $status
