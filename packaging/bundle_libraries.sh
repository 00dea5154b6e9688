#!/usr/bin/env bash
# bundle_libraries.sh PACKAGE: completes the folder of the Python package for a wheel. Renames its libraries,
# so that the libraries of other modules cannot replace them in a process, and adds the licences of the
# Debian packages that they are from. Needs patchelf.
set -euo pipefail

libraries=$1/libraries
for file in "$libraries"/*.so*; do
  package=$(dpkg-query --search "*/${file##*/}" | sed -n '1s/:.*//p')
  cp --dereference "/usr/share/doc/$package/copyright" "$libraries/$package.copyright"
done
names=() renamed=()
for file in "$libraries"/*.so*; do
  name=${file##*/}
  names+=("$name")
  renamed+=(--replace-needed "$name" "twrench-$name")
  mv "$file" "$libraries/twrench-$name"
done
for name in "${names[@]}"; do
  # patchelf 0.14 sets a wrong name if it does both in one call.
  patchelf --set-soname "twrench-$name" "$libraries/twrench-$name"
  patchelf "${renamed[@]}" "$libraries/twrench-$name"
done
patchelf "${renamed[@]}" "$1"/_native.*.so
