#!/usr/bin/env bash
# library.sh: builds the library of the dynamics alone, static and shared, and tests it; installs it
# to a folder of its own; and builds and runs examples/cpp against what was installed, through
# find_package and through pkg-config. It also links tests/library/consumer.cpp, compiled with other
# flags than the library, and tests/library/bad_input.cpp. Projects that contain the sources build the
# examples, too, with g++ and with clang++.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
scripts/setup.sh test

# expect_line TEXT FILE
expect_line() {
  grep -qF -- "$1" "$2" || die "$2 does not say '$1'" "it says: $(tail -n 3 "$2")"
}

# run_examples FOLDER: runs the programs of examples/cpp that are in the folder.
run_examples() {
  "$1/flip_time" >"$1/flip_time.log"
  expect_line "integrated  11.815363 s" "$1/flip_time.log"
  expect_line "exact       11.815363 s" "$1/flip_time.log"
  "$1/order" rkmk4 >"$1/order.log"
  expect_line "mass 252.584 g" "$1/order.log"
  expect_line "order 3.97" "$1/order.log"
  # The error is thrown in the library and caught in the program.
  ! "$1/order" rkmk5 >/dev/null 2>"$1/order.err" || die "$1/order accepted a method that is none"
  expect_line "method: unknown name 'rkmk5'" "$1/order.err"
}

# check_exports PREFIX LOG: the shared library exports what the headers declare, and nothing else;
# twrench.h includes all other headers.
check_exports() {
  local name
  nm -DC --defined-only "$1/lib/libtwrench-dynamics.so" | grep -v ' A ' >"$2"
  ! grep -v ' twrench::\|for twrench::' "$2" >&2 ||
    die "the shared library exports symbols that are not its own" "see src/dynamics.map"
  ! grep ' [VWu] ' "$2" | grep -v ' for twrench::' >&2 ||
    die "the shared library exports copies that others may replace" "see $2"
  while read -r name; do
    grep -rqw -- "$name" "$1/include/twrench" ||
      die "the shared library exports $name, which no header declares" "see src/dynamics.map"
  done < <(sed 's/^[^:]* twrench::/twrench::/; s/\[abi:[a-z0-9]*\]//; s/(.*//; s/.*:://; s/^~//' "$2" | sort -u)
  for name in "$1"/include/twrench/*/*.h; do
    [[ $name != */math/elliptic.h ]] || continue # no part of the interface
    grep -qF "<twrench/${name#"$1"/include/twrench/}>" "$1/include/twrench/twrench.h" ||
      die "twrench/twrench.h does not include $name"
  done
}

# use_sources FOLDER COMPILER SHARED: builds and runs examples/cpp as a project that contains this one,
# by add_subdirectory and by FetchContent from this folder.
use_sources() {
  local way
  for way in add_subdirectory FetchContent; do
    rm -rf "${1:?}/$way"
    mkdir -p "$1/$way"
    {
      printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(contains LANGUAGES CXX)' 'include(CTest)'
      if [[ $way == add_subdirectory ]]; then
        echo "add_subdirectory($PWD twrench)"
      else
        printf '%s\n' 'include(FetchContent)' "FetchContent_Declare(twrench SOURCE_DIR $PWD)" \
          'FetchContent_MakeAvailable(twrench)'
      fi
      for example in flip_time order; do
        printf '%s\n' "add_executable($example $PWD/examples/cpp/$example.cpp)" \
          "target_link_libraries($example PRIVATE twrench::dynamics)"
      done
      # No folder of the library's sources, and none of its flags, is for the program.
      # shellcheck disable=SC2016 # expanded by CMake
      printf '%s\n' 'get_target_property(folders twrench::dynamics INTERFACE_INCLUDE_DIRECTORIES)' \
        'get_target_property(options twrench::dynamics INTERFACE_COMPILE_OPTIONS)' \
        "if(folders MATCHES \"$PWD/src\" OR options)" '  message(FATAL_ERROR "${folders} ${options}")' 'endif()'
    } >"$1/$way/CMakeLists.txt"
    cmake -S "$1/$way" -B "$1/$way/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$2" \
      -DBUILD_SHARED_LIBS="$3" -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 >/dev/null
    cmake --build "$1/$way/build"
    run_examples "$1/$way/build"
    [[ $(ctest --test-dir "$1/$way/build" -N | tail -n 1) == "Total Tests: 0" ]] ||
      die "a project that contains the library gains its tests"
    cmake --install "$1/$way/build" --prefix "$1/$way/installed" >/dev/null
    [[ -z $(find "$1/$way/installed" -type f 2>/dev/null) ]] ||
      die "a project that contains the library installs it"
  done
}

# find_component NAME FOLDER: a project in FOLDER that looks for a component of twrench.
find_component() {
  mkdir -p "$2"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(finds LANGUAGES CXX)' \
    "find_package(twrench REQUIRED COMPONENTS $1)" >"$2/CMakeLists.txt"
  cmake -S "$2" -B "$2/build" -DCMAKE_PREFIX_PATH="$build-installed"
}

consumers=$PWD/build/library/consumers

# Prints the flags with which programs are compiled, one set a line.
consumer_flags() {
  printf '%s\n' '-O0' '-O2 -ffast-math' '-O2 -DEIGEN_DONT_VECTORIZE' '-O2 -DEIGEN_MAX_ALIGN_BYTES=0' \
    '-O2 -march=native' '-O0 -march=native -ffast-math'
  # Eigen rejects -mavx512f without -mfma.
  [[ $(uname -m) != x86_64 ]] || printf '%s\n' '-O2 -mavx2 -mfma' '-O2 -mavx512f -mfma'
}

# compile_consumers: compiles the program with each set of flags. Both kinds of library have the same
# headers, so this is done once.
compile_consumers() {
  rm -rf "$consumers"
  mkdir -p "$consumers"
  # shellcheck disable=SC2016 # expanded by the shell that xargs starts
  consumer_flags | xargs -P "$(nproc)" -I{} bash -c 'flags="{}"
    c++ -std=c++20 $flags $(pkg-config --cflags twrench) -c tests/library/consumer.cpp -o "$0/${flags// /}.o" ||
      exit 255' "$consumers"
}

# can_run FLAGS: whether this processor has the registers that the flags ask for.
can_run() {
  local name
  for name in avx2 avx512f; do
    [[ $1 != *-m$name* ]] || grep -qw "$name" /proc/cpuinfo || return 1
  done
}

# run_consumers FOLDER [FLAGS]: links the programs with the library that pkg-config finds, and runs
# them; with FLAGS, only the program that was compiled with them.
run_consumers() {
  local flags program
  while read -r flags; do
    program=$1/consumer${flags// /}
    # shellcheck disable=SC2046,SC2086 # the flags are words
    c++ $flags "$consumers/${flags// /}.o" -o "$program" $(pkg-config --libs twrench)
    can_run "$flags" || continue
    "$program" >"$program.log" 2>&1 || die "a program compiled with $flags got wrong results" \
      "it says: $(tail -n 3 "$program.log")"
  done < <(if (($# > 1)); then echo "$2"; else consumer_flags; fi)
}

for shared in OFF ON; do
  say "the library of the dynamics, shared: $shared"
  build=$PWD/build/library/shared-$shared
  rm -rf "$build-installed" "$build-user"
  # Where the tests are built, sources are compiled sixteen at a time; otherwise each alone.
  testing=OFF
  [[ $shared == ON ]] || testing=ON
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTWRENCH_RENDER=OFF \
    -DBUILD_SHARED_LIBS=$shared -DBUILD_TESTING=$testing \
    -DCMAKE_UNITY_BUILD=$testing -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 \
    -DCMAKE_INSTALL_PREFIX="$build-installed" -DCMAKE_INSTALL_LIBDIR=lib >/dev/null
  cmake --build "$build"
  [[ $testing == OFF ]] || ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)"
  cmake --install "$build" >/dev/null
  [[ -s $build-installed/share/doc/twrench/LICENSE ]] ||
    die "the licence was not installed" "see $build-installed"

  cmake -S examples/cpp -B "$build-user" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$build-installed" >/dev/null
  cmake --build "$build-user"
  run_examples "$build-user"

  export PKG_CONFIG_PATH=$build-installed/lib/pkgconfig LD_LIBRARY_PATH=$build-installed/lib
  mkdir -p "$build-user/by_pkg_config"
  for example in flip_time order; do
    # shellcheck disable=SC2046 # the flags are words
    c++ -std=c++20 "examples/cpp/$example.cpp" -o "$build-user/by_pkg_config/$example" \
      $(pkg-config --cflags --libs twrench)
  done
  run_examples "$build-user/by_pkg_config"

  [[ $shared == ON ]] || compile_consumers
  ! nm -C "$consumers"/*.o | grep -E ' [^U] (vtable|typeinfo) for twrench' >&2 ||
    die "programs have copies of the library's vtables" "each class needs a virtual function in a source"
  mkdir -p "$build-user/consumers"
  run_consumers "$build-user/consumers"
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
use_sources "$PWD/build/library/contained/gcc" c++ OFF
use_sources "$PWD/build/library/contained/clang" "$(command -v clang++ clang++-14 | head -n 1)" ON

say "the library compiled for this processor, in programs that are not"
build=$PWD/build/library/native
rm -rf "$build-installed"
# Little is inlined at -O1, so that more of Eigen's functions are shared with the program.
cmake -S . -B "$build" -G Ninja -DTWRENCH_RENDER=OFF -DBUILD_TESTING=OFF -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS='-march=native -w' -DCMAKE_CXX_FLAGS_RELEASE='-O1 -DNDEBUG' \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 \
  -DCMAKE_INSTALL_PREFIX="$build-installed" -DCMAKE_INSTALL_LIBDIR=lib >/dev/null
cmake --build "$build"
cmake --install "$build" >/dev/null
export PKG_CONFIG_PATH=$build-installed/lib/pkgconfig
run_consumers "$build" '-O0'
run_consumers "$build" '-O2 -ffast-math'
