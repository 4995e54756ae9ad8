#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages of `make package` in a Debian of its own below ROOT, made by debootstrap where there is none, and runs
# the program and the Python module there; takes the packages out again. As root: scripts/try_package.sh ROOT
set -euo pipefail
cd "$(dirname "$0")/.."
root=${1:?usage: scripts/try_package.sh ROOT}

[[ -x $root/usr/bin/apt-get ]] || debootstrap --variant=minbase "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$root"
place=$(mktemp -d "$root/tmp/packages.XXXXXX")
inside=${place#"$root"}
in_root() { chroot "$root" env LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
clean() {
    in_root dpkg --purge python3-corticle corticle >/dev/null 2>&1 || true
    rm -rf "$place"
}
trap clean EXIT

cp build/release/corticle_*.deb build/release/python3-corticle_*.deb "$place"
chmod 755 "$place"
in_root apt-get update -qq || echo "try_package: apt-get update failed; trying with the package lists at hand" >&2
in_root sh -c "cd $inside && apt-get install -y -qq --no-install-recommends ./corticle_*.deb ./python3-corticle_*.deb"
in_root corticle --version
in_root sh -ec "cd $inside && corticle new ball.toml && corticle run ball.toml --out run --set solver.method=fem \
    --set solver.elements=3000 --set time.end=0.02 --set output.count=2 --set output.pictures=off --set output.report=off"
in_root sh -ec "cd $inside && python3 -W ignore -c \"
import corticle
case = corticle.Case.load('ball.toml', **{'geometry.particles': 2500, 'time.end': 0.02, 'output.count': 2})
run = corticle.run(case, 'from_python')
assert run.status == 'completed', run.status
print('corticle', corticle.__version__, 'from Python:', run.status)\""
