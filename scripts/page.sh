#!/usr/bin/env bash
# Builds what `twrench page` writes pages from, build/page/page.html: the motion's C++ as WebAssembly,
# and the scripts and styles of web/ in one file. The next build of the program has it in.
#   page.sh          builds it
#   page.sh --check  checks the types of the scripts as well
#   page.sh --serve [SCENE]  builds it whenever a file of web/ changes, and serves a page of it
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
mode=${1-}
if [[ -n $mode && $mode != --check && $mode != --serve ]]; then
  sed -n '/^# /s///p; /^set/q' "$0"
  [[ $mode == --help ]] && exit 0 || exit 2
fi
scripts/setup.sh page
require_writable build/page
out=$PWD/build/page

# Prints the version of a Clang whose libraries for WebAssembly are installed.
clang_version() {
  local version
  for version in 19 22 21 20 18; do
    command -v "clang++-$version" >/dev/null && command -v "wasm-ld-$version" >/dev/null || continue
    [[ ! -e /usr/lib/llvm-$version/lib/wasm32-wasi/libc++abi.a ]] || { echo "$version" && return; }
  done
  die "there is no Clang that makes WebAssembly" "scripts/setup.sh page"
}

# The sources that the page needs. bindings.cpp is compiled with them, as are those beside it.
core_sources() {
  printf 'src/%s.cpp\n' base/{color,error,nearest,require} math/{elliptic,so3} body/{dimensions,equimomental,mass_properties,shape} \
    body/triangle_mesh \
    motion/{diagnostics,error,exact,exact_samples,free_body,method,polhode,propagator,rotating_frame} \
    motion/{stability,stepper,taylor,trajectory} study/flip_search \
    scene/{limits,prediction,scene,speed_curve} timeline/{reference_frame,timeline} \
    picture/space/camera picture/body/{body_model,body_uniforms,floor_plane,mesh,shadow_balls} \
    picture/look/{emphasis,force_style,material,studio,theme} \
    picture/compose/{camera_path,label} \
    picture/overlay/{body_overlay,draw_list,draw_list_arrow,draw_list_line,fixed_stars,force_arrows,trail_point}
  printf '%s\n' src/body/shapes/*.cpp src/picture/shapes/*.cpp src/picture/views/*.cpp
  printf 'web/core/%s.cpp\n' bindings page_views pictures platform recorded_run stars surfaces
}

# build_core: build/page/core.wasm, unless it is newer than all that it is made of.
build_core() {
  local newer
  newer=$(find src/{base,math,body,motion,study,scene,timeline,picture} include web/core scripts/page.sh \
    -newer "$out/core.wasm" -type f ! -name '*.js' -print -quit 2>/dev/null || echo all)
  [[ -n $newer ]] || return 0
  local version
  version=$(clang_version)
  say "compiling the motion to WebAssembly with Clang $version"
  # Headers alone, from a folder that has those of the system beside none of the C library's.
  mkdir -p "$out/include"
  ln -sfn /usr/include/{boost,fmt,glm} "$out/include"
  # What cannot fail needs no message, and Boost's draw in the locales.
  local errors
  printf -v errors -- '-DBOOST_MATH_%s_ERROR_POLICY=ignore_error ' DOMAIN POLE OVERFLOW EVALUATION \
    ROUNDING INDETERMINATE_RESULT
  # shellcheck disable=SC2206 # words
  local flags=(--target=wasm32-wasi -std=c++20 -O2 -fexceptions -fvisibility=hidden
    -ffunction-sections -fdata-sections -ffp-contract=off -DNDEBUG
    -DFMT_HEADER_ONLY -DFMT_STATIC_THOUSANDS_SEPARATOR=32 $errors
    -Iweb/core/shim -Iweb/core -Isrc -Iinclude -isystem "$out/include" -isystem /usr/include/eigen3)
  # As a unity build: two files, for two processors.
  core_sources | awk -v out="$out" -v root="$PWD" \
    '{ print "#include \"" root "/" $0 "\"" > (out "/unity" (NR % 3 == 0) ".cpp") }'
  local part jobs=()
  for part in 0 1; do
    "clang++-$version" "${flags[@]}" -c "$out/unity$part.cpp" -o "$out/unity$part.o" &
    jobs+=($!)
  done
  wait "${jobs[0]}" && wait "${jobs[1]}" || die "the motion could not be compiled to WebAssembly"
  "clang++-$version" --target=wasm32-wasi -mexec-model=reactor -Wl,--strip-all -Wl,--gc-sections \
    "$out"/unity[01].o -o "$out/core.wasm"
  gzip -9cn "$out/core.wasm" | base64 -w 0 >"$out/core.base64"
}

# build_template: build/page/page.html, in which the program puts a scene.
build_template() {
  esbuild web/main.js --bundle --format=esm --target=es2022 --minify --charset=utf8 \
    --loader:.vert=text --loader:.frag=text --loader:.glsl=text --log-level=warning \
    --legal-comments=none --outfile="$out/script.js"
  esbuild web/style.css --bundle --minify --log-level=warning --outfile="$out/style.css"
  # An inline script is allowed by its hash; what stands between the tags counts.
  local hash
  hash=$({ printf '\n' && cat "$out/script.js"; } | openssl dgst -sha256 -binary | base64)
  awk -v out="$out" -v hash="$hash" '
    function put(file, line) { while ((getline line < (out "/" file)) > 0) print line; close(out "/" file) }
    /<!-- twrench:policy -->/ {
      print "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src '\''none'\''; " \
        "script-src '\''sha256-" hash "'\'' '\''wasm-unsafe-eval'\''; style-src '\''unsafe-inline'\''; " \
        "img-src data: blob:; base-uri '\''none'\''; form-action '\''none'\''\">"
      next
    }
    /<!-- twrench:style -->/ { print "<style>"; put("style.css"); print "</style>"; next }
    /<!-- twrench:core -->/ {
      print "<script type=\"application/octet-stream;base64\" id=\"core\">"; put("core.base64")
      print "</script>"; next
    }
    /<!-- twrench:script -->/ { print "<script type=\"module\">"; put("script.js"); print "</script>"; next }
    { print }' web/index.html >"$out/page.html.new"
  mv "$out/page.html.new" "$out/page.html"
}

# check_types: as the comments of the scripts say them.
check_types() {
  # A Node.js that is not Debian's serves as well.
  command -v npm >/dev/null || scripts/setup.sh node
  mkdir -p "$out/npm"
  if ! cmp -s web/package-lock.json "$out/npm/package-lock.json" || [[ ! -d $out/npm/node_modules ]]; then
    cp web/{package.json,package-lock.json,.npmrc} "$out/npm"
    npm ci --prefix "$out/npm" --ignore-scripts --loglevel=error >&2
  fi
  "$out/npm/node_modules/.bin/tsc" --noEmit -p web
}

serve() {
  local scene=${1-dzhanibekov} program=build/release/bin/twrench port=8000
  scripts/build.sh release twrench
  mkdir -p "$out/site"
  python3 -m http.server --directory "$out/site" --bind 127.0.0.1 "$port" >/dev/null 2>&1 &
  # shellcheck disable=SC2064 # that process
  trap "kill $!" EXIT
  say "http://127.0.0.1:$port/ is a page of $scene; interrupt to end"
  while true; do
    if [[ -n $(find web -newer "$out/site/index.html" -type f -print -quit 2>/dev/null || echo all) ]]; then
      touch "$out/started"
      if build_core && build_template &&
        "$program" page "$scene" --template "$out/page.html" -o "$out/site/index.html"; then
        say "built; reload the page"
      fi
      touch -r "$out/started" "$out/site/index.html"
    fi
    sleep 1
  done
}

[[ $mode != --check ]] || check_types
[[ $mode != --serve ]] || serve "${@:2}"
build_core
build_template
say "$out/page.html: $(stat --format=%s "$out/page.html") bytes"
