#!/usr/bin/env python3
"""Puts small faults into a copy of src/, one at a time, and tells which of them the tests let pass.

The faults stand in tests/mutants/ROOM.txt, one a paragraph:

    cue_comes_linearly cues.* timeline/cues.cpp
    A cue comes and goes at an even pace.
    - ease(Easing::in_out, compute_led_fraction(
    + ease(Easing::linear, compute_led_fraction(

Its name, the tests that should catch it (as GoogleTest has them), its file below src/; why it would be wrong; what
stands there and what stands there instead. What stands there is found exactly once in the file: a piece of one line,
either a whole expression, or whole statements up to their ";" (with nothing behind "+": they are left out). "+" may be
as many. A line "! REASON" says why no test can notice it.

All faults are built into one program, which asks the environment variable MIEN_MUTANT for the one to show.
"""
import argparse
import concurrent.futures
import dataclasses
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEAST = 120  # faults; fewer say little of this many sources
LEAST_CAUGHT = 0.95
SWITCH = """// Written by tests/mutants/mutants.py.
#pragma once
#include <cstdlib>
namespace {
inline bool is_mutant(unsigned number) {
  static const unsigned chosen = [] {
    const char* word = std::getenv("MIEN_MUTANT");
    return word == nullptr ? 0u : static_cast<unsigned>(std::strtoul(word, nullptr, 10));
  }();
  return chosen == number;
}
}  // namespace
"""


@dataclasses.dataclass(order=True)
class Mutant:
    room: str
    name: str
    tests: str
    file: str
    why: str
    old: str = ""
    new: str = ""
    excuse: str = ""

    @property
    def id(self):
        return f"{self.room}.{self.name}"

    @property
    def number(self):
        return zlib.crc32(self.id.encode()) | 1  # 0 is none


def load_mutants(folder):
    """All faults by room and place in the list, and what is wrong with the lists."""
    mutants, faults = [], []
    for path in sorted(folder.glob("*.txt")):
        for paragraph in re.split(r"\n\s*\n", path.read_text()):
            lines = [line for line in paragraph.split("\n") if line.strip() and not line.startswith("#")]
            if not lines:
                continue
            words = lines[0].split()
            signs = "".join(line[0] if line[:2] in ("- ", "+ ", "+", "! ") else "w" for line in lines[1:])
            if len(words) != 3 or not re.fullmatch(r"w-\+!?", signs):
                faults.append(f"{path.name}: '{lines[0]}': expected NAME TESTS FILE, why, - OLD, + NEW")
                continue
            why, old, new = lines[1], lines[2][2:].strip(), lines[3][2:].strip()
            mutants.append(Mutant(path.stem, *words, why, old, new, lines[4][2:] if len(lines) > 4 else ""))
    return mutants, faults


def check_mutants(mutants, source):
    """What is wrong with the faults against the sources below `source`."""
    faults, names = [], set()
    for mutant in mutants:
        path = source / mutant.file
        if mutant.id in names:
            faults.append(f"{mutant.id} stands twice")
        names.add(mutant.id)
        if path.suffix != ".cpp" or not path.is_file():
            faults.append(f"{mutant.id}: there is no source {mutant.file}")
        elif mutant.file.split("/")[0].removesuffix(".cpp") != mutant.room:
            faults.append(f"{mutant.id}: {mutant.file} is of another room")
        elif (count := path.read_text().count(mutant.old)) != 1:
            faults.append(f"{mutant.id}: {mutant.file} has '{mutant.old}' {count} times")
        elif mutant.old == mutant.new:
            faults.append(f"{mutant.id} changes nothing")
        elif not is_whole(mutant):
            faults.append(f"{mutant.id}: '{mutant.old}' is neither an expression nor a statement without declarations")
    by_file = {}
    for mutant in mutants:
        by_file.setdefault(mutant.file, []).append(mutant)
    for file, mine in by_file.items():
        text = (source / file).read_text() if (source / file).is_file() else ""
        places = sorted((text.find(mutant.old), mutant) for mutant in mine)
        for (begin, first), (next_begin, second) in zip(places, places[1:]):
            if 0 <= begin and next_begin < begin + len(first.old):
                faults.append(f"{first.id} and {second.id} change the same place")
    rooms = {path.name for path in source.iterdir() if path.is_dir()}
    for room in sorted(rooms - {mutant.room for mutant in mutants}):
        faults.append(f"no fault in the room {room}")
    return faults


def is_statement(mutant):
    return mutant.old.endswith((";", "}"))


def is_whole(mutant):
    """As far as is seen without reading C++."""
    code = re.sub(r"'(?:[^'\\]|\\.)'|" + r'"(?:[^"\\]|\\.)*"', "", mutant.old)
    if any(code.count(a) != code.count(b) for a, b in ("()", "[]", "{}")):
        return False
    if is_statement(mutant):
        return not re.match(r"(?:const|auto|static|constexpr)\b|[\w:<>]+[&*]* \w+(?: =|;|\{)", code) or \
            code.startswith(("return ", "throw "))
    return ";" not in code and not re.match(r"(?:if|for|while|return|const|else)\b", code)


def write_switched(mutant):
    if is_statement(mutant):
        return f"{{ if (is_mutant({mutant.number}u)) {{ {mutant.new} }} else {{ {mutant.old} }} }}"
    return f"(is_mutant({mutant.number}u) ? ({mutant.new}) : ({mutant.old}))"


def write_if_new(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_bytes() != text.encode():
        path.write_text(text)


def make_checkout(mutants, checkout):
    """The project as links, but for src/, which is a copy with all faults in it."""
    checkout.mkdir(parents=True, exist_ok=True)
    for entry in ROOT.iterdir():
        link = checkout / entry.name
        if entry.name in ("src", "out", ".git") or entry.name.startswith("build") or link.is_symlink():
            continue
        link.symlink_to(entry)
    wanted = set()
    for path in (ROOT / "src").rglob("*"):
        if not path.is_file():
            continue
        name = path.relative_to(ROOT / "src")
        wanted.add(checkout / "src" / name)
        text = path.read_text()
        mine = [mutant for mutant in mutants if mutant.file == name.as_posix()]
        for mutant in sorted(mine, key=lambda mutant: -text.find(mutant.old)):  # from the back
            before, after = text.split(mutant.old)
            text = before + write_switched(mutant) + after
        if mine:
            text = '#include "mutant_switch.hpp"\n#line 1\n' + text
        write_if_new(checkout / "src" / name, text)
    write_if_new(checkout / "src/mutant_switch.hpp", SWITCH)
    wanted.add(checkout / "src/mutant_switch.hpp")
    for path in (checkout / "src").rglob("*"):
        if path.is_file() and path not in wanted:
            path.unlink()


def build(checkout, folder, jobs):
    """Without optimising much; the log stays beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    log = folder / "mutants.log"
    configure = ["cmake", "-S", checkout, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DMIEN_BENCH=OFF",
                 "-DMIEN_WERROR=OFF", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -w"]
    make = ["nice", "-n", "5", "cmake", "--build", folder, "-j", str(jobs), "--target", "mien", "mien_tests", "--", "-k"]
    with open(log, "w") as out:
        for command in (configure, make):
            if subprocess.run(command, stdout=out, stderr=subprocess.STDOUT).returncode != 0:
                text = log.read_text()
                errors = re.findall(r".*(?:error:|Error).*(?:\n.*){0,3}", text)
                sys.exit("\n".join(errors[:8] or [text[-2000:]]) + f"\nmutants: the build failed (all of it: {log})")


def list_left_out():
    """What neither tells of src/ nor runs without rendering: 'suite.test'."""
    tests = []
    for folder in ("end_to_end", "house"):
        for path in (ROOT / "tests" / folder).glob("*.cpp"):
            tests += [".".join(words) for words in re.findall(r"^TEST\((\w+), (\w+)\)", path.read_text(), re.M)]
    return tests


@dataclasses.dataclass
class Ended:
    is_caught: bool
    by: str  # the test that failed, or how it ended
    seconds: float


def run_tests(program, tests, number, limit_s, more=None):
    """Runs some tests with one fault shown; 0 is none. What it comes to, and what was printed."""
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="mien-mutant-") as scratch:
        environment = dict(os.environ, MIEN_MUTANT=str(number), TEST_TMPDIR=scratch + "/", TMPDIR=scratch, **(more or {}))
        command = [program, f"--gtest_filter={tests}", "--gtest_fail_fast"]

        def bound():
            resource.setrlimit(resource.RLIMIT_AS, (12 << 30, 12 << 30))  # one that eats memory is caught, too
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        with open(scratch + "/log", "w+", errors="replace") as log:
            process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, env=environment, cwd=scratch,
                                       start_new_session=True, preexec_fn=bound)
            try:
                status = process.wait(limit_s)
            except subprocess.TimeoutExpired:
                status = None
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()
            log.seek(0)
            text = log.read()
    seconds = time.monotonic() - began
    if status == 0:
        return Ended(False, "", seconds), text
    failed = re.search(r"\[  FAILED  \] (\w+\.\w+)", text)
    by = failed[1] if failed else "it hung" if status is None else f"it ended with {status}"
    return Ended(True, by, seconds), text


def matches(filters, name):
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in filters.split(":"))


def measure_sound(program, filters, jobs):
    """The seconds of each test that any of the filters names, without a fault; ends if one fails."""
    names, suite = [], ""
    for line in subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True).stdout.split("\n"):
        if re.fullmatch(r"\w+\.", line):
            suite = line
        elif line.startswith("  "):
            names.append(suite + line.strip())
    unknown = [one for one in filters if not any(matches(one, name) for name in names)]
    if unknown:
        sys.exit("mutants: no test is called " + ", ".join(unknown))
    wanted = ":".join(name for name in names if any(matches(one, name) for one in filters))

    def run(shard):
        return run_tests(program, wanted, 0, 3600, {"GTEST_TOTAL_SHARDS": str(jobs), "GTEST_SHARD_INDEX": str(shard)})

    seconds = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for ended, text in pool.map(run, range(jobs)):
            if ended.is_caught:
                sys.exit(f"mutants: without any fault this fails: {ended.by}\n{text[-3000:]}")
            seconds.update((name, int(ms) / 1000) for name, ms in re.findall(r" (\w+\.\w+) \((\d+) ms\)", text))
    return seconds


class Results:
    """What came out, kept for the next time; a fault or a program that changed is tried again."""

    def __init__(self, path, program):
        self.path, self.lock = path, threading.Lock()
        digest = hashlib.sha256()
        for file in (program, program.parent / "mien"):
            digest.update(file.read_bytes())
        self.program = digest.hexdigest()
        self.known = json.loads(path.read_text()) if path.is_file() else {}

    def key(self, mutant, wide):
        text = "\0".join([self.program, mutant.tests, mutant.file, mutant.old, mutant.new, str(wide)])
        return hashlib.sha256(text.encode()).hexdigest()

    def find(self, mutant, wide):
        kept = self.known.get(mutant.id)
        return Ended(*kept["ended"]) if kept and kept["key"] == self.key(mutant, wide) else None

    def keep(self, mutant, wide, ended):
        with self.lock:
            self.known[mutant.id] = {"key": self.key(mutant, wide), "ended": dataclasses.astuple(ended)}
            self.path.write_text(json.dumps(self.known, indent=1))


def write_report(mutants, ended, described):
    """Between the two marks of docs/soundness.md."""
    rooms = {}
    for mutant in mutants:
        caught, count = rooms.get(mutant.room, (0, 0))
        rooms[mutant.room] = (caught + ended[mutant.id].is_caught, count + 1)
    total = sum(caught for caught, _ in rooms.values())
    text = f"Of {described}: {total} of {len(mutants)} faults are caught, {100 * total / len(mutants):.1f} %.\n\n"
    text += "| room | faults | caught |\n|---|---|---|\n"
    text += "".join(f"| {room} | {count} | {caught} |\n" for room, (caught, count) in sorted(rooms.items()))
    alive = [mutant for mutant in mutants if not ended[mutant.id].is_caught]
    if alive:
        text += "\nNot caught:\n\n"
    for mutant in alive:
        text += f"- `{mutant.id}`: {mutant.why} {mutant.excuse or 'No test says otherwise yet.'}\n"
    path = ROOT / "docs/soundness.md"
    begin, end = "<!-- ./run mutants writes what follows -->\n", "<!-- end of ./run mutants -->"
    page = path.read_text()
    before, rest = page.split(begin)
    path.write_text(before + begin + text + end + rest.split(end)[1])


def main():
    parser = argparse.ArgumentParser(description="Puts small faults into a copy of src/ and runs the tests.")
    parser.add_argument("--check", action="store_true", help="only say what is wrong with the lists")
    parser.add_argument("--lists", type=pathlib.Path, default=pathlib.Path(__file__).parent, help="where they are")
    parser.add_argument("--only", default="", metavar="ID", help="those whose ROOM.NAME begins so")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--build-only", action="store_true")
    parser.add_argument("--narrow", action="store_true", help="survivors are not tried on all tests that do not render")
    asked = parser.parse_args()

    mutants, faults = load_mutants(asked.lists)
    faults += check_mutants(mutants, ROOT / "src")
    if len(mutants) < LEAST:
        faults.append(f"there are {len(mutants)} faults, fewer than {LEAST}")
    if faults:
        sys.exit("\n".join(faults))
    if asked.check:
        return
    folder = ROOT / "build-mutants"
    print(f"mutants: building {len(mutants)} faults in {folder.name}/; the first time takes a while", flush=True)
    make_checkout(mutants, folder / "checkout")
    build(folder / "checkout", folder / "build", asked.jobs)
    if asked.build_only:
        return
    program = folder / "build/mien_tests"
    wide = "*-" + ":".join(list_left_out())
    chosen = [mutant for mutant in mutants if mutant.id.startswith(asked.only)]
    results = Results(folder / "results.json", program)

    # What fails without a fault says nothing of one. And how long each takes bounds the hung.
    filters = sorted({m.tests for m in chosen if not results.find(m, not asked.narrow)})
    sound = measure_sound(program, filters, asked.jobs) if filters else {}
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:

        def judge(mutant):
            known = results.find(mutant, not asked.narrow)
            if known:
                return known
            usual_s = sum(seconds for name, seconds in sound.items() if matches(mutant.tests, name))
            ended, _ = run_tests(program, mutant.tests, mutant.number, 60 + 5 * usual_s)
            if not ended.is_caught and not asked.narrow:
                ended, _ = run_tests(program, wide, mutant.number, 3600)
            results.keep(mutant, not asked.narrow, ended)
            return ended

        ended = {}
        for mutant, result in zip(chosen, pool.map(judge, chosen)):
            ended[mutant.id] = result
            print(f"{'caught' if result.is_caught else 'ALIVE ':7}{mutant.id:45}{result.seconds:7.1f} s  "
                  f"{result.by if result.is_caught else mutant.excuse or mutant.why}", flush=True)
    caught = sum(result.is_caught for result in ended.values())
    print(f"{caught} of {len(chosen)} faults are caught, {100 * caught / max(1, len(chosen)):.1f} %")
    unexplained = [m.id for m in chosen if not ended[m.id].is_caught and not m.excuse]
    if unexplained:
        print("without a reason: " + ", ".join(unexplained))
    if len(chosen) == len(mutants):
        git = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True)
        write_report(mutants, ended, git.stdout.strip() or "a copy without history")
        print("docs/soundness.md has the result.")
    sys.exit(0 if caught >= LEAST_CAUGHT * len(chosen) and not unexplained else 1)


if __name__ == "__main__":
    main()
