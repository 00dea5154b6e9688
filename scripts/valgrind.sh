#!/usr/bin/env bash
# valgrind.sh [PROGRAM...]: the tests of the core (all that is before OpenGL) under valgrind's
# memcheck, for what the sanitizers do not see: values that nothing has set. Takes minutes, and so
# is not among the checks of scripts/test.sh.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh coverage
programs=("$@")
((${#programs[@]})) || programs=(base_test math_test body_test scene_test image_test movie_test)
scripts/build.sh --tests release "${programs[@]}"
for program in "${programs[@]}"; do
  echo "== $program"
  # Not the longest; and not what valgrind does otherwise: a program that is not there.
  valgrind --quiet --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite \
    "build/release/bin/$program" --gtest_brief=1 --gtest_filter=-*OfTheLargest*:*WithoutEnd*:*ThatIsNotThere*
done
