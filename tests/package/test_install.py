# SPDX-License-Identifier: GPL-3.0-or-later
"""What is installed: the program works from where it was put, a program outside the tree is built against its library, and
the Debian package holds what Debian asks of one."""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77


def output_of(*command, folder=None, expected=0):
    """Runs a command; what it prints, or the end of the test with all it said."""
    environment = {**os.environ, "CORTICLE_TETRAHEDRALIZE": ""}
    del environment["CORTICLE_TETRAHEDRALIZE"]
    done = subprocess.run([str(word) for word in command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600, check=False)
    if done.returncode != expected:
        sys.exit(f"{command}: exit status {done.returncode}, expected {expected}\n{done.stdout[-3000:]}")
    return done.stdout


def require(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def install(build, prefix):
    for component in ("program", "development"):
        output_of("cmake", "--install", build, "--prefix", prefix, "--component", component)
    for name in ("bin/corticle", "libexec/corticle/corticle-tetrahedralize", "share/man/man1/corticle.1.gz",
                 "share/bash-completion/completions/corticle", "share/doc/corticle/copyright", "include/corticle/base/vec3.hpp"):
        require((prefix / name).is_file(), f"{name} is not installed")


def program_works(prefix, version, folder):
    command = prefix / "bin" / "corticle"
    require(f"corticle {version}" in output_of(command, "--version"), f"--version does not say {version}")
    output_of(command, "new", "ball.toml", folder=folder)
    keys = ("solver.method=fem", "solver.elements=3000", "time.end=0.01", "output.count=2", "output.pictures=off",
            "output.report=off")
    # Its own tets: so it found the program that meshes.
    output_of(command, "run", "ball.toml", "--out", "run", *(word for key in keys for word in ("--set", key)), folder=folder)
    require("completed" in (folder / "run" / "summary.json").read_text(), "the run is not completed")


def library_works(source, prefix, folder):
    """The example is configured, built and run against the installed library."""
    output_of("cmake", "-S", source / "examples" / "cmake", "-B", folder / "example", "-D", f"CMAKE_PREFIX_PATH={prefix}")
    output_of("cmake", "--build", folder / "example")
    said = output_of(folder / "example" / "fold", source / "cases" / "sphere.toml", "geometry.particles=2500", "time.end=0.01",
                     "output.count=2")
    require(len(re.findall(r"^t 0\.\d+  area \d+", said, re.MULTILINE)) == 3, f"the example prints {said}")


def core_needs_little(prefix, folder):
    """Without VTK and C: only the laws and the loop."""
    project = folder / "core"
    project.mkdir()
    (project / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(core LANGUAGES CXX)\nfind_package(Corticle 0.1 REQUIRED COMPONENTS core)\n"
        "if(VTK_FOUND)\n    message(FATAL_ERROR \"core asks for VTK\")\nendif()\n"
        "add_executable(core core.cpp)\ntarget_link_libraries(core PRIVATE Corticle::core)\n")
    (project / "core.cpp").write_text("#include \"corticle/material/clock.hpp\"\n#include \"corticle/base/version.hpp\"\n"
                                      "int main() { return corticle::program_version().empty() ? 1 : 0; }\n")
    output_of("cmake", "-S", project, "-B", project / "build", "-D", f"CMAKE_PREFIX_PATH={prefix}")
    output_of("cmake", "--build", project / "build")
    output_of(project / "build" / "core")


def debian_package(build, version, folder):
    if shutil.which("dpkg-shlibdeps") is None:
        print("no dpkg-shlibdeps: no Debian package was made")
        return
    with_python = any((build / "python").glob("_corticle*.so"))
    components = "program;python" if with_python else "program"
    output_of("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, "-D", f"CPACK_COMPONENTS_ALL={components}", folder=build)
    package = next(folder.glob("corticle_*.deb"))
    fields = output_of("dpkg-deb", "-f", package)
    require(f"Version: {version}\n" in fields, f"the package is not of version {version}: {fields}")
    require("libvtk" in fields and "libc6" in fields, f"dependencies are missing: {fields}")
    names = output_of("dpkg-deb", "-c", package)
    for name in ("usr/bin/corticle", "usr/share/man/man1/corticle.1.gz", "usr/share/doc/corticle/copyright",
                 "usr/share/doc/corticle/changelog.gz"):
        require(f"./{name}\n" in names, f"the package lacks {name}")
    if with_python:
        module = next(folder.glob("python3-corticle_*.deb"))
        require(f"corticle (= {version})" in output_of("dpkg-deb", "-f", module), "the module does not depend on its program")
        require("dist-packages/corticle/__init__.py\n" in output_of("dpkg-deb", "-c", module), "the module is not in its package")
    if shutil.which("lintian") is None:
        print("no lintian: the packages were not checked by it")
        return
    output_of("lintian", "--allow-root", "--fail-on", "error,warning", *folder.glob("*.deb"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", type=Path, required=True)
    parser.add_argument("--source", type=Path, default=Path(__file__).resolve().parents[2])
    arguments = parser.parse_args()
    build = arguments.command.resolve().parents[1]
    if re.search(r"^CORTICLE_SANITIZE:\w+=.", (build / "CMakeCache.txt").read_text(), re.MULTILINE):
        print("a build with sanitizers is not for installing")
        sys.exit(SKIPPED)
    source = arguments.source.resolve()
    version = re.search(r"project\(corticle VERSION ([\d.]+)", (source / "CMakeLists.txt").read_text())[1]
    with tempfile.TemporaryDirectory(prefix="corticle package ") as name:
        folder = Path(name)
        install(build, folder / "prefix")
        program_works(folder / "prefix", version, folder)
        library_works(source, folder / "prefix", folder)
        core_needs_little(folder / "prefix", folder)
        debian_package(build, version, folder / "deb")
    print("installed, built against, packed")


main()
