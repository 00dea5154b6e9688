# shellcheck shell=bash
# For scripts that compare programs, which source this file: reads their options, times commands, and
# reduces the times of several rounds to medians. $folder is removed at the end.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
times=$folder/times.txt

# read_options USAGE "$@": sets a variable for each option, such as frames for [--frames N] in USAGE.
read_options() {
  local usage=$1
  shift
  while (($#)); do
    [[ $# -gt 1 && $1 == --* && $usage == *"[$1 "* ]] || { echo "usage: $0 $usage" >&2; exit 2; }
    printf -v "${1#--}" %s "$2"
    shift 2
  done
}

# timed NAME FRAMES COMMAND...: adds a line with the wall and processor time per frame in ms.
timed() {
  local wall user system
  local TIMEFORMAT='%R %U %S'
  read -r wall user system < <({ time "${@:3}" >&2 || echo failed; } 2>&1 | tail -n 1)
  [[ $wall != failed ]] || { echo "$0: '$1' failed" >&2; exit 1; }
  awk -v name="$1" -v n="$2" -v w="$wall" -v c="$(awk "BEGIN { print $user + $system }")" \
    'BEGIN { printf "%s\t%.2f\t%.2f\n", name, 1e3 * w / n, 1e3 * c / n }' >>"$times"
}

# Prints a line for each name, in order of appearance, with the medians of its two times.
medians() {
  awk -F'\t' '
    function median(list, n,   v, i, j, t) {
      split(list, v, " ")
      for (i = 1; i <= n; ++i) for (j = i + 1; j <= n; ++j) if (v[j] + 0 < v[i] + 0) { t = v[i]; v[i] = v[j]; v[j] = t }
      return (v[int((n + 1) / 2)] + v[int(n / 2) + 1]) / 2
    }
    !($1 in count) { order[++rows] = $1 }
    { ++count[$1]; wall[$1] = wall[$1] " " $2; cpu[$1] = cpu[$1] " " $3 }
    END {
      for (i = 1; i <= rows; ++i) {
        name = order[i]
        printf "%s\t%.2f\t%.2f\n", name, median(wall[name], count[name]), median(cpu[name], count[name])
      }
    }' "$times"
}
