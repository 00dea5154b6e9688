#!/usr/bin/env bash
# library.sh: builds the library of the dynamics alone, static and shared, and tests it; installs it
# to a folder of its own; and builds and runs examples/cpp against what was installed, through
# find_package and through pkg-config.
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

  if find_component render "$build-user/none" >"$build-user/none.log" 2>&1; then
    die "a component that is not there was found" "see $build-user/none.log"
  fi
  expect_line "twrench has no component 'render'; it has: dynamics" "$build-user/none.log"
done
