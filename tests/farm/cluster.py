"""A Slurm of our own on this machine: a controller and two nodes of one core each, in a folder, without root's help,
munge, cgroups or an accounting database. Nothing of the machine's own Slurm is read or written."""
import os
import pwd
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ["slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo"]
DOWN_S = 5  # most that one of them is left to end by itself
UP_S = 30  # most that a controller and two nodes need to find each other

CONFIG = """
ClusterName=mien
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
# How long a job that lost its node waits before it begins again; 120 s otherwise.
AuthInfo=cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=5
KillWait=5
MaxArraySize={most}
SchedulerParameters=sched_min_interval=0,batch_sched_delay=0
SlurmdParameters=config_overrides
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={port1} CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={port2} CPUs=1 State=UNKNOWN
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""


class Missing(Exception):
    """Why there can be no cluster here."""


def find_free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def read_proc(pid, file):
    try:
        with open(f"/proc/{pid}/{file}", "rb") as opened:
            return opened.read()
    except OSError:  # it has ended, or is somebody else's
        return b""


def find_parent(pid):
    words = read_proc(pid, "stat").rpartition(b")")[2].split()
    return int(words[1]) if words else 0


def list_processes(folder, node):
    """What the jobs of a cluster in `folder` run on a node, and what starts and watches them there (slurmstepd)."""
    config, name = f"SLURM_CONF={folder}/slurm.conf".encode(), f"SLURMD_NODENAME={node}".encode()
    jobs = [int(pid) for pid in os.listdir("/proc") if pid.isdigit() and {config, name} <= set(read_proc(pid, "environ").split(b"\0"))]
    steps = {find_parent(pid) for pid in jobs} - set(jobs)
    return jobs + [pid for pid in steps if read_proc(pid, "comm").startswith(b"slurmstepd")]


def kill(pids):
    for pid in pids:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


class Cluster:
    """Up while it is entered: with Cluster(folder) as cluster: ..."""

    def __init__(self, folder, most_array=1001):
        self.folder = os.path.abspath(folder)
        self.most_array = most_array
        self.daemons = {}  # by name: "slurmctld", "n1", "n2"
        self.environment = dict(os.environ, SLURM_CONF=self.folder + "/slurm.conf")
        for name in list(self.environment):  # nothing that a cluster we may run on has told us
            if name.startswith(("SLURM_", "SBATCH_", "SQUEUE_")) and name != "SLURM_CONF":
                del self.environment[name]

    def __enter__(self):
        for program in PROGRAMS:
            if not self.find(program):
                raise Missing(f"{program} is not installed")
        os.makedirs(self.folder + "/state", exist_ok=True)
        port, port1, port2 = find_free_ports(3)
        with open(self.folder + "/slurm.conf", "w", encoding="utf-8") as file:
            file.write(CONFIG.format(host=socket.gethostname().split(".")[0], user=pwd.getpwuid(os.getuid()).pw_name, folder=self.folder, port=port,
                                     port1=port1, port2=port2, most=self.most_array))
        try:
            self.start("slurmctld", ["slurmctld", "-D", "-c"])
            for node in ["n1", "n2"]:
                self.start(node, ["slurmd", "-D", "-N", node])
            self.wait_until_up()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    @staticmethod
    def find(program):
        return shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")

    def start(self, name, command):
        with open(f"{self.folder}/{name}.out", "ab") as log:
            self.daemons[name] = subprocess.Popen([self.find(command[0])] + command[1:], env=self.environment, stdin=subprocess.DEVNULL,
                                                  stdout=log, stderr=log, start_new_session=True)

    def run(self, *command):
        """What a program of Slurm prints."""
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False).stdout

    def wait_until_up(self):
        until = time.monotonic() + UP_S
        while time.monotonic() < until:
            for name, daemon in self.daemons.items():
                if daemon.poll() is not None:
                    raise Missing(f"{name} does not start: {self.read_end(name)}")
            if self.run("sinfo", "-h", "-N", "-t", "idle", "-o", "%N").split() == ["n1", "n2"]:
                return
            time.sleep(0.2)
        raise Missing(f"no two nodes within {UP_S} s: {self.read_end('slurmctld')}")

    def read_end(self, name):
        text = ""
        for file in [f"{self.folder}/{name}.out", f"{self.folder}/{'slurmctld' if name == 'slurmctld' else 'slurmd.' + name}.log"]:
            if os.path.exists(file):
                with open(file, encoding="utf-8", errors="replace") as log:
                    text += log.read()[-400:]
        return " ".join(text.split())

    def kill_node(self, node):
        """The node is lost: its daemon and the jobs that it runs are gone at once."""
        daemon = self.daemons.pop(node)
        daemon.kill()
        daemon.wait()
        kill(list_processes(self.folder, node))

    def stop(self):
        for daemon in self.daemons.values():
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(DOWN_S)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.daemons.clear()
        for node in ["n1", "n2"]:
            kill(list_processes(self.folder, node))
