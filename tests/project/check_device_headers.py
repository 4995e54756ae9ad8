# SPDX-License-Identifier: GPL-3.0-or-later
"""The law headers compile for a device: by nvcc, to machine code, and by clang, to LLVM IR (its own device library and
CUDA's headers are not needed for that). Nothing is run: that takes a device."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from _project import SKIPPED, parse_arguments

COMPILERS = {
    "nvcc": "-arch=sm_90 -c".split(),
    "clang++": "-x cuda --cuda-device-only -nocudalib -nocudainc --cuda-gpu-arch=sm_80 -Wno-unknown-cuda-version "
    "-S -emit-llvm".split(),
}


def find(name):
    return shutil.which(name) or shutil.which(f"/usr/local/cuda/bin/{name}")


def knows_devices(compiler, options, folder):
    """Whether the compiler was built with this target at all: an empty kernel shows it."""
    probe = folder / "probe.cu"
    probe.write_text("__attribute__((global)) void nothing() {}\n", encoding="utf-8")
    command = [compiler, "-std=c++20", *options, "-o", folder / "probe.out", probe]
    return subprocess.run(command, check=False, capture_output=True).returncode == 0


def main():
    source = parse_arguments(__doc__).source
    kernel = source / "tests" / "project" / "device" / "laws.cu"
    compiled, failed = [], []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for tool, options in COMPILERS.items():
            compiler = find(tool)
            if compiler is None or not knows_devices(compiler, options, folder):
                print(f"{tool}: not here, or without a device to compile for")
                continue
            command = [compiler, "-std=c++20", *options, "-I", source / "src", "-o", folder / "laws.out", kernel]
            result = subprocess.run(command, check=False, capture_output=True, text=True)
            (compiled if result.returncode == 0 else failed).append(tool)
            print(f"{tool}: {'compiles the laws' if result.returncode == 0 else result.stderr}")
    print("compiled only: what the laws give on a device takes one to say")
    if not compiled and not failed:
        print("skipped: neither nvcc nor clang++ compiles for a device here")
        sys.exit(SKIPPED)
    sys.exit(1 if failed else 0)


main()
