#!/usr/bin/env bash
# Makes and tries the archive of the program that runs without root and without any package but ffmpeg:
#   portable.sh --pack FOLDER        packs the program installed in FOLDER with its shared libraries, OSMesa and
#                                    their licences in out/packages; scripts/maintain/package.sh --portable builds
#                                    and packs it
#   portable.sh --try SUITE ARCHIVE  unpacks and uses the archive in a bare installation of the release SUITE of
#                                    Debian, as a user without rights; needs root
#
# The archive is reproducible: the same program, Debian packages and SOURCE_DATE_EPOCH give the same bytes. It does
# not contain the C and C++ libraries, so it runs on systems with those of the release that builds it, or newer ones.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh

usage() {
  sed -n '/^# /s///p; /^set/q' "$0"
  [[ ${1-} == --help ]] && exit 0 || exit 2
}

# osmesa: prints the file of OSMesa, which the program loads at run time.
osmesa() { /sbin/ldconfig -p | awk '$1 == "libOSMesa.so.8" && /x86-64|AArch64/ { print $NF; exit }'; }

# dependencies FILE...: prints the shared libraries that the files are linked to, as NAME FILE.
dependencies() { ldd "$@" | awk '$2 == "=>" { print $1, $3 }' | LC_ALL=C sort --unique; }

# package_of FILE: prints the Debian package of a library.
package_of() {
  local file
  file=$(realpath "$1")
  # The folders /lib and /usr/lib are the same one, and the package names either.
  dpkg-query --search "*${file#/usr}" 2>/dev/null | sed -nE '/^diversion /d; s/:.*//p; /:/q' | head -n 1 || true
}

# of_system FILE: whether the archive uses the system's copy of a library. The C library depends on the kernel and on
# the configuration of the system. A graphics driver of the system, which is loaded into the same process, may need a
# newer C++ library than that of the release that builds the archive, and a process can have only one.
of_system() {
  case $(package_of "$1") in
    libc6 | libstdc++6 | libgcc-s1) ;;
    *) return 1 ;;
  esac
}

# bundle_libraries STAGE: copies the libraries and the licences of their packages.
bundle_libraries() {
  local stage=$1 name file package packages
  local licences=$stage/share/doc/twrench/licences
  mkdir -p "$stage/lib" "$licences"
  packages=()
  while read -r name file; do
    [[ $file == /* ]] || die "the library $name was not found" "is the program built for this system? see ldd"
    ! of_system "$file" || continue
    package=$(package_of "$file")
    [[ $package ]] || die "$file is not from a Debian package, and its licence is unknown" \
      "remove that library, and install its package"
    packages+=("$package")
    install --mode=755 "$file" "$stage/lib/$name"
  done < <(dependencies "$stage/bin/twrench" "$(osmesa)" && echo "libOSMesa.so.8 $(osmesa)")

  for package in $(printf '%s\n' "${packages[@]}" | LC_ALL=C sort --unique); do
    cp --dereference "/usr/share/doc/$package/copyright" "$licences/$package.copyright"
    dpkg-query --show --showformat='${Package} ${Version}, of the source package ${source:Package} ${source:Version}\n' \
      "$package:$(dpkg --print-architecture)"
  done >"$licences/PACKAGES"
  # The licences of the compiled-in libraries and fonts, and the common licences that all these files refer to.
  cp packaging/copyright "$licences/.."
  mkdir "$licences/common-licenses"
  grep --directories=skip --only-matching --no-filename --extended-regexp \
    'common-licenses/[A-Za-z0-9]+(-[0-9]+(\.[0-9]+)?)?' "$licences"/* "$licences/../copyright" |
    LC_ALL=C sort --unique |
    while IFS=/ read -r _ name; do
      [[ ! -f /usr/share/common-licenses/$name ]] ||
        cp --dereference "/usr/share/common-licenses/$name" "$licences/common-licenses"
    done
}

# rename_glapi STAGE: OSMesa requires the libglapi of the same build. A graphics driver of the system, which is loaded
# first to look for a GPU, may have loaded another one under this name.
rename_glapi() {
  [[ -e $1/lib/libglapi.so.0 ]] || return 0
  mv "$1/lib/libglapi.so.0" "$1/lib/libtwrench-glapi.so.0"
  patchelf --set-soname libtwrench-glapi.so.0 "$1/lib/libtwrench-glapi.so.0"
  patchelf --replace-needed libglapi.so.0 libtwrench-glapi.so.0 "$1/lib/libOSMesa.so.8"
}

# link_inside STAGE: makes the program and the libraries find the libraries inside the folder, wherever it is.
# RUNPATH, unlike RPATH, leaves the libraries of a graphics driver of the system alone.
link_inside() {
  local stage=$1 file outside
  strip --remove-section=.comment --remove-section=.note "$stage/bin/twrench"
  # shellcheck disable=SC2016 # the dynamic linker replaces it
  patchelf --set-rpath '$ORIGIN/../lib' "$stage/bin/twrench"
  for file in "$stage"/lib/*; do
    # shellcheck disable=SC2016
    patchelf --set-rpath '$ORIGIN' "$file"
  done
  outside=$(dependencies "$stage/bin/twrench" "$stage"/lib/* | while read -r name file; do
    [[ $(realpath "$file") == "$stage"/* ]] || of_system "$file" || echo "$name"
  done)
  [[ -z $outside ]] || die "the archive would lack these libraries: ${outside//$'\n'/ }"
}

# add_readme STAGE GLIBC
add_readme() {
  cat >"$1/README" <<END_OF_README
twrench $(project_version): films of rigid bodies that rotate freely

    bin/twrench render          makes the default film, out/dzhanibekov.mp4
    bin/twrench help            describes the commands
    man -M share/man twrench    the manual

This folder can be moved anywhere. Films need the program ffmpeg in PATH; pictures (--no-video) and pages do not.
It requires Linux ($(uname -m)) with glibc $2 or newer, and libstdc++ of GCC 12 or newer.

Licences and example scenes are in share/doc/twrench. The files in lib are those of Debian's packages in
share/doc/twrench/licences/PACKAGES, except for the path by which they find each other. Debian publishes
their sources under the names and versions listed there.
END_OF_README
}

# oldest_glibc FILE...: prints the oldest version of glibc that has all the symbols that the files need.
oldest_glibc() {
  LC_ALL=C objdump -T "$@" | grep --only-matching --extended-regexp 'GLIBC_[0-9.]+' |
    sed 's/^GLIBC_//' | sort --version-sort --unique | tail -n 1
}

# pack FOLDER
pack() {
  local installed=$1 name stage archive glibc
  [[ -x $installed/bin/twrench ]] ||
    die "$installed has no bin/twrench" "build and pack it: scripts/maintain/package.sh --portable"
  scripts/maintain/setup.sh portable
  [[ $(osmesa) ]] || die "OSMesa, which the archive contains, is not installed, or this release does not have it" \
    "make the archive on Debian 12: scripts/maintain/package.sh --portable"
  export LC_ALL=C.UTF-8 TZ=UTC
  umask 022
  : "${SOURCE_DATE_EPOCH:=$(date --date="$(release_date)" +%s)}"
  require_writable build
  require_writable out/packages

  name=twrench-$(project_version)-linux-$(uname -m)
  mkdir -p build/portable
  stage=$(realpath build/portable)/$name archive=out/packages/$name.tar.xz
  rm -rf "$stage"
  cp --recursive "$installed" "$stage"
  say "bundling the libraries"
  bundle_libraries "$stage"
  rename_glapi "$stage"
  link_inside "$stage"
  glibc=$(oldest_glibc "$stage/bin/twrench" "$stage"/lib/*)
  add_readme "$stage" "$glibc"

  say "compressing, which takes a minute or two"
  tar --create --directory "${stage%/*}" --sort=name --format=gnu --owner=0 --group=0 --numeric-owner \
    --mode=u=rwX,go=rX --mtime="@$SOURCE_DATE_EPOCH" "$name" | xz --x86 --lzma2=preset=6 --threads=1 >"$archive.part"
  mv "$archive.part" "$archive"
  echo "$archive"
  say "$(du --apparent-size --human-readable "$archive" | cut -f 1)B, runs with glibc $glibc or newer"
}

# try USER COMMAND: runs it in the bare installation, beside the archive.
try() {
  inside "$root" "$1" "$2" >>"$log" 2>&1 || {
    tail -n 20 "$log" >&2
    die "$suite: '$2' failed as $1" "all it said is in $log"
  }
}

# try_archive SUITE ARCHIVE
try_archive() {
  local suite=$1 archive=$2 reason root log home twrench
  [[ -f $archive ]] || die "$archive does not exist" "make it: scripts/maintain/package.sh --portable"
  source scripts/maintain/chroot.sh
  reason=$(reason_against_roots)
  [[ -z $reason ]] || die "portable.sh: $reason" "start it as root, for example with sudo"
  scripts/maintain/setup.sh distros

  root=$place/$suite-portable log=$place/$suite-portable.try.log
  say "$suite: a bare installation"
  make_root "$root" "$suite"
  : >"$log"
  home=$root/home/someone/twrench
  mkdir "$home"
  # A minimal installation, unlike other systems, does not have xz.
  try root "apt-get update && apt-get install --yes --no-install-recommends xz-utils"
  cp "$archive" "$home/"
  chroot "$root" chown -R someone /home/someone/twrench
  # The folder may be anywhere.
  try someone "mkdir 'some folder' && tar --extract --file ${archive##*/} --directory 'some folder'"
  twrench="'some folder'/$(basename "$archive" .tar.xz)/bin/twrench"

  say "$suite: without ffmpeg"
  try someone "$twrench render --frames 0-2 --no-video --frames-dir frames && test -s frames/frame_000002.png"
  try someone "$twrench page -o page.html && test -s page.html"
  try someone "$twrench render --frames 0-2 -o film.mp4 2>message; test \$? = 4 && cat message && grep ffmpeg message"

  say "$suite: the default film, with ffmpeg"
  try root "apt-get install --yes --no-install-recommends ffmpeg"
  try someone "$twrench render && test -s out/dzhanibekov.mp4"
  try someone "$twrench doctor"
  # Mesa's driver is loaded into the process, beside the libraries of the archive.
  try root "apt-get install --yes --no-install-recommends libegl1 libgl1-mesa-dri"
  try someone "$twrench doctor | grep 'OpenGL by egl.*found'"
  try someone "$twrench render --frames 0-2 --no-video --frames-dir with_egl && diff --recursive frames with_egl"
  say "$suite: the archive works (log: $log)"
}

case ${1-} in
  --pack)
    (($# == 2)) || die "portable.sh: --pack expects FOLDER" "for example --pack build/portable/installed"
    pack "$2"
    ;;
  --try)
    (($# == 3)) || die "portable.sh: --try expects SUITE ARCHIVE" "for example --try bookworm out/packages/twrench-*.tar.xz"
    try_archive "$2" "$3"
    ;;
  --help) usage --help ;;
  '') usage ;;
  *) die "portable.sh: unknown option '$1'" "see portable.sh --help" ;;
esac
