# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the compiled module by CMake, in build/release as `make` does, and takes it into the wheel with the program that
meshes. Nothing is compiled that `make` has compiled already. CORTICLE_BUILD names another build folder."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parent
BUILD = Path(os.environ.get("CORTICLE_BUILD", SOURCE / "build" / "release"))


def version():
    return re.search(r"project\(corticle VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]


class Build(build_ext):
    def build_extension(self, extension):
        jobs = os.environ.get("JOBS", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--preset", "release", "-B", BUILD, "-D", "CORTICLE_PYTHON_MODULE=ON", "-D",
                        f"Python_EXECUTABLE={sys.executable}"], cwd=SOURCE, check=True)
        subprocess.run(["cmake", "--build", BUILD, "--parallel", jobs, "--target", "corticle_python", "corticle_tetrahedralize"],
                       check=True)
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(BUILD / "python" / target.name, target)
        shutil.copy2(BUILD / "bin" / "corticle-tetrahedralize", target.parent)


setup(version=version(), ext_modules=[Extension("corticle._corticle", [])], cmdclass={"build_ext": Build})
