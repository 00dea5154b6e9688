#!/usr/bin/env bash
# Updates tests/robot/mjcf/reference.json, the mass properties that MuJoCo computes for the MJCF files
# beside it, with the version of MuJoCo that its package.json names. Run it after changes of these files.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
scripts/maintain/setup.sh node
source scripts/maintain/common.sh
require_writable build/mujoco

# npm installs programs beside the scripts that use them.
cp tests/robot/mjcf/{*.mjs,package.json,package-lock.json,.npmrc} build/mujoco
npm ci --prefix build/mujoco --ignore-scripts --loglevel=error
node build/mujoco/reference.mjs tests/robot/mjcf >build/mujoco/reference.json
mv build/mujoco/reference.json tests/robot/mjcf/reference.json
