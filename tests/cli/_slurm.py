# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of one node on the loopback interface, and a stand-in for its commands."""

import os
import secrets
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "srun")

CONFIGURATION = """ClusterName=corticle
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SchedulerParameters=sched_interval=2,sched_min_interval=100000
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def environment():
    """With the folders of daemons on the PATH."""
    return dict(os.environ, PATH=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")


def lacking():
    """Why there can be no Slurm here; empty where there can."""
    missing = [name for name in PROGRAMS if not shutil.which(name, path=environment()["PATH"])]
    if missing:
        return f"no {', '.join(missing)} (Debian packages slurm-wlm and munge)"
    return "" if os.geteuid() == 0 else "Slurm's daemons are started as root only"


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Slurm:
    """While it lives, `environment` reaches it."""

    def __init__(self, cpus=2):
        self.temporary = tempfile.TemporaryDirectory(prefix="corticle-slurm-") # slurm.conf takes no names with spaces
        self.folder = Path(self.temporary.name)
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        self.environment = dict(environment(), SLURM_CONF=str(self.folder / "slurm.conf"))
        self.host = socket.gethostname().split(".")[0]
        self.daemons = []
        (self.folder / "slurm.conf").write_text(
            CONFIGURATION.format(host=self.host, controller=free_port(), node=free_port(), folder=self.folder, cpus=cpus))

    def __enter__(self):
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        files = [f"--{what}-file={self.folder}/munge.{what}" for what in ("key", "pid", "log", "seed")]
        self.start("munged", "--foreground", "--force", f"--socket={self.folder}/munge.socket", *files)
        self.wait_for(lambda: (self.folder / "munge.socket").exists())
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D", "-N", self.host)
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.temporary.cleanup()

    def start(self, *words):
        with open(self.folder / f"{words[0]}.out", "w", encoding="utf-8") as log:
            self.daemons.append(subprocess.Popen(words, env=self.environment, stdout=log, stderr=log, stdin=subprocess.DEVNULL))

    def call(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=60, check=False)

    def wait_for(self, condition, seconds=60):
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            if condition():
                return True
            time.sleep(0.2)
        return False

    def is_up(self):
        """The node takes jobs."""
        return self.wait_for(lambda: self.call("sinfo", "--noheader", "--format=%T").stdout.strip() == "idle")

    def queue(self):
        return self.call("squeue", "--noheader", "--array", "--format=%A %K %T %j").stdout.split("\n")[:-1]
