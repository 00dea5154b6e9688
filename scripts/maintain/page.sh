#!/usr/bin/env bash
# Builds build/page/page.html, the template of `twrench page`: the motion's C++ as WebAssembly, and the
# scripts and styles of web/ in one file. Each build of the program embeds it if it is there.
#   page.sh                builds it, and the program with it
#   page.sh --template     builds it alone
#   page.sh --check        builds it alone, and checks the types of the scripts
#   page.sh --serve [SCENE]  builds it whenever a file of web/ changes, and serves a page of the scene
#   page.sh --if-possible  builds it alone if its packages are installed; otherwise does the same as --current
#   page.sh --current      builds nothing, but removes it if its sources have changed since it was built
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
mode=${1-}
case $mode in
  '' | --template | --check | --serve | --if-possible | --current) ;;
  *)
    sed -n '/^# /s///p; /^set/q' "$0"
    [[ $mode == --help ]] && exit 0 || exit 2
    ;;
esac
out=$PWD/build/page

# Prints the version of a Clang whose libraries for WebAssembly are installed.
clang_version() {
  local version
  for version in 19 22 21 20 18; do
    command -v "clang++-$version" >/dev/null && command -v "wasm-ld-$version" >/dev/null || continue
    [[ ! -e /usr/lib/llvm-$version/lib/wasm32-wasi/libc++abi.a ]] || { echo "$version" && return; }
  done
  return 1
}

# Whether all programs and libraries that build the page are installed.
is_possible() {
  clang_version >/dev/null && command -v esbuild >/dev/null && command -v zopfli >/dev/null &&
    command -v openssl >/dev/null
}

# The sources of the page's core, including those in web/core.
core_sources() {
  printf 'src/%s.cpp\n' base/{color,error,require,words} math/{elliptic,so3} body/{dimensions,equimomental,mass_properties,shape} \
    body/triangle_mesh \
    motion/{diagnostics,energy_contours,error,exact,exact_samples,exact_solution,free_body,interior_series,method,polhode,propagator,rotating_frame} \
    motion/{recorded_motion,reference_motion,series_steps,stability,stepper,taylor,trajectory} study/{flip_search,reference} \
    scene/{limits,prediction,reference_frame,scene,speed_curve} timeline/{camera_move,frame_change,tilting_torque,timeline,tip_forces} \
    picture/space/camera picture/body/{body_model,body_uniforms,bounding_radius,floor_plane,half_turn,intersections,mark,mesh,shadow_balls} \
    picture/look/{emphasis,force_style,material,sky,studio,theme} \
    picture/compose/{camera_path,label} \
    picture/overlay/{axis_tip,body_overlay,draw_list,draw_list_arrow,draw_list_line,fixed_stars,force_arrows,torque_arcs,track,trail_point}
  printf '%s\n' src/body/shapes/*.cpp src/picture/shapes/*.cpp src/picture/views/*.cpp
  printf 'web/core/%s.cpp\n' bindings integrated_motion page_views pictures platform method_run surfaces
}

# Whether build/page/core.wasm is newer than all of its sources.
core_is_current() {
  [[ -e $out/core.wasm && -z $(find src/{base,math,body,motion,study,recording/conventions,scene,timeline,picture} include web/core \
    scripts/maintain/page.sh -newer "$out/core.wasm" -type f ! -name '*.js' -print -quit) ]]
}

# Whether build/page/page.html is newer than its other sources.
template_is_current() {
  [[ -e $out/page.html && ! $out/page.html -ot $out/core.wasm &&
    -z $(find web shaders scripts/maintain/page.sh -newer "$out/page.html" -type f -print -quit) ]]
}

# build_core: builds build/page/core.wasm, unless it is current.
build_core() {
  ! core_is_current || return 0
  local version
  version=$(clang_version) || die "there is no Clang that makes WebAssembly" "scripts/maintain/setup.sh page"
  say "compiling the motion to WebAssembly with Clang $version"
  # Only the headers of these libraries: the system's folder also has those of its C library.
  mkdir -p "$out/include"
  ln -sfn /usr/include/{boost,fmt,glm} "$out/include"
  # Boost's error messages would pull in the locales, and none can occur.
  local errors
  printf -v errors -- '-DBOOST_MATH_%s_ERROR_POLICY=ignore_error ' DOMAIN POLE OVERFLOW EVALUATION \
    ROUNDING INDETERMINATE_RESULT
  # shellcheck disable=SC2206 # words
  local flags=(--target=wasm32-wasi -std=c++20 -Os -fexceptions -fvisibility=hidden
    -ffunction-sections -fdata-sections -ffp-contract=off -DNDEBUG
    -DFMT_HEADER_ONLY -DFMT_STATIC_THOUSANDS_SEPARATOR=32 $errors
    -Iweb/core/shim -Iweb/core -Isrc -Iinclude -isystem "$out/include" -isystem /usr/include/eigen3)
  # A unity build of two files, for two processors.
  core_sources | awk -v out="$out" -v root="$PWD" \
    '{ print "#include \"" root "/" $0 "\"" > (out "/unity" (NR % 3 == 0) ".cpp") }'
  local part jobs=()
  for part in 0 1; do
    "clang++-$version" "${flags[@]}" -c "$out/unity$part.cpp" -o "$out/unity$part.o" &
    jobs+=($!)
  done
  wait "${jobs[0]}" && wait "${jobs[1]}" || die "the motion could not be compiled to WebAssembly"
  # Without compressed relocations, each address takes five bytes.
  "clang++-$version" --target=wasm32-wasi -mexec-model=reactor \
    -Wl,--strip-all -Wl,--gc-sections -Wl,--compress-relocations \
    "$out"/unity[01].o -o "$out/core.new"
  zopfli -c "$out/core.new" | base64 -w 0 >"$out/core.base64"
  # Last, so that an interrupted build is repeated.
  mv "$out/core.new" "$out/core.wasm"
}

# build_template: builds build/page/page.html, unless it is current. The program inserts a scene into it.
build_template() {
  ! template_is_current || return 0
  # The page contains the text of the shaders: without comments and indents it is 10 kB smaller.
  rm -rf "$out/source"
  mkdir -p "$out/source/shaders"
  cp -r web "$out/source"
  local shader
  for shader in shaders/*; do
    sed -E 's,[[:space:]]*//.*,,; s/^[[:space:]]+//; /^$/d' "$shader" >"$out/source/$shader"
  done
  esbuild "$out/source/web/main.js" --bundle --format=esm --target=es2022 --minify --charset=utf8 \
    --loader:.vert=text --loader:.frag=text --loader:.glsl=text --log-level=warning \
    --legal-comments=none --outfile="$out/script.js"
  zopfli -c web/article/article.json | base64 -w 0 >"$out/article-data.base64"
  esbuild web/style.css --bundle --minify --log-level=warning --outfile="$out/style.css"
  # The policy allows an inline script by the hash of the text between its tags.
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
    function put_data(id) {
      print "<script type=\"application/octet-stream;base64\" id=\"" id "\">"; put(id ".base64"); print "</script>"
    }
    /<!-- twrench:core -->/ { put_data("core"); next }
    /<!-- twrench:article -->/ { put_data("article-data"); next }
    /<!-- twrench:script -->/ { print "<script type=\"module\">"; put("script.js"); print "</script>"; next }
    { print }' web/index.html >"$out/page.html.new"
  mv "$out/page.html.new" "$out/page.html"
}

# check_types: checks the types in the comments of the scripts.
check_types() {
  mkdir -p "$out/npm"
  # npm writes the second file when it has installed everything.
  if ! cmp -s web/package-lock.json "$out/npm/package-lock.json" ||
    [[ ! -e $out/npm/node_modules/.package-lock.json ]]; then
    cp web/{package.json,package-lock.json,.npmrc} "$out/npm"
    npm ci --prefix "$out/npm" --ignore-scripts --loglevel=error >&2
  fi
  "$out/npm/node_modules/.bin/tsc" --noEmit -p web
}

serve() {
  local scene=${1-dzhanibekov} program=build/release/bin/twrench port=8000
  scripts/maintain/build.sh release twrench
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

# remove_old: removes a template whose sources have changed, so that no program contains an old page.
remove_old() {
  [[ -e $out/page.html ]] || return 0
  ! { core_is_current && template_is_current; } || return 0
  require_writable build/page
  rm "$out/page.html"
  say "note: the page is older than its sources, so the program is built without it; scripts/maintain/page.sh adds it"
}

if [[ $mode == --current ]]; then
  remove_old
  exit 0
elif [[ $mode == --if-possible ]] && ! is_possible; then
  [[ -e $out/page.html ]] || say "note: the program is built without its page; scripts/maintain/page.sh adds it"
  remove_old
  exit 0
fi
case $mode in
  --if-possible) ;;
  --template) scripts/maintain/setup.sh page ;;
  --check) scripts/maintain/setup.sh page node ;;
  *) scripts/maintain/setup.sh render page ;;
esac
{ core_is_current && template_is_current; } || require_writable build/page
[[ $mode != --check ]] || check_types
[[ $mode != --serve ]] || serve "${@:2}"
build_core
build_template
[[ $mode != --check ]] || say "$out/page.html: $(stat --format=%s "$out/page.html") bytes"
[[ -n $mode ]] || scripts/maintain/build.sh release twrench
