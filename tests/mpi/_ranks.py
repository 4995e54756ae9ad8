# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of several ranks on one machine, however few cores it has."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))

ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMP_WAIT_POLICY": "passive",
}


def mpirun():
    """The path of Open MPI's mpirun, or nothing."""
    path = shutil.which("mpirun")
    if path is None:
        return None
    version = subprocess.run([path, "--version"], capture_output=True, text=True, check=False).stdout
    return path if "Open MPI" in version or "open-mpi" in version.lower() else None


def words(bench, ranks, arguments):
    return [mpirun(), "-n", str(ranks), bench.command, *map(str, arguments)]


def start(bench, ranks, *arguments):
    return subprocess.Popen(words(bench, ranks, arguments), cwd=bench.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, errors="replace", env={**os.environ, **ENVIRONMENT})


def call(bench, ranks, *arguments, timeout=300):
    """(exit status, stdout, stderr)"""
    process = start(bench, ranks, *arguments)
    try:
        output, errors = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        process.terminate()
        process.communicate()
        return None, "", ""
    return process.returncode, output, errors


def rank_ids(process):
    """Process numbers of the ranks that mpirun started."""
    return [int(entry.name) for entry in Path("/proc").iterdir()
            if entry.name.isdigit() and parent_of(entry) == process.pid]


def parent_of(entry):
    try:
        return int((entry / "stat").read_text(encoding="utf-8").rpartition(")")[2].split()[1])
    except (OSError, ValueError, IndexError):
        return None
