#!/usr/bin/env bash
# library.sh: builds the library of the dynamics alone, static and shared, and tests it; installs it
# to a folder of its own; and builds and runs tests/library against what was installed, through
# find_package and through pkg-config.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
scripts/setup.sh test

# expect_line TEXT FILE
expect_line() {
  grep -qF -- "$1" "$2" || die "$2 does not say '$1'" "it says: $(tail -n 3 "$2")"
}

for shared in OFF ON; do
  say "the library of the dynamics, shared: $shared"
  build=$PWD/build/library/shared-$shared
  rm -rf "$build-installed" "$build-user"
  testing=OFF
  [[ $shared == ON ]] || testing=ON
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTWRENCH_RENDER=OFF \
    -DBUILD_SHARED_LIBS=$shared -DBUILD_TESTING=$testing \
    -DCMAKE_INSTALL_PREFIX="$build-installed" -DCMAKE_INSTALL_LIBDIR=lib >/dev/null
  cmake --build "$build"
  [[ $testing == OFF ]] || ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)"
  cmake --install "$build" >/dev/null
  [[ -s $build-installed/share/doc/twrench/LICENSE ]] ||
    die "the licence was not installed" "see $build-installed"

  cmake -S tests/library -B "$build-user" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$build-installed" -DCOMPONENTS=dynamics >/dev/null
  cmake --build "$build-user"
  "$build-user/uses_twrench"

  export PKG_CONFIG_PATH=$build-installed/lib/pkgconfig LD_LIBRARY_PATH=$build-installed/lib
  # shellcheck disable=SC2046 # the flags are words
  c++ -std=c++20 tests/library/main.cpp -o "$build-user/by_pkg_config" \
    $(pkg-config --cflags --libs twrench)
  "$build-user/by_pkg_config"

  if cmake -S tests/library -B "$build-user/none" -DCMAKE_PREFIX_PATH="$build-installed" \
    -DCOMPONENTS=render >"$build-user/none.log" 2>&1; then
    die "a component that is not there was found" "see $build-user/none.log"
  fi
  expect_line "twrench has no component 'render'; it has: dynamics" "$build-user/none.log"
done
