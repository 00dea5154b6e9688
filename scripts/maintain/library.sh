#!/usr/bin/env bash
# library.sh: builds the library of the dynamics alone, static and shared, and tests it; installs it
# to a separate folder; and builds and runs examples/cpp with the installed library, through
# find_package and through pkg-config. It also links tests/library/consumer.cpp, compiled with other
# flags than the library, and tests/library/bad_input.cpp. Projects that contain the sources also build
# the examples, with g++ and with clang++. Finally it compares the binary interface of the shared
# library with packaging/abi.
#   library.sh          builds the programs with each compiler and each set of flags
#   library.sh --quick  uses each set of flags and each linkage with one compiler only, and does not test the library
#                       itself, whose tests also run with the rest
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
mode=${1-}
if [[ -n $mode && $mode != --quick ]]; then
  sed -n '/^# /s///p; /^set/q' "$0"
  [[ $mode == --help ]] && exit 0 || exit 2
fi
scripts/maintain/setup.sh library

# expect_line TEXT FILE
expect_line() {
  grep -qF -- "$1" "$2" || die "$2 does not say '$1'" "it says: $(tail -n 3 "$2")"
}

examples='flip_time engineer game plot'

# same_numbers FILE EXPECTED: checks that both have the same words, and numbers within 1e-13 max(1,
# |x|).
same_numbers() {
  awk 'function is_number(x) { return x ~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/ }
       function size(x) { return x < 0 ? -x : x }
       { gsub(/,/, " ,") }
       NR == FNR { expected[++count] = $0; next }
       { if (split(expected[FNR], word) != NF) exit 1
         for (i = 1; i <= NF; ++i) {
           bound = 1e-13 * (size(word[i]) > 1 ? size(word[i]) : 1)
           if (is_number($i) && is_number(word[i]) ? size($i - word[i]) > bound : $i "" != word[i] "") exit 1
         } }
       END { if (FNR != count) exit 1 }' "$2" "$1" ||
    die "$1 differs from $2 by more than 1e-13" "compare them"
}

# run_examples FOLDER: runs the programs of examples/cpp that are in the folder.
run_examples() {
  local example
  for example in $examples; do
    # shellcheck disable=SC2046 # arguments
    "$1/$example" $([[ $example != engineer ]] || echo rk4 rkmk4) >"$1/$example.log"
    same_numbers "$1/$example.log" "tests/library/$example.txt"
  done
  # The error is thrown in the library and caught in the program.
  ! "$1/engineer" rkmk5 >/dev/null 2>"$1/engineer.err" || die "$1/engineer accepted a method that is none"
  expect_line "method: unknown name 'rkmk5'" "$1/engineer.err"
}

# names_of FILE: prints the unqualified names of the functions and variables that nm -C lists in the
# file.
names_of() {
  sed 's/^[^:]* twrench::/twrench::/; s/\[abi:[a-z0-9]*\]//; s/(.*//; s/.*:://; s/^~//' "$1" | sort -u
}

# check_exports PREFIX LOG: checks that the shared library exports only names that the headers
# declare, and that twrench.h includes all other headers. bad_input.cpp tries every function that a
# program can call with bad arguments.
check_exports() {
  local name private='Error|Propagator|component|momentum|quoted|root|set_start|method_names'
  nm -DC --defined-only "$1/lib/libtwrench-dynamics.so" | grep -v ' A ' >"$2"
  ! grep -v ' twrench::\|for twrench::' "$2" >&2 ||
    die "the shared library exports symbols that are not its own" "see src/dynamics.map"
  ! grep ' [VWu] ' "$2" | grep -v ' for twrench::' >&2 ||
    die "the shared library exports copies that others may replace" "see $2"
  while read -r name; do
    grep -rqw -- "$name" "$1/include/twrench" ||
      die "the shared library exports $name, which no header declares" "see src/dynamics.map"
  done < <(names_of "$2")
  while read -r name; do
    grep -qw -- "$name" tests/library/bad_input.cpp ||
      die "tests/library/bad_input.cpp does not try $name with bad arguments"
  done < <(grep -v '()' "$2" >"$2.arguments" && names_of "$2.arguments" | grep -vxE "$private")
  for name in "$1"/include/twrench/*/*.h; do
    grep -qF "<twrench/${name#"$1"/include/twrench/}>" "$1/include/twrench/twrench.h" ||
      die "twrench/twrench.h does not include $name"
  done
}

# check_interface LIBRARY: checks that the binary interface of the shared library equals that in
# packaging/abi: the exported functions, and the layout of the types that they use. The library must
# have debug information.
check_interface() {
  local now=build/library/dynamics.abi
  abidw --exported-interfaces-only --suppressions packaging/abi/suppressions.ini --headers-dir include \
    --drop-private-types --no-corpus-path --no-comp-dir-path --no-show-locs --no-parameter-names \
    --no-elf-needed --type-id-style hash "$1" | sed "s, path='[^']*/, path='," >"$now"
  abidiff packaging/abi/dynamics.abi "$now" ||
    die "the binary interface of the shared library has changed" \
      "restore it; or, where a new version may change it, copy $now to packaging/abi"
}

# use_sources FOLDER COMPILER SHARED WAY: builds and runs examples/cpp as a project that contains this
# one, by add_subdirectory or by FetchContent from this folder. Optimisation is off, to compile
# faster.
use_sources() {
  rm -rf "${1:?}"
  mkdir -p "$1"
  {
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(contains LANGUAGES CXX)' 'include(CTest)'
    if [[ $4 == add_subdirectory ]]; then
      echo "add_subdirectory($PWD twrench)"
    else
      printf '%s\n' 'include(FetchContent)' "FetchContent_Declare(twrench SOURCE_DIR $PWD)" \
        'FetchContent_MakeAvailable(twrench)'
    fi
    for example in $examples; do
      printf '%s\n' "add_executable($example $PWD/examples/cpp/$example.cpp)" \
        "target_link_libraries($example PRIVATE twrench::dynamics)"
    done
    # The program must not inherit the source folders or the flags of the library. shellcheck
    # disable=SC2016 # expanded by CMake
    printf '%s\n' 'get_target_property(folders twrench::dynamics INTERFACE_INCLUDE_DIRECTORIES)' \
      'get_target_property(options twrench::dynamics INTERFACE_COMPILE_OPTIONS)' \
      "if(folders MATCHES \"$PWD/src\" OR options)" '  message(FATAL_ERROR "${folders} ${options}")' 'endif()'
  } >"$1/CMakeLists.txt"
  cmake -S "$1" -B "$1/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$2" \
    -DBUILD_SHARED_LIBS="$3" -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 >/dev/null
  cmake --build "$1/build"
  run_examples "$1/build"
  [[ $(ctest --test-dir "$1/build" -N | tail -n 1) == "Total Tests: 0" ]] ||
    die "a project that contains the library gains its tests"
  cmake --install "$1/build" --prefix "$1/installed" >/dev/null
  [[ -z $(find "$1/installed" -type f 2>/dev/null) ]] || die "a project that contains the library installs it"
}

# find_component NAME FOLDER: configures a project in FOLDER that looks for a component of twrench.
find_component() {
  mkdir -p "$2"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(finds LANGUAGES CXX)' \
    "find_package(twrench REQUIRED COMPONENTS $1)" >"$2/CMakeLists.txt"
  cmake -S "$2" -B "$2/build" -DCMAKE_PREFIX_PATH="$build-installed"
}

compilers="g++ $(basename "$(command -v clang++ clang++-14 | head -n 1)")"
programs=$PWD/build/library/programs

# Prints the ways to compile programs, one compiler with its flags per line.
program_builds() {
  local compiler flags all
  all=(-O0 '-O2 -ffast-math' '-O2 -march=native' '-O2 -DEIGEN_MAX_ALIGN_BYTES=0')
  # Eigen rejects -mavx512f without -mfma.
  [[ $(uname -m) != x86_64 ]] || all+=('-O2 -mavx512f -mfma')
  read -ra compiler <<<"$compilers"
  for flags in "${!all[@]}"; do
    if [[ $mode == --quick ]]; then
      echo "${compiler[flags % 2]} ${all[flags]}"
    else
      printf '%s\n' "${compiler[@]/%/ ${all[flags]}}"
    fi
  done
}

# compile_programs: compiles the programs in each way. Both kinds of library have the same headers,
# so this runs once.
compile_programs() {
  rm -rf "$programs"
  # shellcheck disable=SC2016 # expanded by the shell that xargs starts
  program_builds | xargs -P "$(nproc)" -I{} bash -c 'build="{}" folder="$0/${build// /}"
    mkdir -p "$folder"
    for source in tests/library/consumer $(printf "examples/cpp/%s " $1); do
      $build -std=c++20 $(pkg-config --cflags twrench) -c "$source.cpp" -o "$folder/${source##*/}.o" || exit 255
    done' "$programs" "$examples"
}

# run_programs FOLDER [FLAGS]: links the programs with the library that pkg-config finds, and runs
# them; with FLAGS, only the programs compiled with those flags.
run_programs() {
  local build folder name
  while read -r build; do
    folder=$1/${build// /}
    mkdir -p "$folder"
    for name in consumer $examples; do
      # shellcheck disable=SC2046,SC2086 # the flags are words
      $build "$programs/${build// /}/$name.o" -o "$folder/$name" $(pkg-config --libs twrench)
    done
    # Whether this processor supports the instructions that the flags enable.
    [[ $build != *-mavx512f* ]] || grep -qw avx512f /proc/cpuinfo || continue
    "$folder/consumer" >"$folder/consumer.log" 2>&1 || die "a program compiled by $build got wrong results" \
      "it says: $(tail -n 3 "$folder/consumer.log")"
    run_examples "$folder"
  done < <(program_builds | grep -- "${2:-}\$")
}

declare -A users=([OFF]=$compilers [ON]=$compilers)
[[ $mode != --quick ]] || users=([OFF]=${compilers% *} [ON]=${compilers#* })
for shared in OFF ON; do
  say "the library of the dynamics, shared: $shared"
  build=$PWD/build/library/shared-$shared
  rm -rf "$build-installed" "$build-user"
  # The sources of the shared library are compiled separately.
  testing=OFF unity=OFF
  [[ $shared == ON ]] || unity=ON
  [[ $shared == ON || $mode == --quick ]] || testing=ON
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTWRENCH_RENDER=OFF \
    -DBUILD_SHARED_LIBS=$shared -DBUILD_TESTING=$testing \
    -DCMAKE_UNITY_BUILD=$unity -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
    -DCMAKE_INSTALL_PREFIX="$build-installed" -DCMAKE_INSTALL_LIBDIR=lib >/dev/null
  cmake --build "$build"
  [[ $testing == OFF ]] || ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)"
  cmake --install "$build" >/dev/null
  [[ -s $build-installed/share/doc/twrench/LICENSE ]] ||
    die "the licence was not installed" "see $build-installed"

  export PKG_CONFIG_PATH=$build-installed/lib/pkgconfig LD_LIBRARY_PATH=$build-installed/lib
  for compiler in ${users[$shared]}; do
    cmake -S examples/cpp -B "$build-user/$compiler" -G Ninja -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$build-installed" >/dev/null
    cmake --build "$build-user/$compiler"
    run_examples "$build-user/$compiler"
  done

  [[ $shared == ON ]] || compile_programs
  ! nm -C "$programs"/*/*.o | grep -E ' [^U] (vtable|typeinfo) for twrench' >&2 ||
    die "programs have copies of the library's vtables" "each class needs a virtual function in a source"
  run_programs "$build-user/programs"
  if [[ $shared == ON ]]; then
    check_exports "$build-installed" "$build-user/exports.log"
  else
    ! nm -C "$build-installed/lib/libtwrench-dynamics.a" | grep ' U fmt::' >&2 ||
      die "the static library needs fmt to be linked"
  fi
  # shellcheck disable=SC2046 # the flags are words
  c++ -std=c++20 tests/library/bad_input.cpp -o "$build-user/bad_input" $(pkg-config --cflags --libs twrench)
  "$build-user/bad_input" >"$build-user/bad_input.log" ||
    die "bad input was not rejected as documented" "it says: $(tail -n 3 "$build-user/bad_input.log")"

  if find_component render "$build-user/none" >"$build-user/none.log" 2>&1; then
    die "a component that is not there was found" "see $build-user/none.log"
  fi
  expect_line "twrench has no component 'render'; it has: dynamics" "$build-user/none.log"
done

say "the library in projects that contain it"
read -r gcc clang <<<"$compilers"
contained=("$gcc ON add_subdirectory")
if [[ $mode == --quick ]]; then
  contained+=("$clang OFF FetchContent")
else
  # Each compiler with each linkage, each compiler in each way, and each linkage in each way.
  contained+=("$gcc OFF FetchContent" "$clang OFF add_subdirectory" "$clang ON FetchContent")
fi
for project in "${contained[@]}"; do
  read -r compiler shared way <<<"$project"
  use_sources "$PWD/build/library/contained/$compiler-$shared" "$compiler" "$shared" "$way" </dev/null
done

say "the binary interface of the shared library"
if [[ $(dpkg --print-architecture 2>/dev/null)-$(g++ -dumpversion) == amd64-12 ]]; then
  check_interface build/library/contained/g++-ON/build/twrench/src/libtwrench-dynamics.so
else
  echo "not compared: packaging/abi is of GCC 12 on amd64"
fi

say "the library compiled for this processor, in programs that are not"
build=$PWD/build/library/native
rm -rf "$build-installed"
# Little is inlined at -O1, so that more of Eigen's functions are shared with the program.
cmake -S . -B "$build" -G Ninja -DTWRENCH_RENDER=OFF -DBUILD_TESTING=OFF -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS='-march=native -w' -DCMAKE_CXX_FLAGS_RELEASE='-O1 -DNDEBUG' \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
  -DCMAKE_INSTALL_PREFIX="$build-installed" -DCMAKE_INSTALL_LIBDIR=lib >/dev/null
cmake --build "$build"
cmake --install "$build" >/dev/null
export PKG_CONFIG_PATH=$build-installed/lib/pkgconfig
run_programs "$build/programs" '-O0'
run_programs "$build/programs" '-O2 -ffast-math'
