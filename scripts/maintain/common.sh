# shellcheck shell=bash
# Messages, the version, and checks of writable folders. Other scripts source this file.

say() { printf 'twrench: %s\n' "$*" >&2; }

# The version and the date of the release, as CMakeLists.txt in the current folder has them.
project_version() { sed -nE 's/^project\(twrench VERSION ([0-9.]+).*/\1/p' CMakeLists.txt; }
release_date() { sed -nE 's/^set\(TWRENCH_RELEASE_DATE (.*)\)$/\1/p' CMakeLists.txt; }

die() {
  say "error: $1"
  shift
  (($# == 0)) || printf '  %s\n' "$@" >&2
  exit 1
}

# require_writable FOLDER: creates the folder if it is missing; exits if it is not writable.
require_writable() {
  local at=$PWD/$1 me owner
  mkdir -p "$1" 2>/dev/null && [[ -w $1 ]] && return
  until [[ -e $at ]]; do at=$(dirname "$at"); done
  me=$(id -un) owner=$(stat --format=%U "$at")
  if [[ $me == root || $me == "$owner" ]]; then
    die "$at is read-only" "copy these sources to a writable folder"
  fi
  die "$at belongs to $owner, and $me may not write there" \
    "copy these sources to a folder of your own, or change its owner: sudo chown -R $me '$at'"
}
