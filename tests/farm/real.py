#!/usr/bin/python3
"""real.py PROGRAM: renders a clip on a Slurm of its own, of which a task is killed and then a node is lost, and tells
whether the clip is that of a local run. Works in the folder that it is called in.

Prints "skipped: REASON" where no Slurm can be had.
"""
import filecmp
import os
import re
import signal
import subprocess
import sys
import time

from cluster import Cluster, Missing, list_processes

MOST_S = 240  # for what takes a minute
CLIP = """mien: 1
title: Farm
render: {size: 32x40, quality: draft}
clip:
  fps: 24
  length: 2s
  keys:
    - {at: 0s, express: neutral}
    - {at: 47f, express: smile, ease: linear}
"""
DRAWINGS, CHUNK = 48, 6
failed = []


def check(words, holds, note=""):
    print(("holds   " if holds else "FAILED  ") + words, note if not holds else "", flush=True)
    if not holds:
        failed.append(words)


def read(path):
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.read()


def count_stored(folder):
    store = folder + "/store"
    return len([name for name in os.listdir(store) if name.endswith(".png")]) if os.path.isdir(store) else 0


def wait_until(holds, most_s=MOST_S):
    until = time.monotonic() + most_s
    while time.monotonic() < until:
        found = holds()
        if found:
            return found
        time.sleep(0.05)
    return None


def find_task(cluster, program):
    """A mien of a task that traces: the process of a node's job that has povray below it."""
    for node in ["n1", "n2"]:
        for pid in list_processes(cluster.folder, node):
            try:
                if os.path.samefile(f"/proc/{pid}/exe", program) and os.listdir(f"/proc/{pid}/task"):
                    children = read(f"/proc/{pid}/task/{pid}/children").split()
                    if any(read(f"/proc/{child}/comm").startswith("povray") for child in children):
                        return pid
            except OSError:
                pass
    return None


def find_busy_node(cluster, program):
    for node in ["n2", "n1"]:
        for pid in list_processes(cluster.folder, node):
            try:
                if os.path.samefile(f"/proc/{pid}/exe", program):
                    return node
            except OSError:
                pass
    return None


def run_mien(cluster, program, *options):
    return subprocess.run([program, "render", "farm.yaml", *options], env=cluster.environment, capture_output=True, text=True,
                          timeout=MOST_S, check=False)


def queue(cluster):
    return cluster.run("squeue", "-h", "-o", "%F %j %T %r")


def try_all(cluster, program):
    folder = "out/farm"
    engine = ["--engine", "slurm", "--chunk", str(CHUNK)]

    begun = time.monotonic()
    left = run_mien(cluster, program, *engine, "--no-wait")
    check("it submits and returns", left.returncode == 0 and "8 tasks of 6 drawings" in left.stderr, left.stderr)
    jobs = set(queue(cluster).split("\n"))
    again = run_mien(cluster, program, *engine, "--no-wait")
    check("a second call submits nothing", "going on with jobs" in again.stderr, again.stderr)
    check("there are two jobs", len({line.split()[0] for line in queue(cluster).splitlines()}) == 2, f"{jobs}")

    # A task is killed in the middle of its work, as when memory runs out: Slurm does not begin it anew.
    wait_until(lambda: count_stored(folder) >= 2)
    task = wait_until(lambda: find_task(cluster, program))
    check("a task traces", task is not None)
    if task:
        os.kill(task, signal.SIGKILL)

    # A node is lost with all that it runs: Slurm begins its tasks anew elsewhere.
    wait_until(lambda: count_stored(folder) >= DRAWINGS // 2)
    node = wait_until(lambda: find_busy_node(cluster, program))
    check("a node works", node is not None, queue(cluster))
    if node:
        cluster.kill_node(node)
    stored = count_stored(folder)
    # On the core that is idle now.
    local = subprocess.Popen([program, "render", "farm.yaml", "-o", "local", "--jobs", "1"], stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, text=True)

    last = run_mien(cluster, program, *engine)
    check("the clip is made all the same", last.returncode == 0 and "clip    out/farm/farm.mp4" in last.stdout,
          last.stderr + last.stdout + queue(cluster))
    print(f"        {stored} of {DRAWINGS} drawings were there when the node was lost; {time.monotonic() - begun:.0f} s in all")
    check("the lost task's drawings are traced by the job that makes the clip",
          re.search(r"48 drawings, [1-6] to trace", read(folder + "/slurm/clip.log")), read(folder + "/slurm/clip.log"))
    check("no drawing is missing", count_stored(folder) == DRAWINGS, str(count_stored(folder)))

    told = local.communicate()[1]
    check("a local run works", local.returncode == 0, told)
    frames = sorted(os.listdir("local/frames"))
    same, other, lost = filecmp.cmpfiles("local/frames", folder + "/frames", frames, shallow=False)
    check("all frames are those of a local run", len(same) == DRAWINGS and not other and not lost, f"{other} {lost}")
    check("so is the clip", filecmp.cmp("local/farm.mp4", folder + "/farm.mp4", shallow=False))
    check("nothing half-made is left", sorted(os.listdir(folder)) == ["farm.mp4", "frames", "manifest.json", "poster.png", "slurm", "store"]
          and not [name for name in os.listdir(folder + "/slurm") if name.startswith("part")], f"{os.listdir(folder)}")


def main():
    program = os.path.abspath(sys.argv[1])
    with open("farm.yaml", "w", encoding="utf-8") as file:
        file.write(CLIP)
    try:
        with Cluster("cluster") as cluster:
            try_all(cluster, program)
    except Missing as reason:
        print(f"skipped: {reason}")
        return
    print("FAILED" if failed else "all of it holds")
    sys.exit(1 if failed else 0)


main()
