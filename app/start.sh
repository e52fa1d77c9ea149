#!/bin/sh
# Asperity from nothing: installs the Debian 12 packages that are missing, builds, and runs the quickstart.
# What is done already is skipped. Usage: sh app/start.sh [--setup-only]
# --setup-only builds everything, tests included, and runs nothing; it is the first half of tests/run.sh.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cd "$root"
preset=release
build="build/$preset"
config=configs/quickstart.json

say() { printf '== %s\n' "$*" >&2; }
fail() {
  printf 'start.sh: %s\n' "$*" >&2
  exit 1
}

setup_only=no target=asperity
case "$#:${1-}" in
  0:) ;;
  1:--setup-only) setup_only=yes target=all ;;
  *) printf 'usage: sh app/start.sh [--setup-only]\n' >&2; exit 2 ;;
esac

wanted_packages() { sed 's/#.*//' app/packages.txt | tr -s ' \t\n' ' '; }

is_installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

missing_packages() {
  for package in $(wanted_packages); do
    is_installed "$package" || printf ' %s' "$package"
  done
}

# Runs a command as root: directly, or by sudo, which may ask for a password.
as_root() {
  if [ "$(id -u)" = 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  else
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

install_by_hand() {
  printf 'start.sh: %s. As root, run:\n\n  apt-get update && apt-get install -y --no-install-recommends%s\n\nthen sh app/start.sh again.\n' \
    "$1" "$missing" >&2
  exit 1
}

install_packages() {
  for tool in dpkg-query apt-get; do
    command -v "$tool" >/dev/null 2>&1 ||
      fail "no $tool: this is no Debian system; install what app/packages.txt lists, then build as README.md says"
  done
  missing=$(missing_packages)
  if [ -z "$missing" ]; then
    say "all packages are installed"
    return
  fi
  [ "$(id -u)" = 0 ] || command -v sudo >/dev/null 2>&1 || install_by_hand "packages are missing, and there is neither root nor sudo"
  say "installing:$missing"
  as_root apt-get update || install_by_hand "apt-get update failed"
  # shellcheck disable=SC2086  # a list of words
  as_root apt-get install -y --no-install-recommends $missing || install_by_hand "apt-get install failed"
}

# One compiler for each core, but no more than memory holds: one of our largest files (VTK, CGAL) takes about 1.5 GB.
build_jobs() {
  cores=$(nproc)
  memory_kb=$(sed -n 's/^MemAvailable: *\([0-9]*\).*/\1/p' /proc/meminfo)
  jobs=$((${memory_kb:-1500000} / 1500000))
  [ "$jobs" -le "$cores" ] || jobs=$cores
  [ "$jobs" -ge 1 ] || jobs=1
  printf '%s' "$jobs"
}

build_asperity() {
  if [ ! -f "$build/build.ninja" ]; then
    say "configuring $build"
    cmake --preset "$preset" >&2
  fi
  jobs=$(build_jobs)
  say "building $target in $build with $jobs job(s)"
  cmake --build --preset "$preset" -j "$jobs" --target "$target" >&2
}

number_in_summary() { sed -n "s/.*\"$1\": *\\([-+0-9.eE]*\\).*/\\1/p" "$2" | head -n 1; }

last_picture() { find "$1/frames" -name "$2_*.png" 2>/dev/null | sort | tail -n 1; }

run_quickstart() {
  asperity=$(find "$build" -maxdepth 2 -type f -name asperity -perm -u+x | head -n 1)
  [ -n "$asperity" ] || fail "no executable asperity below $build"
  say "running $config"
  printed=$("$asperity" run "$config")
  run=$(printf '%s\n' "$printed" | tail -n 1)
  strength=$(number_in_summary tensile_strength_mpa "$run/summary.json")
  picture=$(last_picture "$run" cracks)
  [ -n "$strength" ] || fail "no tensile_strength_mpa in $run/summary.json"
  [ -n "$picture" ] || fail "no picture of the cracks in $run/frames"
  case "$run" in /*) ;; *) run="$root/$run" picture="$root/$picture" ;; esac
  printf 'run folder        %s\ntensile strength  %s MPa\npicture to open   %s\n' "$run" "$strength" "$picture"
}

install_packages
build_asperity
[ "$setup_only" = yes ] || run_quickstart
