#!/bin/bash
# Installs the missing Debian packages with which Beadswim is built and tested and figures are drawn.
#   .ci/install-packages.sh [--with-readers]
# With --with-readers, also installs packages that only tests/extended.sh needs: programs of other projects that read Beadswim's
# files, and a browser.
set -euo pipefail

packages=(
  g++ cmake ninja-build pkg-config git                                   # build
  openmpi-bin libopenmpi-dev libhdf5-openmpi-dev hdf5-tools              # parallel runs and files
  libeigen3-dev libcli11-dev nlohmann-json3-dev libvalijson-dev          # libraries
  libfmt-dev libssl-dev libfftw3-dev libboost-dev libnlopt-cxx-dev
  libgtest-dev libgmock-dev libsundials-dev                              # tests
  librsvg2-bin fonts-dejavu-core                                         # figures as PNG
  help2man dpkg-dev file                                                 # manual pages, Debian package
  jq python3 python3-jsonschema                                          # scripts, tests of documents by the schemas
)
readers=(python3-pandas python3-h5py python3-mdanalysis paraview python3-paraview)
readers+=(chromium)                                                      # tests of the page of beadswim-view
# Node.js builds the page of beadswim-view. A Node.js that was not installed as a Debian package is sufficient, too.
command -v node >/dev/null && command -v npm >/dev/null || packages+=(nodejs npm)

case "${1:-}" in
  "") ;;
  --with-readers) packages+=("${readers[@]}") ;;
  *) echo "install-packages.sh: unknown argument \"$1\"; allowed is --with-readers" >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "install-packages.sh: this is not a Debian-like system; install by its own means: ${packages[*]}" >&2
  exit 2
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null || true)
  grep -qx installed <<<"$state" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "All ${#packages[@]} packages are installed."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install-packages.sh: neither root nor sudo; ask your administrator to install: ${missing[*]}" >&2
    exit 2
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
