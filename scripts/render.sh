#!/usr/bin/env bash
# The main command, which also works on a bare Debian or Ubuntu: installs missing dependencies, builds
# the program if it is out of date, then runs `twrench render` with the given arguments (default: the
# default scene). scripts/maintain/page.sh adds the template of `twrench page` to the program.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/maintain/setup.sh" render
"$root/scripts/maintain/page.sh" --current
"$root/scripts/maintain/build.sh" release twrench
exec "$root/build/release/bin/twrench" render "$@"
