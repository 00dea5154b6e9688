#!/usr/bin/env bash
# valgrind.sh [--quick] [PROGRAM...]: runs the tests that do not use OpenGL under valgrind's memcheck,
# which finds uninitialised values, unlike the sanitizers. Takes minutes; with
# --quick it runs only the tests that look for such values, which takes seconds.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
scripts/maintain/setup.sh coverage
# Excludes the slowest tests, and tests that fail under valgrind. Its vfork is a fork, so a missing
# program is reported only by the child's exit status 127; its long double has 64 bits.
left_out=-*OfTheLargest*:*WithoutEnd*
left_out+=:*ThatIsNotThere*:Encoder.MissingIsToldWithTheRemedy
left_out+=:ExactMotion.*ForRandomBodies:ExactMotion.*AfterAThousandTurns
left_out+=:*WhereverItIsCompressed
of_the_motion='*'
programs=(
  base_test system_test math_test body_test motion_test study_test plot_test scene_test timeline_test
  image_test canvas_test video_test
)
if [[ ${1-} == --quick ]]; then
  shift
  programs=(body_test scene_test image_test motion_test)
  # Of the motion tests, only the short ones.
  of_the_motion='*EveryMethod*:*VisitSteps*:ExactMotion.*:Trajectory.*:Diagnostics*:Polhode*:Method*'
  left_out+=:*EndsWhen*
fi
(($#)) && programs=("$@")
scripts/maintain/build.sh --tests release "${programs[@]}"
failed=()
for program in "${programs[@]}"; do
  echo "== $program"
  tests='*'
  [[ $program == motion_test ]] && tests=$of_the_motion
  valgrind --quiet --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite \
    "build/release/bin/$program" --gtest_brief=1 --gtest_filter="$tests$left_out" || failed+=("$program")
done
if ((${#failed[@]})); then
  echo "twrench: error: valgrind: not clean: ${failed[*]}" >&2
  exit 1
fi
