#!/usr/bin/env bash
# Installs what is missing of the Debian or Ubuntu packages that this project uses:
#   setup.sh render   to build the program and make films with it
#   setup.sh test     to run its tests as well
#   setup.sh tidy     to run clang-tidy and the fuzzers over it as well
#   setup.sh bench    to build its benchmarks, and the rival to run beside it
#   setup.sh coverage to count the lines that the tests run, and to run them under valgrind
# When nothing is missing it says nothing and calls neither apt nor sudo.
set -euo pipefail

packages=(
  g++ cmake ninja-build pkgconf
  libeigen3-dev libglm-dev libstb-dev libcli11-dev libtomlplusplus-dev libfmt-dev
  nlohmann-json3-dev libboost-dev libisal-dev zlib1g-dev libssl-dev libgl-dev libosmesa6-dev
  libegl-dev libegl1 libegl-mesa0 libcairo2-dev fonts-roboto-unhinted fonts-firacode
  ffmpeg
)
# The formatter by its version: another one would lay the same sources out differently.
# gnuplot is for the figures of `twrench plot` and `study --plot`; films do without it. ImageMagick
# and libpng's tools read our PNG files.
test_packages=(libgtest-dev libgmock-dev clang-format-14 gnuplot-nox imagemagick libpng-tools)

case "${1-}" in
  render) ;;
  test) packages+=("${test_packages[@]}") ;;
  tidy) packages+=("${test_packages[@]}" clang-tidy-14 clang-14 libclang-rt-14-dev) ;;
  bench) packages+=(libbenchmark-dev libgsl-dev libsundials-dev python3-vtk9 xvfb xauth) ;;
  coverage) packages+=("${test_packages[@]}" gcovr valgrind) ;;
  *)
    echo "usage: $0 render|test|tidy|bench|coverage" >&2
    exit 2
    ;;
esac

say() { printf 'twrench: %s\n' "$*" >&2; }

if ! command -v apt-get >/dev/null; then
  say "error: no apt-get here: this script sets up Debian 12 and Ubuntu 24.04"
  say "elsewhere install the like of: ${packages[*]}; then: cmake --preset release && cmake --build --preset release"
  exit 1
fi

installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "${packages[@]}" \
  2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

install=(apt-get install --yes --no-install-recommends "${missing[@]}")

# Sets as_root to the words that go before a command to run it as root; false if there are none.
find_root() {
  as_root=()
  ((EUID == 0)) && return
  as_root=(sudo)
  command -v sudo >/dev/null || return
  sudo -n true 2>/dev/null && return
  [[ -t 0 && -t 2 ]] && say "sudo is needed to install ${#missing[@]} packages" && sudo -v
}
if ! find_root; then
  command="apt-get update && ${install[*]}"
  ! command -v sudo >/dev/null || command="sudo sh -c '$command'"
  say "error: ${#missing[@]} packages are missing, and installing them takes an administrator's rights"
  say "have an administrator run this one command, then start again:"
  printf '%s\n' "$command" >&2
  exit 1
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p build
log=$PWD/build/setup.log
# LC_ALL: the log is read below. The lock is often held for a while on a machine just started.
run_apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C \
    "$@" -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 </dev/null >>"$log" 2>&1
}

say "installing ${#missing[@]} packages with apt-get: ${missing[*]}"
say "this takes a minute or two (log: $log)"
: >"$log"
# A source that cannot be reached need not hold what is missing: the installation decides.
lists=whole
run_apt apt-get update --error-on=any || lists=partial
if ! run_apt "${install[@]}"; then
  tail -n 15 "$log" >&2
  say "error: apt-get could not install them; its last lines are above, all of them in $log"
  if [[ $lists == partial ]]; then
    say "it could not fetch every package list: check the network and /etc/apt/sources.list*"
  elif grep -qE 'Unable to locate package|no installation candidate' "$log"; then
    say "they are packages of Debian 12 and Ubuntu 24.04; on Ubuntu some are in 'universe', which"
    say "the Components of /etc/apt/sources.list.d/ubuntu.sources must name"
  fi
  exit 1
fi
say "installed"
