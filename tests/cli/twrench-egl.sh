#!/bin/sh
# The program that TWRENCH_BINARY names, its frames drawn with EGL in software.
if [ "$1" = render ]; then
  shift
  exec "$TWRENCH_BINARY" render --backend egl --egl-device software "$@"
fi
exec "$TWRENCH_BINARY" "$@"
