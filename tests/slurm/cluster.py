"""A Slurm cluster of three nodes on this machine: its daemons run as this user, with all files below one folder."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel", "sinfo")
NODES = ("n1", "n2", "n3")
# Adds the folders where Debian installs daemons.
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"


def missing_programs():
    return [name for name in PROGRAMS if not shutil.which(name, path=PATH)]


def free_ports(count):
    """Returns consecutive ports that are currently unused."""
    for _ in range(50):
        with socket.socket() as first:
            first.bind(("127.0.0.1", 0))
            base = first.getsockname()[1]
        try:
            for port in range(base, base + count):
                with socket.socket() as one:
                    one.bind(("127.0.0.1", port))
            if base + count < 65536:
                return base
        except OSError:
            pass
    raise RuntimeError("no free ports")


class Cluster:
    def __init__(self, folder, max_array=1001):
        self.folder = pathlib.Path(folder)
        self.daemons = {}
        host = socket.gethostname().split(".")[0]
        port = free_ports(4)
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        for name in ("state", "log", "run", "munge"):
            (self.folder / name).mkdir(parents=True)
        (self.folder / "munge").chmod(0o700)
        self.key = self.folder / "munge/key"
        self.key.write_bytes(os.urandom(1024))
        self.key.chmod(0o600)
        self.socket = self.folder / "run/munge.socket"
        nodes = "\n".join(
            f"NodeName={node} NodeHostName={host} NodeAddr=127.0.0.1 Port={port + 1 + i} CPUs=1 RealMemory=1000"
            for i, node in enumerate(NODES))
        self.config = self.folder / "slurm.conf"
        self.config.write_text(f"""
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={self.socket}
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
ReturnToService=2
SwitchType=switch/none
StateSaveLocation={self.folder}/state
SlurmctldPidFile={self.folder}/run/slurmctld.pid
SlurmdPidFile={self.folder}/run/slurmd-%n.pid
SlurmdSpoolDir={self.folder}/spool-%n
SlurmctldLogFile={self.folder}/log/slurmctld.log
SlurmdLogFile={self.folder}/log/slurmd-%n.log
SlurmctldTimeout=10
SlurmdTimeout=5
KillWait=600
MinJobAge=300
InactiveLimit=0
MaxArraySize={max_array}
JobRequeue=1
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=600 State=UP
""")
        self.environment = dict(os.environ, PATH=PATH, SLURM_CONF=str(self.config))

    def start(self):
        try:
            self.daemon("munged", ["munged", "--foreground", "--force", f"--key-file={self.key}", f"--socket={self.socket}",
                                   f"--pid-file={self.folder}/run/munged.pid", f"--log-file={self.folder}/log/munged.log",
                                   f"--seed-file={self.folder}/munge/seed", "--num-threads=2"])
            self.wait(self.socket.exists, "munged")
            self.daemon("slurmctld", ["slurmctld", "-D", "-c", "-f", str(self.config)])
            for node in NODES:
                self.start_node(node)
            self.wait(lambda: self.call("sinfo", "-h", "-N", "-o", "%T").split() == ["idle"] * len(NODES), "nodes")
        except BaseException:
            self.stop()
            raise

    def start_node(self, node):
        (self.folder / f"spool-{node}").mkdir(exist_ok=True)
        self.daemon(node, ["slurmd", "-D", "-N", node, "-f", str(self.config)])

    def daemon(self, name, command):
        with open(self.folder / f"log/{name}.out", "ab") as log:
            self.daemons[name] = subprocess.Popen(command, env=self.environment, stdout=log, stderr=log,
                                                  stdin=subprocess.DEVNULL, start_new_session=True)

    def stop(self):
        """Ends jobs first, then daemons in reverse order, each by its own process id."""
        if "slurmctld" in self.daemons:
            subprocess.run(["scancel", "--state=RUNNING,PENDING", "-u", str(os.getuid())], env=self.environment,
                           capture_output=True, timeout=600)
            subprocess.run(["scancel", "-f", "-s", "KILL", "-u", str(os.getuid())], env=self.environment,
                           capture_output=True, timeout=600)
        for daemon in reversed(list(self.daemons.values())):
            if daemon.poll() is None:
                daemon.send_signal(signal.SIGTERM)
        for daemon in self.daemons.values():
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.daemons.clear()

    def wait(self, until, what, seconds=600):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if until():
                return
            for name, daemon in self.daemons.items():
                if daemon.poll() is not None:
                    raise RuntimeError(f"{name} ended with {daemon.returncode}: {self.logs()}")
            time.sleep(0.1)
        raise RuntimeError(f"waited {seconds} s for {what}: {self.logs()}")

    def logs(self):
        return "\n".join(f"{path.name}: {path.read_text(errors='replace')[-1500:]}" for path in (self.folder / "log").iterdir())

    def attempt(self, *command):
        """Returns the output of a Slurm command, which may fail."""
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=600).stdout

    def call(self, *command, seconds=120):
        """Returns the output of a Slurm command. Repeats a failed command, because a busy controller refuses some."""
        end = time.monotonic() + seconds
        while True:
            done = subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=600)
            if done.returncode == 0:
                return done.stdout
            if time.monotonic() > end:
                raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}: {done.stderr}{self.logs()[-3000:]}")
            time.sleep(0.2)
