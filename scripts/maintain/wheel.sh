#!/usr/bin/env bash
# wheel.sh [SUITE...]: builds the Python module as wheels in out/wheels, one for each release of Debian and
# its Python, and tries each in another bare installation of that release with only Python and NumPy.
# Default: bookworm trixie.
#
# A wheel contains the page and the shared libraries that the module is linked with, under names that no
# other library has, beside the licences of their packages. OpenGL and ffmpeg are not included: they are
# loaded or started when they are used. The committed sources (HEAD) are built. Takes ten minutes and 3 GB
# per release. Needs root.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
for suite; do
  [[ $suite != -* ]] || { sed -n '/^# /s///p; /^set/q' "$0"; [[ $suite == --help ]] && exit 0 || exit 2; }
done
source scripts/maintain/chroot.sh
reason=$(reason_against_roots)
[[ -z $reason ]] || die "wheel.sh: $reason" "start it as root, for example with sudo"
git rev-parse --quiet --verify HEAD >/dev/null 2>&1 ||
  die "wheel.sh: this folder is not a git checkout" "clone the repository: the committed sources are built"
scripts/maintain/setup.sh distros page
scripts/maintain/page.sh --template
require_writable out/wheels

# in_root ROOT USER COMMAND: runs the command in the installation; its output goes to ROOT.log.
in_root() {
  inside "$1" "$2" "$3" >>"$1.log" 2>&1 || {
    tail -n 20 "$1.log" >&2
    die "${1##*/}: '$3' failed as $2" "the full log is $1.log"
  }
}

# build_wheel SUITE: builds the wheel, and sets `wheel` to its file.
build_wheel() {
  local root=$place/$1-wheel glibc machine
  make_root "$root" "$1"
  put_sources "$root"
  mkdir -p "$root/home/someone/twrench/build/page"
  cp build/page/page.html "$root/home/someone/twrench/build/page"
  chroot "$root" chown --recursive someone /home/someone/twrench
  in_root "$root" root "scripts/maintain/setup.sh python && apt-get install --yes --no-install-recommends patchelf"
  in_root "$root" someone "CMAKE_BUILD_PARALLEL_LEVEL=$(nproc) python3 setup.py build"
  in_root "$root" someone "packaging/bundle_libraries.sh build/lib*/twrench"
  # The C library of the release is the oldest that the wheel runs with.
  glibc=$(chroot "$root" getconf GNU_LIBC_VERSION)
  glibc=${glibc#glibc } machine=$(uname -m)
  in_root "$root" someone \
    "python3 setup.py bdist_wheel --skip-build --plat-name manylinux_${glibc/./_}_$machine"
  wheel=$(find "$root/home/someone/twrench/dist" -name '*.whl')
  cp "$wheel" out/wheels
  wheel=out/wheels/${wheel##*/}
}

# try_wheel SUITE: installs the wheel without a network and uses it: without OpenGL and ffmpeg, whose absence
# must be reported, and then with them.
try_wheel() {
  local root=$place/$1-wheel-bare home
  home=$root/home/someone/twrench
  make_root "$root" "$1"
  mkdir "$home"
  cp "$wheel" packaging/try_wheel.py "$home"
  chroot "$root" chown --recursive someone /home/someone/twrench
  in_root "$root" root "apt-get update && apt-get install --yes --no-install-recommends python3-numpy python3-venv"
  in_root "$root" someone "python3 -m venv --system-site-packages venv && venv/bin/pip install --no-index ./*.whl"
  in_root "$root" someone "venv/bin/python try_wheel.py"
  in_root "$root" root "apt-get install --yes --no-install-recommends libegl1 libgl1-mesa-dri"
  in_root "$root" someone "venv/bin/python try_wheel.py gl"
  in_root "$root" root "apt-get install --yes --no-install-recommends ffmpeg"
  in_root "$root" someone "venv/bin/python try_wheel.py gl ffmpeg"
}

suites=("$@")
((${#suites[@]})) || suites=(bookworm trixie)
for suite in "${suites[@]}"; do
  say "$suite: building the wheel"
  build_wheel "$suite"
  say "$suite: trying it with only Python and NumPy"
  try_wheel "$suite"
  say "$suite: $wheel works, $(du --apparent-size --human-readable "$wheel" | cut -f 1)B"
done
