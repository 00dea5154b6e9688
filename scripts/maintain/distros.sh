#!/usr/bin/env bash
# distros.sh [--tests] [SUITE...]: tries both commands of README.md in bare installations of Debian,
# and prints the table of docs/platforms.md. A suite is a release that debootstrap knows, or `arm64`:
# the core cross-compiled for that architecture in Debian 13 and tested in an emulator. Default: all
# of them.
#
# In each suite root runs scripts/render.sh in an installation of Debian's minimal base only; then a user with sudo runs
# scripts/test.sh, writes a page, and runs the rendering tests with EGL only. With --tests that is all.
# Without it, the user also runs scripts/render.sh again, and scripts/maintain/package.sh, whose packages
# scripts/maintain/try_packages.sh then tries. The committed sources (HEAD) are tested. Takes about half an hour
# and 3 GB per suite, ten minutes with --tests. Needs root.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
source scripts/maintain/chroot.sh
tests_only=''
if [[ ${1-} == --tests ]]; then
  tests_only=yes
  shift
fi
for suite; do
  [[ $suite != -* ]] || die "distros.sh: unknown option '$suite'" "usage: distros.sh [--tests] [SUITE...]"
done
reason=$(reason_against_roots)
[[ -z $reason ]] || die "distros.sh: $reason" "start it as root, for example with sudo"
git rev-parse --quiet --verify HEAD >/dev/null 2>&1 ||
  die "distros.sh: this folder is not a git checkout" "clone the repository: the committed sources are tested"
scripts/maintain/setup.sh distros

suites=("$@")
((${#suites[@]})) || suites=(bookworm trixie testing arm64)

# timed LOG ROOT USER COMMAND: runs the command and sets `took` to the seconds, or to "failed". Do
# not call it in a subshell, where it could not be interrupted.
timed() {
  local start=$SECONDS
  took=failed
  if inside "$2" "$3" "$4" >"$1" 2>&1; then
    took=$((SECONDS - start))
  else
    say "$4 failed: the end of $1:"
    tail -n 20 "$1" >&2
  fi
}

# version ROOT PACKAGE: prints the version without epoch and revision.
version() {
  local found
  found=$(chroot "$1" dpkg-query --show --showformat='${Version}' "$2" 2>/dev/null) || found='-'
  sed -e 's/^[0-9]*://' -e 's/[-+].*//' <<<"$found"
}

# Prints the result in ctest's log, for example "912 passed, 3 skipped".
counts() {
  local skipped
  skipped=$(grep -cE '\*\*\*Skipped' "$1" || true)
  sed -nE 's/.* ([0-9]+) tests failed out of ([0-9]+).*/\1 failed of \2/p' "$1" | tail -n 1 |
    sed "s/\$/, $skipped skipped/"
}

# run_tests SUITE ROOT: runs both commands, each for the first time, and the rendering tests with EGL only; sets `film`,
# `tests` and `egl`.
run_tests() {
  say "$1: scripts/render.sh as root, in a bare installation"
  make_root "$2" "$1"
  put_sources "$2"
  timed "$2.render.log" "$2" root "scripts/render.sh"
  film=$took

  say "$1: scripts/test.sh as a user with sudo"
  inside "$2" root "chown --recursive someone . && apt-get install --yes sudo" >"$2.sudo.log" 2>&1 ||
    die "sudo cannot be installed in $1" "the full log is $2.sudo.log"
  echo 'someone ALL=(ALL) NOPASSWD: ALL' >"$2/etc/sudoers.d/someone"
  timed "$2.test.log" "$2" someone "scripts/test.sh && build/release/bin/twrench page -o out/flip.html"
  tests=$took

  timed "$2.egl.log" "$2" someone "TWRENCH_TEST_BACKEND=egl ctest \\
    --test-dir build/release --label-regex '^gl\$' --output-on-failure --parallel $(nproc)"
  egl=$took
  say "$1: render.sh: $film s, test.sh: $tests s, $(counts "$2.test.log"), EGL only: $egl s, $(counts "$2.egl.log")"
  [[ "$film$tests$egl" != *failed* ]] || failures=$((failures + 1))
}

rows=() failures=0
try_suite() {
  local suite=$1 root=$place/$1 film tests egl again draws packages row
  run_tests "$suite" "$root"
  [[ -z $tests_only ]] || return 0
  draws=$(inside "$root" root "build/release/bin/twrench doctor" 2>&1 |
    awk '/^OpenGL by .* found / { sub(/^OpenGL by /, ""); sub(/ +found .*/, ""); printf "%s%s", sep, $0; sep = ", " }')
  timed "$root.again.log" "$root" someone "scripts/render.sh --frames 0-59 --overwrite"
  again=$took

  say "$suite: the packages, in another bare installation"
  timed "$root.package.log" "$root" someone "scripts/maintain/package.sh"
  packages=$took
  [[ $packages == failed ]] || scripts/maintain/try_packages.sh "$suite" "$root/home/someone/twrench/out/packages" \
    --frames 0-59 || packages=failed
  row="| $suite | $(version "$root" g++), $(version "$root" cmake) | $(version "$root" libegl-mesa0)"
  row+=" | $(version "$root" ffmpeg) | $film | $tests | $(counts "$root.test.log")"
  row+=" | $(counts "$root.egl.log") | $draws |"
  rows+=("$row")
  [[ "$again$packages" != *failed* ]] || failures=$((failures + 1))
  say "$row"
}

try_arm64() {
  local root=$place/arm64
  say "arm64: the core, cross-compiled in trixie"
  make_root "$root" trixie
  put_sources "$root"
  timed "$root.test.log" "$root" root "scripts/maintain/arm64.sh"
  arm64="arm64, in $(version "$root" qemu-user) of QEMU: $took seconds, $(counts "$root.test.log")"
  [[ $took != failed ]] || failures=$((failures + 1))
}

arm64=''
for suite in "${suites[@]}"; do
  if [[ $suite == arm64 ]]; then try_arm64; else try_suite "$suite"; fi
done

if ((${#rows[@]})); then
  echo '| suite | GCC, CMake | Mesa | ffmpeg | `render.sh`, s | `test.sh`, s | tests | rendering tests, EGL only | backends |'
  echo '|---|---|---|---|---|---|---|---|---|'
  printf '%s\n' "${rows[@]}"
fi
[[ -z $arm64 ]] || echo "$arm64"
for suite in "${suites[@]}"; do
  grep -hE '\*\*\*Skipped' "$place/$suite.test.log" | sed -E "s/^.*Test +#[0-9]+: ([^ ]+).*/$suite skipped: \1/" || true
done
exit $((failures > 0))
