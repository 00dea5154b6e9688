#!/usr/bin/env bash
# reproduce_packages.sh: makes the packages of the committed sources a second time, in another folder
# and with another umask, time zone, locale and home, and compares them byte by byte with the packages
# that scripts/package.sh made in out/packages.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
compgen -G "out/packages/*.deb" >/dev/null || die "out/packages has no packages" "make them: scripts/package.sh"

other=$(mktemp --directory)
trap 'rm -rf "$other"' EXIT
git clone --quiet . "$other/elsewhere"
(umask 077 && env -i HOME="$other" PATH="$PATH" TZ=Asia/Tokyo LC_ALL=C CCACHE_DISABLE=1 \
  "$other/elsewhere/scripts/package.sh" >/dev/null)
for package in out/packages/*.deb; do
  cmp "$package" "$other/elsewhere/$package" || die "$package differs from one build to the next" \
    "diffoscope shows where, once the second build is kept: remove the trap of this script"
done
say "both builds of the packages have the same bytes"
