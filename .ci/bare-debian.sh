#!/bin/bash
# Runs a command in a minimal Debian 12 system, in which nothing is installed that Beadswim's scripts do not install.
#   .ci/bare-debian.sh FOLDER COMMAND...    for example  .ci/bare-debian.sh /tmp/bare /src/beadswim/tests/run.sh
# Creates the system in FOLDER if it does not exist (half a minute) and keeps it with all that the command writes; to delete it, remove
# FOLDER. The system uses the network, the certificates and the npm registry of this machine; the environment variable
# DEBIAN_MIRROR selects another mirror of Debian. Mounts exist only while the command runs. Needs root; installs mmdebstrap.
set -euo pipefail
[ $# -ge 2 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || { echo "bare-debian.sh: needs root, for chroot; run it with sudo" >&2; exit 2; }
system=$(realpath -m "$1")
shift
certificates=/etc/certificates-of-this-machine.crt # not where the package ca-certificates would replace it

if [ ! -e "$system/etc/debian_version" ]; then
  if ! command -v mmdebstrap >/dev/null; then
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends mmdebstrap >&2
  fi
  mmdebstrap --quiet --variant=minbase --dpkgopt=force-unsafe-io bookworm "$system" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"}
  cp -L /etc/resolv.conf /etc/hosts "$system/etc/"
  if [ -f "$HOME/.npmrc" ]; then cp "$HOME/.npmrc" "$system/root/"; fi
  if [ -f /etc/ssl/certs/ca-certificates.crt ]; then cp -L /etc/ssl/certs/ca-certificates.crt "$system$certificates"; fi
fi

variables=(HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
  NODE_EXTRA_CA_CERTS=$certificates)
for name in TERM CI http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
  [ -z "${!name:-}" ] || variables+=("$name=${!name}")
done
if command -v npm >/dev/null; then variables+=("npm_config_registry=$(npm config get registry)"); fi

# The mounts are private to this process and vanish with it.
# shellcheck disable=SC2016  # the inner shell expands its arguments
exec env -i "${variables[@]}" unshare --mount --propagation private bash -euc '
  mount -t proc proc "$0/proc"
  for folder in sys dev; do mount --rbind "/$folder" "$0/$folder"; done
  exec chroot "$0" "$@"' "$system" "$@"
