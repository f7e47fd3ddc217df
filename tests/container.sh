#!/bin/bash
# Tests the container definition examples/containers/beadswim.def without Apptainer. Creates two minimal Debian 12 systems with
# debootstrap. Runs the sections of the definition in them with chroot: the files and %post of both stages, then %environment and
# %test. Needs root, debootstrap and a network connection; takes about ten minutes.
#   tests/container.sh FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
definition=$PWD/examples/containers/beadswim.def
folder=$(realpath -m "${1:?name a folder for two small systems}")
mirror=${DEBIAN_MIRROR-http://deb.debian.org/debian}

section() { # STAGE NAME: prints the lines of a section
  awk -v stage="$1" -v name="$2" '
    /^Stage: / { now = $2; inside = 0 }
    /^%/ { inside = (now == stage && $0 ~ "^%" name); next }
    /^Bootstrap:/ { inside = 0 }
    inside && NF' "$definition"
}

system() { # STAGE: creates a minimal system in $folder/STAGE
  mkdir -p "$folder"
  debootstrap --variant=minbase bookworm "$folder/$1" "$mirror" >"$folder/$1.log"
  cp /etc/resolv.conf "$folder/$1/etc/"
  mount -t proc proc "$folder/$1/proc"
  mount -t sysfs sysfs "$folder/$1/sys"
  mount -t tmpfs tmpfs "$folder/$1/dev/shm" 2>/dev/null || true
}

inside() { # STAGE: runs the script on standard input in the system of the stage
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive OMPI_ALLOW_RUN_AS_ROOT=1 \
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 chroot "$folder/$1" sh
}

finished() { umount "$folder"/*/proc "$folder"/*/sys "$folder"/*/dev/shm 2>/dev/null || true; }
trap finished EXIT

system build
section build files | while read -r from to; do
  mkdir -p "$folder/build$to"
  cp -r "$from" "$folder/build$to"
done
section build post | inside build
system final
section final 'files from build' | while read -r from to; do cp "$folder/build$from" "$folder/final$to"; done
section final post | inside final
{ section final environment; section final test; } | inside final
