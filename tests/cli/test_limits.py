#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Little memory, few file descriptors, a small stack, absurd numbers of threads, hostile archives: done, or one line."""

import gzip
import os
import resource
import struct
import subprocess

import _command

CASE = '[geometry]\nparticles = 1500\n[time]\nend = 0.01\n[output]\npictures = "off"\nreport = "off"\ncount = 1\n'


def nifti_header(*size):
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *size, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)
    struct.pack_into("<8f", header, 76, 1, 1, 1, 1, 1, 1, 1, 1)
    struct.pack_into("<2f", header, 108, 352, 1)
    header[344:348] = b"n+1\0"
    return bytes(header)


def limited(bench, arguments, limits=(), environment=None):
    """(exit status, stderr, peak memory in MB) of the command under limits."""
    def set_limits():
        for kind, value in limits:
            resource.setrlimit(kind, (value, value))
    process = subprocess.Popen([bench.command, *arguments], cwd=bench.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, preexec_fn=set_limits, env={**os.environ, **(environment or {})})
    errors = process.stderr.read().decode(errors="replace")
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, errors, usage.ru_maxrss / 1024


def one_line(bench, what, got, statuses, part):
    status, errors, _ = got
    is_line = errors.startswith(_command.PREFIX) and errors.count("\n") == 1
    bench.check(status in statuses and is_line and part in errors, f"{what}: exit status {status}, stderr {errors!r}")


def system_limits(bench):
    bench.write("case.toml", CASE)
    run = ("run", "case.toml", "--quiet", "--threads", "1", "--out")
    for what, limit in (("few descriptors", (resource.RLIMIT_NOFILE, 20)), ("a small stack", (resource.RLIMIT_STACK, 256 << 10)),
                        ("little memory", (resource.RLIMIT_AS, 1000 << 20))):
        status, errors, _ = limited(bench, [*run, what.replace(" ", "_")], [limit])
        bench.check(status == 0, f"{what}: exit status {status}, stderr {errors!r}")
    check = ["check", "case.toml"]
    bench.write("large.nii.gz", gzip.compress(nifti_header(1024, 1024, 512) + b"\1" + bytes((1 << 29) - 1)))
    one_line(bench, "out of memory", limited(bench, ["measure", "large.nii.gz"], [(resource.RLIMIT_AS, 700 << 20)]), (3,),
             "out of memory")
    for count in ("0", "-3", "100000", "99999999999999999999", "x", "2,x"):
        status, errors, used = limited(bench, check, environment={"OMP_NUM_THREADS": count})
        own = "".join(line for line in errors.splitlines(keepends=True) if line.strip() and not line.startswith("libgomp:"))
        one_line(bench, f"OMP_NUM_THREADS={count}", (status, own, used), (2,), "OMP_NUM_THREADS")
    for count in ("0", "1025", "99999999999999999999"):
        one_line(bench, f"--threads {count}", limited(bench, [*check, "--threads", count]), (2,), "--threads")
    one_line(bench, "more threads than memory",
             limited(bench, [*check, "--threads", "1024"], [(resource.RLIMIT_AS, 2000 << 20)]), (2,), "the system gives")


def bombs(bench):
    """A megabyte of gzip claims to be an image, a surface, a mesh: refused, and without a gigabyte of memory."""
    zeros = gzip.compress(bytes(1 << 27)) * 8 # members of zeros, a gigabyte of them
    mgh = struct.pack(">7ih3f12f", 1, 1024, 1024, 1023, 1, 0, 0, 1, 1, 1, 1, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0).ljust(284, b"\0")
    packed = {"a.nii.gz": gzip.compress(nifti_header(1024, 1024, 1023)) + zeros, "a.mgz": gzip.compress(mgh) + zeros, "a.surf.gii.gz": zeros,
              "a.stl.gz": zeros, "a.vtk.gz": zeros, "lh.white": zeros}
    for name, content in packed.items():
        bench.check(len(content) < 1 << 21, f"{name} has {len(content)} bytes")
        bench.write(name, content)
        got = limited(bench, ["measure", name])
        one_line(bench, name, got, (2,), name)
        bench.check(got[2] < 700, f"{name}: took {got[2]:.0f} MB")


_command.main(__doc__, system_limits, bombs)
