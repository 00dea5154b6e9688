#!/usr/bin/env bash
# Installs the missing Debian or Ubuntu packages for some purposes, in one round:
#   setup.sh PURPOSE... [--if-possible PURPOSE...]
# The purposes are:
#   render      building the program and making videos
#   python      building the Python module
#   test        also running the tests
#   check       also running the project's checks
#   tidy        also running clang-tidy and the fuzzers
#   bench       building the benchmarks and the programs they compare with
#   foreign     checking the motion of free bodies in other programs
#   library     building the library with another compiler, and comparing its interface
#   coverage    measuring line coverage, and running the tests under valgrind
#   arm64       cross-compiling for arm64 and running the core tests in an emulator
#   package     making Debian's packages
#   portable    making the archive that runs without installation
#   docs        building the reference pages
#   interchange running other programs on exported files
#   page        building the template of pages
#   browser     testing pages in a browser
#   recipes     following the recipes of CONTRIBUTING.md
#   node        running the programs of npm
#   distros     testing the project on other releases of Debian
# Packages are selected by availability, not by the name of the release. If nothing is missing, the
# script prints nothing and calls neither apt nor sudo. If only packages of the purposes after --if-possible
# are missing and cannot be installed, it prints the reason and succeeds.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh

# Purpose | description | packages | fallback. The first package that the release has is used. The
# fallback applies if it has none; without a fallback, a package is required.
needs() {
  cat <<'END'
render   | the C++ compiler              | g++
render   | CMake                         | cmake
render   | Ninja                         | ninja-build
render   | pkg-config                    | pkgconf pkg-config
render   | Eigen                         | libeigen3-dev
render   | GLM                           | libglm-dev
render   | stb                           | libstb-dev
render   | CLI11                         | libcli11-dev
render   | toml++                        | libtomlplusplus-dev
render   | fmt                           | libfmt-dev
render   | nlohmann-json                 | nlohmann-json3-dev
render   | Boost's headers               | libboost-dev
render   | ISA-L                         | libisal-dev
render   | libspng                       | libspng-dev
render   | libzip                        | libzip-dev
render   | pugixml                       | libpugixml-dev
render   | libyaml                       | libyaml-dev
render   | libebur128                    | libebur128-dev
render   | meshoptimizer                 | libmeshoptimizer-dev
render   | zlib                          | zlib1g-dev libz-dev
render   | OpenSSL                       | libssl-dev
render   | OpenGL's headers              | libgl-dev
render   | EGL's headers                 | libegl-dev
render   | EGL                           | libegl1
render   | Mesa's EGL                    | libegl-mesa0
render   | OSMesa                        | libosmesa6                | EGL in software is used
render   | Cairo                         | libcairo2-dev
render   | FreeType                      | libfreetype-dev libfreetype6-dev
render   | HarfBuzz                      | libharfbuzz-dev
render   | FriBidi                       | libfribidi-dev
render   | the typeface Roboto           | fonts-roboto-unhinted
render   | the typeface Fira Code        | fonts-firacode
render   | ffmpeg                        | ffmpeg
test     | GoogleTest                    | libgtest-dev
python   | Python's headers              | python3-dev
python   | pybind11                      | pybind11-dev
python   | NumPy                         | python3-numpy
python   | setuptools, for pip           | python3-setuptools
python   | wheel, for the same           | python3-wheel
test     | pytest                        | python3-pytest
test     | nbconvert, to run notebooks   | jupyter-nbconvert         | notebooks are not run in a kernel
test     | the kernel of notebooks       | python3-ipykernel         | notebooks are not run in a kernel
test     | SciPy, to compare with        | python3-scipy
test     | scikit-image, for the same    | python3-skimage           | its numbers that the tests store are used
test     | pandas                        | python3-pandas
test     | Pillow, to read our PNG       | python3-pil
test     | mypy                          | mypy
test     | GoogleMock                    | libgmock-dev
test     | a validator of JSON Schema    | python3-jsonschema        | the schema of scene files is not tested
test     | a typeface of many scripts    | fonts-freefont-ttf
test     | gnuplot, for figures          | gnuplot-nox gnuplot
test     | ImageMagick, to read our PNG  | imagemagick
test     | groff, to check manual pages  | groff-base
test     | mandoc, for the same          | mandoc
test     | libpng's tools, for the same  | libpng-tools
check    | clang-format 14               | clang-format-14           | the formatting of the sources is not checked
check    | debootstrap, for Debian 13   | debootstrap
library  | Clang, the other compiler     | clang-14 clang
library  | abidiff, to compare libraries | abigail-tools
tidy     | clang-tidy 14                 | clang-tidy-14
tidy     | Clang 14                      | clang-14
tidy     | Clang 14's sanitizers         | libclang-rt-14-dev
bench    | Google Benchmark              | libbenchmark-dev
bench    | GSL                           | libgsl-dev
bench    | SUNDIALS                      | libsundials-dev
bench    | VTK                           | python3-vtk9
bench    | a screen for VTK              | xvfb
bench    | its access control            | xauth
foreign  | MuJoCo                        | libmujoco-dev
foreign  | Bullet                        | libbullet-dev
foreign  | the Open Dynamics Engine      | libode-dev
foreign  | DART                          | libdart-dev
foreign  | Simbody                       | libsimbody-dev
foreign  | ADMesh, to read STL           | admesh
coverage | gcovr                         | gcovr
coverage | valgrind                      | valgrind
package  | the tools for packages        | dpkg-dev
package  | file, which they use          | file
package  | lintian, to check packages    | lintian
portable | dpkg-buildflags               | dpkg-dev
portable | patchelf, for the search path | patchelf
portable | xz                            | xz-utils
portable | objdump and strip             | binutils
docs     | Doxygen                       | doxygen
docs     | Sphinx                        | python3-sphinx
docs     | MyST, which reads Markdown    | python3-myst-parser
docs     | Sphinx's theme Furo           | furo
distros  | debootstrap                   | debootstrap
interchange | Node.js                    | nodejs
interchange | npm                        | npm
interchange | Blender, to open exports      | blender                   | it is not tested with them
page     | Clang, for WebAssembly        | clang-19 clang-22 clang-21 clang-20 clang-18
page     | its linker                    | lld-19 lld-22 lld-21 lld-20 lld-18
page     | its libc++                    | libc++-19-dev-wasm32 libc++-22-dev-wasm32 libc++-21-dev-wasm32 libc++-20-dev-wasm32 libc++-18-dev-wasm32
page     | its libc++abi                 | libc++abi-19-dev-wasm32 libc++abi-22-dev-wasm32 libc++abi-21-dev-wasm32 libc++abi-20-dev-wasm32 libc++abi-18-dev-wasm32
page     | its compiler-rt               | libclang-rt-19-dev-wasm32 libclang-rt-22-dev-wasm32 libclang-rt-21-dev-wasm32 libclang-rt-20-dev-wasm32 libclang-rt-18-dev-wasm32
page     | a C library for WebAssembly   | wasi-libc
page     | Eigen                         | libeigen3-dev
page     | fmt                           | libfmt-dev
page     | GLM                           | libglm-dev
page     | Boost's headers               | libboost-dev
page     | the bundler of scripts        | esbuild
page     | OpenSSL's program             | openssl
page     | the compressor of the core     | zopfli
browser  | Chromium                      | chromium chromium-browser
browser  | Firefox                       | firefox-esr               | pages are tested in Chromium alone
browser  | a screen for Firefox          | xvfb                      | pages are tested in Chromium alone
browser  | its access control            | xauth                     | pages are tested in Chromium alone
recipes  | patch, to apply changes       | patch
node     | Node.js                       | nodejs
node     | npm                           | npm
browser  | ImageMagick, for its pictures | imagemagick
arm64    | CMake                         | cmake
arm64    | Ninja                         | ninja-build
arm64    | pkg-config                    | pkgconf pkg-config
arm64    | the C++ compiler for arm64    | g++-aarch64-linux-gnu
arm64    | the emulator                  | qemu-user-static qemu-user
arm64    | Eigen                         | libeigen3-dev
arm64    | GLM                           | libglm-dev
arm64    | CLI11                         | libcli11-dev
arm64    | nlohmann-json                 | nlohmann-json3-dev
arm64    | Boost's headers for arm64     | libboost-dev:arm64
arm64    | the font Roboto               | fonts-roboto-unhinted
arm64    | the font Fira Code            | fonts-firacode
arm64    | stb for arm64                 | libstb-dev:arm64
arm64    | toml++ for arm64              | libtomlplusplus-dev:arm64
arm64    | fmt for arm64                 | libfmt-dev:arm64
arm64    | ISA-L for arm64               | libisal-dev:arm64
arm64    | libspng for arm64             | libspng-dev:arm64
arm64    | libzip for arm64              | libzip-dev:arm64
arm64    | pugixml for arm64             | libpugixml-dev:arm64
arm64    | libyaml for arm64             | libyaml-dev:arm64
arm64    | libebur128 for arm64          | libebur128-dev:arm64
arm64    | meshoptimizer for arm64       | libmeshoptimizer-dev:arm64
arm64    | zlib for arm64                | zlib1g-dev:arm64 libz-dev:arm64
arm64    | OpenSSL for arm64             | libssl-dev:arm64
arm64    | OpenGL's headers for arm64    | libgl-dev:arm64
arm64    | EGL's headers for arm64       | libegl-dev:arm64
arm64    | Cairo for arm64               | libcairo2-dev:arm64
arm64    | FreeType for arm64            | libfreetype-dev:arm64 libfreetype6-dev:arm64
arm64    | HarfBuzz for arm64            | libharfbuzz-dev:arm64
arm64    | FriBidi for arm64             | libfribidi-dev:arm64
arm64    | a typeface of many scripts    | fonts-freefont-ttf
arm64    | ffmpeg, to read our PNG       | ffmpeg
arm64    | GoogleTest for arm64          | libgtest-dev:arm64
arm64    | GoogleMock for arm64          | libgmock-dev:arm64
END
}

# uses_of PURPOSE: prints the rows of the table that it needs.
uses_of() {
  case $1 in
    render | arm64 | page | node | distros) echo "$1" ;;
    python) echo render python ;;
    bench | foreign) echo render "$1" ;;
    test | interchange) echo render python "$1" ;;
    package) echo render python page package ;;
    portable) echo render page portable ;;
    browser) echo render page browser ;;
    recipes) echo render python test page recipes ;;
    check | library | tidy | coverage | docs) echo render python test "$1" ;;
    *) return 1 ;;
  esac
}

usage() {
  sed -n '/^# /s///p; /^set/q' "$0"
  [[ $1 == --help ]] && exit 0 || exit 2
}

uses=() optional_uses=() is_optional=''
for purpose; do
  if [[ $purpose == --if-possible ]]; then
    is_optional=yes
    continue
  fi
  read -ra words < <(uses_of "$purpose") || usage "$purpose"
  if [[ $is_optional ]]; then optional_uses+=("${words[@]}"); else uses+=("${words[@]}"); fi
done
((${#uses[@]} + ${#optional_uses[@]})) || usage ''

# Any installed Node.js will do.
has_node=''
if command -v node >/dev/null && command -v npm >/dev/null; then has_node=yes; fi

roles=() candidates=() otherwise=() required=()
declare -A listed # the index of each list of packages
while IFS='|' read -r use role packages instead; do
  read -r use <<<"$use"
  if [[ " ${uses[*]} " == *" $use "* ]]; then
    is_required=1
  elif [[ " ${optional_uses[*]} " == *" $use "* ]]; then
    is_required=0
  else
    continue
  fi
  [[ $use != node || -z $has_node ]] || continue
  read -r packages <<<"$packages"
  read -r instead <<<"${instead-}" || true
  i=${listed[$packages]-}
  if [[ -n $i ]]; then
    ((!is_required)) || required[i]=1
    [[ -n $instead ]] || otherwise[i]=''
    continue
  fi
  listed[$packages]=${#roles[@]}
  read -r roles[${#roles[@]}] <<<"$role"
  candidates+=("$packages") otherwise+=("$instead") required+=("$is_required")
done < <(needs)

if ! command -v apt-get >/dev/null; then
  die "this system has no apt-get: scripts/maintain/setup.sh installs packages of Debian and Ubuntu only" \
    "cmake --preset release lists what is missing and its packages on Fedora and Arch" \
    "(docs/platforms.md); then: cmake --build --preset release"
fi

all_packages() { printf '%s ' "${candidates[@]}"; }
# shellcheck disable=SC2046 # words
installed=$(dpkg-query --show \
  --showformat='${db:Status-Status} ${Package}\n${db:Status-Status} ${Package}:${Architecture}\n' \
  $(all_packages) 2>/dev/null || true)

# Whether something must be installed, and whether it may be left out after all.
missing=() must=0 may_fail=1
for i in "${!roles[@]}"; do
  for package in ${candidates[i]}; do
    ! grep -qxF "installed $package" <<<"$installed" || continue 2
  done
  missing+=("$i")
  [[ -n ${otherwise[i]} ]] || must=1
  [[ -n ${otherwise[i]} ]] || ((!required[i])) || may_fail=0
done
# Optional packages are installed only together with others.
((must)) || exit 0
require_writable build

# fail REASON REMEDY...: reports why packages cannot be installed, which ends this script.
fail() {
  ((may_fail)) || die "$@"
  say "note: $1"
  shift
  printf '  %s\n' "$@" >&2
  exit 0
}

# Sets as_root to the command prefix for running as root; returns false if there is none.
find_root() {
  as_root=()
  ((EUID == 0)) && return
  as_root=(sudo)
  command -v sudo >/dev/null || return
  sudo -n true 2>/dev/null && return
  [[ -t 0 && -t 2 ]] && say "sudo is needed to install ${#missing[@]} packages" && sudo -v
}

# Sets `chosen` to a package for each missing item, `absent` to required items for which the release has
# none, `dropped` to those after --if-possible, and `notes` to the fallbacks used.
choose() {
  chosen=() absent=() dropped=() notes=()
  local offered='' i package
  # shellcheck disable=SC2046 # words
  offered=$(LC_ALL=C apt-cache policy $(all_packages) 2>/dev/null |
    awk '/^[^ ]/ { name = $1; sub(/:$/, "", name) } /Candidate:/ && $2 != "(none)" { print name }')
  for i in "${missing[@]}"; do
    for package in ${candidates[i]}; do
      if grep -qxF "$package" <<<"$offered"; then
        chosen+=("$package")
        continue 2
      fi
    done
    if [[ -n ${otherwise[i]} ]]; then
      notes+=("${roles[i]} is not in this release; ${otherwise[i]}")
    elif ((required[i])); then
      absent+=("${roles[i]} (${candidates[i]})")
    else
      dropped+=("${roles[i]} is not in this release")
    fi
  done
}

if ! find_root; then
  choose
  command="apt-get update && apt-get install --yes --no-install-recommends ${chosen[*]}"
  # Without package lists no candidates are known: use the first package that may provide each item.
  if ((${#absent[@]} + ${#dropped[@]})); then
    command="apt-get update && apt-get install --yes --no-install-recommends"
    for i in "${missing[@]}"; do
      [[ -n ${otherwise[i]} ]] || command+=" $(awk '{ print $1 }' <<<"${candidates[i]}")"
    done
  fi
  ! command -v sudo >/dev/null || command="sudo sh -c '$command'"
  fail "${#missing[@]} packages are missing, and installing them requires administrator rights" \
    "have an administrator run this command, then try again:" "$command"
fi

log=$PWD/build/setup.log
: >"$log"
# run_apt COMMAND...: runs it as root; its output goes to the log, in English, because it is parsed
# below. Waits for the lock, because apt is often busy on a machine that was just started.
run_apt() {
  local patience=300 told='' words status
  while true; do
    status=0
    words=$("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C \
      "$@" -o Dpkg::Use-Pty=0 -o Acquire::Retries=2 </dev/null 2>&1) || status=$?
    printf '%s\n' "$words" >>"$log"
    ((status)) && grep -qE 'Could not get lock|Unable to acquire' <<<"$words" || return "$status"
    ((SECONDS < patience)) || return "$status"
    if [[ -z $told ]]; then
      told=$(grep -m 1 -oE 'process [0-9]+ \([^)]*\)' <<<"$words" || echo "another program")
      say "waiting for at most five minutes: $told holds apt's lock"
    fi
    sleep 2
  done
}

# Explains why apt-get failed, from its log; if the reason is unknown, prints the last lines of the
# log.
explain() {
  said() { grep -qE "$1" "$log"; }
  if said 'Could not get lock|Unable to acquire'; then
    fail "apt's lock was not free within five minutes: $(grep -oE 'It is held by .*' "$log" | tail -n 1)" \
      "wait until that process has ended, then try again"
  elif said 'dpkg was interrupted'; then
    fail "an earlier installation of packages was interrupted" \
      "complete it, then try again: ${as_root[*]:+sudo }dpkg --configure -a"
  elif said 'fix-broken|Unmet dependencies|unmet dependencies|half-installed|very bad inconsistent state'; then
    fail "packages of this system are broken or only half installed (see $log)" \
      "repair them, then try again: ${as_root[*]:+sudo }apt-get --fix-broken install"
  elif said 'enough free space|No space left'; then
    fail "the disk is too full to install ${#chosen[@]} packages" "free some space, then try again"
  elif [[ $lists == partial ]] || said 'Failed to fetch|Could not resolve'; then
    fail "packages could not be fetched: $(grep -m 1 -E '^[EW]: ' "$log" | cut -c 4-)" \
      "check the network and the sources in /etc/apt, then try again"
  fi
  tail -n 15 "$log" >&2
  fail "apt-get could not install ${chosen[*]}" "its last lines are above, the full log is $log"
}

say "installing missing packages with apt-get, which takes a minute or two (log: $log)"
lists=whole
if [[ " ${uses[*]} " == *" arm64 "* ]] && ! dpkg --print-foreign-architectures | grep -qx arm64; then
  "${as_root[@]}" dpkg --add-architecture arm64
fi
# An unreachable source may not matter for the missing packages: the installation decides.
run_apt apt-get update --error-on=any || lists=partial
choose
((${#absent[@]} + ${#dropped[@]} == 0)) || [[ $lists == whole ]] || explain
if ((${#absent[@]})); then
  printf -v names '%s, ' "${absent[@]}"
  fail "this release has no package for ${names%, }" \
    "on Ubuntu some are in 'universe', which the Components of its sources must include;" \
    "for copies from elsewhere see docs/platforms.md"
fi
for note in "${notes[@]}" "${dropped[@]}"; do say "$note"; done
((${#chosen[@]})) || exit 0
say "packages: ${chosen[*]}"
run_apt apt-get install --yes --no-install-recommends --no-remove "${chosen[@]}" || explain
say "installed"
