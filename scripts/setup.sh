#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what the build needs and is not there. Quick when nothing is missing.
#   scripts/setup.sh          to build, run and test
#   scripts/setup.sh --tests  also node and Chromium, for tests of reports, Open MPI, the site's Sphinx, and with CORTICLE_TEST_SLURM=1 Slurm; where they
#                             cannot be had, these tests are skipped
#   scripts/setup.sh --mpi    also Open MPI (make mpi)
#   scripts/setup.sh --dev    also clang, clang-tidy and clang's OpenMP (make lint, make tsan)
#   scripts/setup.sh --python also what builds and tests the Python package (make python) and makes Debian packages
set -euo pipefail

packages=(
    g++ cmake make python3 python3-nibabel
    libvtk9-dev xvfb xauth libgl1-mesa-dri
    libcgal-dev libeigen3-dev libgmsh-dev libhdf5-dev zlib1g-dev libssl-dev
    libnlopt-dev # corticle fit and sensitivity
    libtomlplusplus-dev libcli11-dev libspdlog-dev libfmt-dev nlohmann-json3-dev
    libgtest-dev libgmock-dev libbenchmark-dev clang-format
    libjs-three # report.html
)
[[ ${1:-} == --dev ]] && packages+=(clang clang-tidy libomp-dev)
[[ ${1:-} == --mpi ]] && packages+=(libopenmpi-dev openmpi-bin)
[[ ${1:-} == --python ]] && packages+=(
    pybind11-dev python3-pybind11 python3-dev python3-venv python3-pip python3-setuptools python3-wheel python3-numpy
    python3-pytest python3-pandas python3-meshio python3-matplotlib python3-vtk9 python3-tqdm python3-sphinx mypy
    python3-myst-parser # make docs
    dpkg-dev # make package
)
wished=()
if [[ ${1:-} == --tests ]]; then
    command -v node >/dev/null || wished+=(nodejs)
    # Daemons, hence only where asked for: .ci/run does.
    [[ -n ${CORTICLE_TEST_SLURM:-} ]] && { command -v slurmctld >/dev/null || wished+=(slurm-wlm munge); }
    command -v mpirun >/dev/null || wished+=(libopenmpi-dev openmpi-bin)
    /usr/bin/python3 -c 'import myst_parser' 2>/dev/null || wished+=(python3-sphinx python3-myst-parser)
    command -v chromium >/dev/null || command -v chromium-browser >/dev/null || wished+=(chromium)
fi

say() { echo "setup: $*" >&2; }

if ! command -v dpkg-query >/dev/null; then
    if command -v cmake >/dev/null && command -v make >/dev/null && command -v python3 >/dev/null &&
        { command -v g++ || command -v clang++; } >/dev/null; then
        say "not a Debian or Ubuntu system: assuming the libraries are there; CMake will name any that is not"
        exit 0
    fi
    say "not a Debian or Ubuntu system; install a C++20 compiler, make, python3, CMake 3.25, VTK 9.1, CGAL 5.5, Eigen 3, Gmsh 4.8, HDF5 (C), OpenSSL," \
        "NLopt, toml++, CLI11, spdlog, fmt, nlohmann-json, GoogleTest and Google Benchmark, and Xvfb for pictures without a display"
    exit 1
fi

list_missing() {
    local installed
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null | sed -n 's/^installed //p') || true
    comm -23 <(printf '%s\n' "${packages[@]}" | sort -u) <(sort -u <<<"$installed")
}

mapfile -t missing < <(list_missing)
((${#missing[@]} + ${#wished[@]} == 0)) && exit 0

say "missing: ${missing[*]} ${wished[*]}"
as_root=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
        say "cannot install them: not root, and there is no sudo. As root: apt-get install --no-install-recommends ${missing[*]} ${wished[*]}"
        ((${#missing[@]})) && exit 1 || exit 0
    fi
    as_root=(sudo)
fi

apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o Dpkg::Use-Pty=0 -o Acquire::Retries=3 -qq "$@"; }
((${#missing[@]})) && say "installing them (libvtk9-dev brings some 800 MB; minutes the first time)"
apt update </dev/null || say "apt-get update failed; trying with the package lists at hand"
apt install -y --no-install-recommends "${missing[@]}" </dev/null >&2 || true
for package in "${wished[@]}"; do
    apt install -y --no-install-recommends "$package" </dev/null >&2 || say "no $package: the tests that need it will be skipped"
done

mapfile -t missing < <(list_missing)
if ((${#missing[@]})); then
    say "could not install: ${missing[*]}"
    exit 1
fi
say "done"
