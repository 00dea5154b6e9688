#!/usr/bin/env bash
# library.sh: builds the library of the dynamics alone, static and shared, and tests it; installs it
# to a folder of its own; and builds and runs examples/cpp against what was installed, through
# find_package and through pkg-config. It also links tests/library/consumer.cpp, compiled with other
# flags than the library.
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
  mkdir -p "$build-user/consumers"
  run_consumers "$build-user/consumers"
  if [[ $shared == ON ]]; then
    nm -DC --defined-only "$build-installed/lib/libtwrench-dynamics.so" >"$build-user/exports.log"
    ! grep -v ' twrench::\|for twrench::' "$build-user/exports.log" >&2 ||
      die "the shared library exports symbols that are not its own" "see src/dynamics.map"
  fi

  if find_component render "$build-user/none" >"$build-user/none.log" 2>&1; then
    die "a component that is not there was found" "see $build-user/none.log"
  fi
  expect_line "twrench has no component 'render'; it has: dynamics" "$build-user/none.log"
done

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
