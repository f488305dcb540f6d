# Sourced by samples/first-knot.sh and tests/run.sh: Debian packages, configure and build.
# shellcheck shell=bash disable=SC2034  # the lists are for who sources this

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# docs/dependencies.md says what each library is for.
build_packages=(
  g++ cmake ninja-build pkg-config
  libassimp-dev libboost-dev libcli11-dev libdeflate-dev libeigen3-dev libembree-dev libexpected-dev
  libfmt-dev libfreetype-dev libopenexr-dev libosmesa6-dev libpng-dev libpugixml-dev libsvgpp-dev
  libtbb-dev libtinyobjloader-dev libtomlplusplus-dev
  libzstd-dev nlohmann-json3-dev fonts-dejavu-core python3
)
# For the module for Python.
python_packages=(pybind11-dev python3-dev python3-numpy)
test_packages=(
  blender clang clang-format clang-tidy ffmpeg libcgal-dev libclang-14-dev libclang-rt-dev libdraco-dev
  libgmp-dev libgmock-dev libmeshoptimizer-dev libmpfr-dev libzfp-dev llvm-14-dev
  python3-numpy regina-normal-dev shellcheck xauth xvfb
)

# For tests/run.sh --all alone.
farm_packages=(slurm-wlm)
package_packages=(lintian mmdebstrap)

# For pages that play recordings in a browser; without them ribbon-play writes none. The second list
# drives those pages in tests.
page_packages=(emscripten xz-utils)
browser_packages=(chromium chromium-driver firefox-esr python3-selenium python3-wsproto
  xauth xdotool xvfb)

is_installed() {
  [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

# Can tests drive browsers? Says what is missing where not.
has_browsers() {
  type chromium chromedriver firefox-esr xdotool xvfb-run &>/dev/null &&
    /usr/bin/python3 -c 'import selenium, wsproto' 2>/dev/null && return
  echo "one of ${browser_packages[*]} is missing (the list browser_packages in .ci/setup.sh)" >&2
  return 1
}

# in_browser NAME SCRIPT...: a Python script that drives chromium or firefox. Firefox has WebGL only where
# it has a display. Chromium leaves its locks among the temporary files.
in_browser() {
  local display=() folder status=0
  [[ $1 != firefox ]] || display=(xvfb-run --auto-servernum --server-args='-screen 0 1280x1024x24')
  folder=$(mktemp -d)
  TMPDIR=$folder BROWSER=$1 PYTHONDONTWRITEBYTECODE=1 "${display[@]}" /usr/bin/python3 "${@:2}" || status=$?
  rm -rf "$folder"
  return "$status"
}

as_root() {
  if [[ $(id -u) -eq 0 ]]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "need root to run '$*'; run this as root or install sudo" >&2
    return 1
  fi
}

# Touches the network and asks for a password only when a package really is missing.
install_missing() {
  local package missing=()
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0
  echo "== Installing ${missing[*]}"
  as_root apt-get update --quiet
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
}

# Khronos' validator of glTF, which Debian does not have: into the build folder. Without a network its
# test is skipped.
install_gltf_validator() {
  local folder=$root/build/npm package=gltf-validator@2.0.0-dev.3.10
  [[ ! -d $folder/node_modules/gltf-validator ]] || return 0
  # Node.js of another maker brings its own npm, with which Debian's cannot be installed.
  command -v npm >/dev/null || install_missing nodejs npm || return 0
  echo "== Installing $package"
  npm install --prefix "$folder" --no-save --no-audit --no-fund "$package" || true
}

# fetch_newest_source PACKAGE APT_OPTION...: into the current folder. Of what a mirror lists it may miss
# some files, most often of a security update; the version before has the same sources, but for Debian's
# patches, which are not applied.
fetch_newest_source() {
  local version
  while read -r version; do
    ! apt-get --quiet --quiet "${@:2}" source --download-only "$1=$version" || return 0
    rm -f "$1"_*
  done < <(apt-cache "${@:2}" showsrc --only-source "$1" | sed --quiet 's/^Version: //p' |
    sort --unique --version-sort --reverse)
  return 1
}

# Sources of the libraries that pages need and Debian compiles for this machine only: into the build
# folder, from where this machine gets its packages, by lists of their own: the machine's stay as they
# are.
fetch_page_sources() {
  local folder=$root/build/page-sources lists list package
  [[ ! -f $folder/complete ]] || return 0
  echo "== Fetching the sources of libzstd, pugixml and libdeflate"
  rm -rf "$folder"
  mkdir -p "$folder/lists/partial" "$folder/parts" "$folder/cache/archives/partial"
  for list in /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources; do
    [[ ! -s $list ]] ||
      sed 's/^deb /deb-src /; s/^Types:.*/Types: deb-src/' "$list" >"$folder/parts/$(basename "$list")"
  done
  lists=(-o Dir::Etc::sourcelist=- -o "Dir::Etc::sourceparts=$folder/parts"
    -o "Dir::State::lists=$folder/lists" -o "Dir::Cache=$folder/cache" -o APT::Sandbox::User=root)
  apt-get --quiet --quiet "${lists[@]}" update || return
  for package in libzstd pugixml libdeflate; do
    (cd "$folder" && fetch_newest_source "$package" "${lists[@]}") || return
    mkdir -p "$folder/$package"
    tar --extract --directory "$folder/$package" --strip-components=1 \
      --file "$(echo "$folder/$package"_*.orig.tar.?z)" || return
  done
  rm -r "$folder/lists" "$folder/cache"
  touch "$folder/complete"
}

# What the preset `page` needs. Fails where it cannot be had.
install_page_tools() { install_missing "${page_packages[@]}" && fetch_page_sources; }

# build PRESET CMAKE_OPTION... -- TARGET...   Without targets: everything. Reuses what is built.
build() {
  local preset=$1 options=() targets=()
  shift
  while [[ $# -gt 0 && $1 != -- ]]; do
    options+=("$1")
    shift
  done
  [[ $# -eq 0 ]] || targets=(--target "${@:2}")
  echo "== Building $preset"
  (
    cd "$root" || exit
    cmake --preset "$preset" "${options[@]}" >/dev/null
    cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}"
  )
}
