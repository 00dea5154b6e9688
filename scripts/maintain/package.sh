#!/usr/bin/env bash
# package.sh [--twice]: installs missing dependencies, makes Debian packages for the installed release of Debian
# in out/packages, and checks them with lintian. scripts/maintain/try_packages.sh tries them on a bare system.
# package.sh --portable: makes an archive there instead. The program runs from it without installation, also on
# other distributions. scripts/maintain/portable.sh packs it, and tries it on a bare system.
#
# The packages are reproducible: the same sources, Debian packages and SOURCE_DATE_EPOCH give the same
# bytes in any folder, for any user, at any time. SOURCE_DATE_EPOCH, in seconds since 1970, is by
# default the time of the last commit or, outside git, that of the release (TWRENCH_RELEASE_DATE in
# CMakeLists.txt). With --twice the packages of the committed sources are then made again, in another folder
# and with another umask, time zone, locale and home, and compared byte by byte.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
twice='' purpose=package
case ${1-} in
  '') ;;
  --twice) twice=yes ;;
  --portable)
    purpose=portable
    grep -qx 'VERSION_CODENAME=bookworm' /etc/os-release 2>/dev/null ||
      die "the portable archive has to be made on Debian 12, because it does not run with an older C library than here" \
        "run this in an installation of Debian 12, such as a container"
    ;;
  *)
    sed -n '/^# /s///p; /^set/q' "$0"
    [[ $1 == --help ]] && exit 0 || exit 2
    ;;
esac
scripts/maintain/setup.sh "$purpose"

export LC_ALL=C.UTF-8 TZ=UTC
umask 022
if [[ -z ${SOURCE_DATE_EPOCH-} ]]; then
  # --git-dir excludes a repository in a folder above.
  SOURCE_DATE_EPOCH=$(git --git-dir=.git log -1 --format=%ct 2>/dev/null ||
    date --date="$(release_date)" +%s)
fi
export SOURCE_DATE_EPOCH

# Debian's hardened flags, without link-time optimisation, which Ubuntu adds and which would put
# intermediate code into the static library, and without debug symbols, which are stripped anyway.
export DEB_BUILD_MAINT_OPTIONS='hardening=+all optimize=-lto' DEB_CXXFLAGS_MAINT_STRIP='-g -O2'
CXXFLAGS="$(dpkg-buildflags --get CXXFLAGS) $(dpkg-buildflags --get CPPFLAGS)"
LDFLAGS=$(dpkg-buildflags --get LDFLAGS)
export CXXFLAGS LDFLAGS
# The cache holds the flags of an earlier run.
rm -f "build/$purpose/CMakeCache.txt"
scripts/maintain/page.sh --template
if [[ $purpose == portable ]]; then
  installed=build/portable/installed
  scripts/maintain/build.sh --in portable release -DTWRENCH_PYTHON=OFF twrench manual
  rm -rf "$installed"
  cmake --install build/portable --component program --prefix "$PWD/$installed" >build/portable/install.log
  exec scripts/maintain/portable.sh --pack "$installed"
fi
scripts/maintain/build.sh --in package release -DCMAKE_INSTALL_PREFIX=/usr -DTWRENCH_PYTHON=ON

build=build/package packages=out/packages
require_writable "$packages"
say "packing"
rm -rf "$build/packed"
cpack --config $build/CPackConfig.cmake -B $build/packed >$build/cpack.log 2>&1 || {
  grep -A 5 'Error' $build/cpack.log >&2
  die "cpack could not make the packages for the reason above" "the full log is $build/cpack.log"
}
say "checking with lintian"
lintian --allow-root --fail-on error,warning $build/packed/*.deb >&2 ||
  die "lintian objects to the packages in $build/packed" "lintian-explain-tags TAG tells more"
rm -f $packages/*.deb
mv $build/packed/*.deb $packages
ls $packages/*.deb

# make_again: makes the packages of the committed sources elsewhere, and compares them with those above.
make_again() {
  local other package
  other=$(mktemp --directory)
  # shellcheck disable=SC2064 # that folder
  trap "rm -rf '$other'" EXIT
  git clone --quiet . "$other/elsewhere"
  (umask 077 && env -i HOME="$other" PATH="$PATH" TZ=Asia/Tokyo LC_ALL=C CCACHE_DISABLE=1 \
    "$other/elsewhere/scripts/maintain/package.sh" >/dev/null)
  for package in "$packages"/*.deb; do
    cmp "$package" "$other/elsewhere/$package" || die "$package differs from one build to the next" \
      "diffoscope shows where, once the second build is kept: remove the trap in make_again"
  done
  say "both builds of the packages have the same bytes"
}
[[ -z $twice ]] || make_again
