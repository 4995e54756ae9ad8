#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Python package in build/release, of the same objects as the command, and installs it into build/venv.
#   scripts/python.sh                       build and install
#   scripts/python.sh --test                and run its tests
#   scripts/python.sh --test --if-possible  where its Debian packages are there or can be installed; else one line says so
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ " $* " == *" --if-possible "* ]] && ! scripts/setup.sh --python; then
    echo "python: skipped, as packages that the Python package is built with are not there and could not be installed" >&2
    exit 0
fi

python=$(command -v /usr/bin/python3 || command -v python3)
venv=$PWD/build/venv
[[ -x $venv/bin/python ]] || "$python" -m venv --system-site-packages "$venv"
"$venv/bin/python" -m pip install --quiet --no-build-isolation --no-deps --no-index --force-reinstall .

if [[ " $* " == *" --test "* ]]; then
    # From elsewhere, so that it is the installed package that is tested.
    source=$PWD
    cd build
    CORTICLE_COMMAND=$source/build/release/bin/corticle timeout 900 "$venv/bin/python" -m pytest -q -p no:cacheprovider \
        -c "$source/pyproject.toml" --rootdir "$source" "$source/python/tests"
fi
