#!/bin/sh
# A newcomer's walk, in clean Debian 12 systems below FOLDER: README's two commands in a clone, the Debian package made there, and that
# package installed and used by an ordinary user on a second system, which has seen neither sources nor compiler.
# Usage, as root: sh tests/newcomer/walk.sh [--suite all|cli|none] [--keep] FOLDER
# --suite: which tests the second command runs; none leaves it out. --keep: the two systems stay in FOLDER; without it only walk.log does.
# ASPERITY_DEBIAN_MIRROR: another mirror than deb.debian.org. ASPERITY_APT_CONF: a file of apt settings that the clean systems need to reach it.
# Exit code 77, "skipped" for CTest: not root, or no debootstrap.
set -eu

source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
mirror=${ASPERITY_DEBIAN_MIRROR:-http://deb.debian.org/debian}
suite=all keep=no folder=

usage() { printf 'usage: sh tests/newcomer/walk.sh [--suite all|cli|none] [--keep] FOLDER\n' >&2; exit 2; }
skip() { printf 'walk.sh: skipped: %s\n' "$1" >&2; exit 77; }
fail() { say "FAILED: $*"; exit 1; }
say() { printf '%s %s\n' "$(date -u '+%Y-%m-%d %H:%M:%S')" "$*" | tee -a "$folder/walk.log"; }

while [ $# -gt 0 ]; do
  case $1 in
    --suite) [ $# -ge 2 ] || usage; suite=$2; shift ;;
    --keep) keep=yes ;;
    -*) usage ;;
    *) [ -z "$folder" ] || usage; folder=$1 ;;
  esac
  shift
done
case $suite in all | cli | none) ;; *) usage ;; esac
[ -n "$folder" ] || usage
[ "$(id -u)" = 0 ] || skip "making a clean system needs root"
command -v debootstrap >/dev/null || skip "no debootstrap: apt-get install debootstrap"
mkdir -p "$folder"
folder=$(CDPATH='' cd -- "$folder" && pwd)
builder=$folder/builder user=$folder/user

release_systems() {
  for system in "$builder" "$user"; do
    for part in proc dev; do
      if mountpoint -q "$system/$part"; then umount -l "$system/$part"; fi
    done
  done
}
end() {
  code=$?
  release_systems
  [ "$keep" = yes ] || rm -rf --one-file-system "$builder" "$user"
  exit "$code"
}
trap end EXIT
trap 'exit 130' INT TERM

# step WHAT COMMAND...: runs it, all output into the log, and says how long it took.
step() {
  what=$1
  shift
  begin=$(date +%s)
  "$@" >>"$folder/walk.log" 2>&1 || fail "$what (see $folder/walk.log)"
  say "$what: $(($(date +%s) - begin)) s"
}

make_system() {
  debootstrap --variant=minbase bookworm "$1" "$mirror"
  printf 'deb %s bookworm main\ndeb %s bookworm-updates main\n' "$mirror" "$mirror" >"$1/etc/apt/sources.list"
  if [ -n "${ASPERITY_APT_CONF-}" ]; then cp "$ASPERITY_APT_CONF" "$1/etc/apt/apt.conf.d/"; fi
}

enter() {
  mount -t proc proc "$1/proc"
  mount --bind /dev "$1/dev"
}

# inside SYSTEM COMMAND: a shell command in a clean environment.
inside() {
  chroot "$1" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 HOME=/root \
    DEBIAN_FRONTEND=noninteractive http_proxy="${http_proxy-}" https_proxy="${https_proxy-}" sh -c "$2"
}

as_user() { inside "$user" "su newcomer -c 'cd && $1'"; }

second_command() {
  case $suite in
    all) inside "$builder" 'cd /srv/asperity && sh tests/run.sh' ;;
    cli) inside "$builder" "cd /srv/asperity && sh tests/run.sh -L '^cli\$'" ;;
  esac
}

install_package() {
  cp "$builder"/srv/asperity/build/package/asperity_*.deb "$user/tmp/"
  inside "$user" 'apt-get update && apt-get install -y /tmp/asperity_*.deb && useradd --create-home newcomer'
}

strength() { sed -n 's/.*"tensile_strength_mpa": *\([0-9.]*\).*/\1/p' "$1" | head -n 1; }

rm -rf --one-file-system "$builder" "$user"
: >"$folder/walk.log"
say "walk of $(git -C "$source" rev-parse --short HEAD), suite $suite, $(nproc) cores"
step "clean Debian 12" make_system "$builder"
cp -a "$builder" "$user"
enter "$builder"
enter "$user"
step "clone" git clone -q --no-hardlinks "$source" "$builder/srv/asperity"
step "sh app/start.sh" inside "$builder" 'cd /srv/asperity && sh app/start.sh'
[ "$suite" = none ] || step "sh tests/run.sh" second_command
step "cpack --preset deb" inside "$builder" 'cd /srv/asperity && cpack --preset deb'
step "apt-get install asperity_*.deb" install_package
step "asperity --help, info" as_user 'asperity --help && asperity info'
step "asperity run, as a user" as_user 'asperity run /usr/share/asperity/configs/quickstart.json --out q && ls q/frames/cracks_*.png q/report.html'
step "README's examples on a copy of the configurations" as_user \
  'cp -r /usr/share/asperity/configs . && asperity validate configs/paper/*.json configs/joint/*.json && asperity law configs/paper/brazilian.json'
step "manual and completion" inside "$user" 'apt-get install -y --no-install-recommends man-db bash-completion && man asperity | grep -q "EXIT STATUS" &&
  bash -ic "source /usr/share/bash-completion/bash_completion; _completion_loader asperity; complete -p asperity"'
built=$(strength "$builder/srv/asperity/outputs/quickstart/summary.json")
installed=$(strength "$user/home/newcomer/q/summary.json")
[ -n "$built" ] || fail "no tensile strength in the quickstart's summary"
[ "$built" = "$installed" ] || fail "the quickstart gave $built MPa where it was built, $installed MPa where it was installed"
say "quickstart: $built MPa in both systems"
step "apt-get remove" inside "$user" 'apt-get remove -y asperity && ! command -v asperity && ! test -e /usr/share/asperity'
say "done"
