#!/usr/bin/env bash
# Makes the Debian packages of this tree: ribbon (the tools), libribbon-dev, python3-ribbon.
#   packaging/packages.sh [FOLDER]      default: build/packages
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

folder=${1-$root/build/packages}

install_missing "${build_packages[@]}" "${python_packages[@]}"
install_page_tools # so that the tools write pages
build release -DRIBBON_BUILD_PYTHON=ON -- ribbon-record ribbon-play ribbon-convert ribbon_python
echo "== Making packages"
made=$root/build/release/packages
rm -rf "$made"
mkdir -p "$made" "$folder"
cpack --config "$root/build/release/CPackConfig.cmake" -B "$made" >"$made/cpack.log" ||
  { cat "$made/cpack.log" >&2 && exit 1; }
rm -f "$folder"/{ribbon,libribbon-dev,python3-ribbon}_*.deb # of another version
cp "$made"/*.deb "$folder"
ls "$folder"/{ribbon,libribbon-dev,python3-ribbon}_*.deb
