#!/usr/bin/env bash
# release.sh [--no-checks]: prepares the release of the version in CMakeLists.txt, in out/release: the
# archive of the sources, Debian's packages, and SHA256SUMS. Then it prints the remaining steps.
#
# It requires a clean checkout in which CITATION.cff and CHANGELOG.md have the version and the date of
# CMakeLists.txt, and it runs scripts/check.sh --all first, unless --no-checks is given. Archive and packages
# are reproducible: the same commit gives the same bytes on the same release of Debian.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
checks=yes
case ${1-} in
  '') ;;
  --no-checks) checks='' ;;
  *)
    sed -n '/^# /s///p; /^set/q' "$0"
    [[ $1 == --help ]] && exit 0 || exit 2
    ;;
esac

version=$(project_version)
date=$(release_date)
git rev-parse --verify --quiet HEAD >/dev/null || die "this is not a git checkout" "clone the repository"
[[ -z $(git status --porcelain) ]] || die "the checkout has changes that are not committed" \
  "commit them, or move them away: git stash --include-untracked"
grep -qx "version: $version" CITATION.cff && grep -qx "date-released: $date" CITATION.cff ||
  die "CITATION.cff lacks version $version of $date" "write both into it, as in CMakeLists.txt"
[[ $(grep -m 1 '^## ' CHANGELOG.md) == "## [$version] - $date" ]] ||
  die "the first section of CHANGELOG.md is not '## [$version] - $date'" \
    "give the section Unreleased this title, or increase the version in CMakeLists.txt"
! git rev-parse --quiet --verify "refs/tags/v$version" >/dev/null ||
  die "the tag v$version exists" "increase the version in CMakeLists.txt"

[[ -z $checks ]] || scripts/check.sh --all

release=out/release
rm -rf "$release"
require_writable "$release"
# Without the time of packing, which gzip would store.
git archive --format=tar --prefix="twrench-$version/" HEAD | gzip --no-name --best \
  >"$release/twrench-$version.tar.gz"
scripts/maintain/package.sh >/dev/null
cp out/packages/*.deb "$release"
(cd "$release" && sha256sum -- * >SHA256SUMS)
say "the files of $version:"
cat "$release/SHA256SUMS"
cat >&2 <<END
twrench: left to a maintainer:
  1. git tag --sign v$version -m "twrench $version" && git push origin v$version
  2. Publish a release of this tag with the files in $release and the section of CHANGELOG.md.
  3. Make the packages of the other releases of Debian: scripts/maintain/package.sh in each; in Debian 12 also the
     archive: scripts/maintain/package.sh --portable.
  4. Start a section "## [Unreleased]" in CHANGELOG.md.
END
