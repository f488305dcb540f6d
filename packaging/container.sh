#!/usr/bin/env bash
# Makes the root of a container in which ribbon is installed and which needs no network any more:
#   packaging/container.sh IMAGE.tar PACKAGE.deb... [NAME...]
# PACKAGE.deb are packages made by cpack, NAME others of Debian. Debian itself comes from where this machine
# gets it (RIBBON_APT_SOURCES: other files than its own). Needs mmdebstrap; without root, also uidmap.
#   podman import IMAGE.tar ribbon         then: podman run --network none --volume .:/work ribbon ribbon-record ...
set -euo pipefail

if [[ $# -lt 2 ]]; then
  echo "usage: $0 IMAGE.tar PACKAGE.deb... [NAME...]" >&2
  exit 2
fi
command -v mmdebstrap >/dev/null || { echo "mmdebstrap is missing; install it (apt install mmdebstrap)" >&2 && exit 2; }
image=$1
shift

sources=()
for file in ${RIBBON_APT_SOURCES-/etc/apt/sources.list /etc/apt/sources.list.d/debian.sources}; do
  [[ ! -s $file ]] || sources+=("$file")
done

hooks=()
names=()
for package in "$@"; do
  if [[ $package == *.deb ]]; then
    [[ -f $package ]] || { echo "$package: there is no such package; packaging/packages.sh makes them" >&2 && exit 2; }
    hooks+=(--customize-hook="copy-in '$(realpath "$package")' /var/tmp")
    names+=("/var/tmp/$(basename "$package")")
  else
    names+=("$package")
  fi
done

# As everywhere on Debian, packages bring what they recommend. What stands between single quotes runs in
# mmdebstrap's shell, where $1 is the root.
# shellcheck disable=SC2016
install='DEBIAN_FRONTEND=noninteractive chroot "$1" apt-get install --yes --quiet'
install+=' --option APT::Install-Recommends=true'
# shellcheck disable=SC2016
hooks+=(--customize-hook="$install ${names[*]@Q}" --customize-hook='rm --force "$1"/var/tmp/*.deb')

exec mmdebstrap --quiet --variant=apt "${hooks[@]}" bookworm "$image" "${sources[@]}"
