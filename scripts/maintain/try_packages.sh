#!/usr/bin/env bash
# try_packages.sh SUITE FOLDER [OPTION...]: installs the packages that scripts/maintain/package.sh made in
# FOLDER on a bare installation of the release SUITE, and uses and removes each. Options are those of
# `twrench render`, for a film that takes less time than the default one. Needs root.
#
# The program must make its film and report nothing missing; a separate project must find the library
# with CMake and with pkg-config; Python must find the module, if there is one; and no file may be left
# behind.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
(($# >= 2)) || die "try_packages.sh: expected SUITE FOLDER" "for example bookworm out/packages"
((EUID == 0)) || die "try_packages.sh: only root can make an installation of Debian" "start it with sudo"
suite=$1 folder=$2
shift 2
compgen -G "$folder/*.deb" >/dev/null || die "$folder has no packages" "make them: scripts/maintain/package.sh"
source scripts/maintain/chroot.sh
scripts/maintain/setup.sh distros

root=$place/$suite-packages log=$place/$suite-packages.try.log
say "$suite: a bare installation"
make_root "$root" "$suite"
put_sources "$root"
cp "$folder"/*.deb "$root/home/someone/twrench"
chroot "$root" chown -R someone /home/someone/twrench
: >"$log"

# try USER COMMAND: runs it in the installation's copy of the sources.
try() {
  inside "$root" "$1" "$2" >>"$log" 2>&1 || {
    tail -n 20 "$log" >&2
    die "$suite: '$2' failed as $1" "all it said is in $log"
  }
}

# Prints the files of the system except the records of apt, dpkg and ldconfig.
files() {
  (cd "$root" && find usr etc var \( -path var/lib/apt -o -path var/lib/dpkg -o -path var/log \
    -o -path var/cache/apt -o -path var/cache/debconf -o -path var/cache/ldconfig \) -prune -o -print) | sort
}

# try_package PACKAGE TOOLS COMMAND...: installs the package and the tools, runs the commands as a
# user, and removes the packages again.
try_package() {
  local package=$1 tools=$2 before command left
  shift 2
  say "$suite: $package"
  before=$(files)
  try root "apt-get install --yes ./${package}_*.deb $tools"
  for command; do try someone "$command"; done
  try root "apt-get remove --purge --yes $package $tools && $clean"
  left=$(comm -13 <(echo "$before") <(files))
  [[ -z $left ]] || die "$suite: $package left $(wc -l <<<"$left") files behind, such as" \
    "$(head -n 20 <<<"$left")"
}
# Otherwise apt would keep a dependency that another package happens to suggest.
clean="apt-get autoremove --purge --yes -o APT::AutoRemove::RecommendsImportant=false \
  -o APT::AutoRemove::SuggestsImportant=false"

# Install an init system first: libraries of ffmpeg recommend one, and apt never removes it.
try root "apt-get update && apt-get install --yes --no-install-recommends systemd-sysv"
# The package is not at fault if this release lacks something that the program does not need.
try_package twrench '' "twrench render $*" "test -s out/dzhanibekov.mp4" "twrench doctor" \
  "twrench doctor | awk '/  missing  / { getline; if (!/not needed/) exit 1 }'"
try_package libtwrench-dev "cmake g++ make pkgconf" \
  "cmake -S examples/cpp -B build && cmake --build build && build/flip_time" \
  "c++ -std=c++20 examples/cpp/flip_time.cpp -o by_pkg_config \$(pkg-config --cflags --libs twrench) && ./by_pkg_config"
if compgen -G "$folder/python3-twrench_*.deb" >/dev/null; then
  # Without the bytecode of the package, root would leave bytecode behind.
  try_package python3-twrench '' "python3 examples/python/body_to_film.py"
fi
say "$suite: the packages work, and leave nothing behind (log: $log)"
