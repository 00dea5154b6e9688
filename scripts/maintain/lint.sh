#!/usr/bin/env bash
# Checks our C++ sources against .clang-format and .clang-tidy (version 14 of both tools):
#   lint.sh format   lists lines with different formatting
#   lint.sh fix      reformats them
#   lint.sh tidy     installs clang-tidy and runs it on all sources; takes minutes
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folders=()
for folder in include src python examples tests bench web; do
  [[ ! -d $folder ]] || folders+=("$folder")
done
sources() { find "${folders[@]}" \( -name '*.h' -o -name '*.cpp' \) -print0 | sort -z; }

case "${1-}" in
  format)
    if ! command -v clang-format-14 >/dev/null; then
      echo "twrench: clang-format 14 is not installed: the formatting of the sources is not checked" >&2
      exit 0
    fi
    if ! sources | xargs -0 clang-format-14 --dry-run -Werror; then
      echo "twrench: error: some lines are formatted differently; run $0 fix to reformat them" >&2
      exit 1
    fi
    ;;
  fix) sources | xargs -0 clang-format-14 -i ;;
  tidy)
    scripts/maintain/setup.sh tidy
    # Makes the compile commands, one for each source, and the generated headers. clang does not
    # read GCC's precompiled headers.
    cmake --preset release -B build/tidy -DBUILD_TESTING=ON -DTWRENCH_TORTURE=ON -DCMAKE_UNITY_BUILD=OFF \
      -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
    # The pattern excludes generated sources, which are under build/.
    run-clang-tidy-14 -quiet -p build/tidy -j "$(nproc)" "^$(pwd -P)/(src|tests|bench)/"
    ;;
  *)
    echo "usage: $0 format|fix|tidy" >&2
    exit 2
    ;;
esac
