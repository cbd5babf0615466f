#!/usr/bin/env python3
"""Puts small faults into a copy of sources of src/, one at a time, and tells which of them the tests let pass.

The faults stand in tests/mutants/ROOM.txt, one a paragraph:

    cue_comes_linearly cues.* timeline/cues.cpp
    A cue comes and goes at an even pace.
    - Easing::in_out
    + Easing::linear

Its name, the tests that should catch it (as GoogleTest has them), its file below src/; why it would be wrong; what
stands there and what stands there instead. What stands there is found exactly once in the file: a piece of one line,
either a whole expression, or whole statements up to their ";" (with nothing behind "+": they are left out). "+" may be
as many. A line "! REASON" says why no test can notice it.

All faults are built into one program, which asks the environment variable MIEN_MUTANT for the one to show: their
sources are compiled anew, all else is linked from build/, which must be there (./run mutants sees to it).
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
import shlex
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
SWITCH = """#include <cstdlib>
namespace {
inline bool is_mutant(unsigned number) {
  static const unsigned chosen = [] {
    const char* word = std::getenv("MIEN_MUTANT");
    return word == nullptr ? 0u : static_cast<unsigned>(std::strtoul(word, nullptr, 10));
  }();
  return chosen == number;
}
}  // namespace
#line 1
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


def write_switched_source(mutants, text):
    """A source with all its faults in it, each shown if it is asked for."""
    for mutant in sorted(mutants, key=lambda mutant: -text.find(mutant.old)):  # from the back
        before, after = text.split(mutant.old)
        text = before + write_switched(mutant) + after
    return SWITCH + text


def list_words(command):
    """A command of the build, in a hurry: the faults' sources are built more often than their own speed matters."""
    words = [word for word in shlex.split(command["command"]) if word != "-Werror" and not word.endswith("ccache")]
    return [words[0], "-w", *("-O1" if word == "-O3" else word for word in words[1:])]


def compile_header(command, folder):
    """The headers that most sources use, compiled once; where the sources find them, None if the build has none."""
    words = list_words(command)
    if "-include" not in words:
        return None
    at = words.index("-include")
    header = folder / "common.hpp"
    text = pathlib.Path(words[at + 1]).read_text()
    if header.is_file() and header.read_text() == text and pathlib.Path(f"{header}.gch").is_file():
        return header
    header.write_text(text)
    del words[at:at + 2]
    words = words[:words.index("-o")] + ["-x", "c++-header", "-o", f"{header}.gch", str(header)]
    subprocess.run(words, cwd=command["directory"], check=True)
    return header


def compile_source(command, source, target, state, header):
    """Compiles `source` as the build does another one, unless it has done so in the same `state`; what went wrong."""
    words = list_words(command)
    words[words.index("-o") + 1] = str(target)
    words[words.index("-c") + 1] = str(source)
    if header is not None and "-include" in words:
        words[words.index("-include") + 1] = str(header)
    made = target.with_suffix(".made")
    state = hashlib.sha256("\0".join([*words, source.read_text(), state]).encode()).hexdigest()
    if target.is_file() and made.is_file() and made.read_text() == state:
        return ""
    target.parent.mkdir(parents=True, exist_ok=True)
    done = subprocess.run(words, cwd=command["directory"], capture_output=True, text=True)
    if done.returncode == 0:
        made.write_text(state)
        return ""
    return done.stderr[:3000]


def link(name, places, objects, folder):
    """A program of build/ with other objects: `places` are old ones and what stands there instead."""
    words = shlex.split((ROOT / f"build/CMakeFiles/{name}.dir/link.txt").read_text())
    words = [str(places.get(word, word)) for word in words]
    words[words.index("-o") + 1] = str(folder / name)
    library = words.index("libmien_core.a")  # which is asked only for what the objects before it lack
    words[library:library] = map(str, objects)
    subprocess.run(words, cwd=ROOT / "build", check=True)


def build(mutants, folder, jobs):
    """folder/mien and folder/mien_tests, with all faults in them."""
    try:
        commands = json.loads((ROOT / "build/compile_commands.json").read_text())
    except FileNotFoundError:
        sys.exit("mutants: there is no build; ./run mutants makes it")
    commands = {command["file"]: command for command in commands if command["file"].startswith(str(ROOT) + "/")}
    state = hashlib.sha256()  # of all that a source may include
    for header in sorted([*(ROOT / "src").rglob("*.hpp"), *(ROOT / "src").rglob("*.inl")]):
        state.update(header.read_bytes())
    folder.mkdir(exist_ok=True)
    header = compile_header(commands[str(ROOT / "src/core/text.cpp")], folder)
    works, objects = [], {}
    for file in sorted({mutant.file for mutant in mutants}):
        original, source = ROOT / "src" / file, folder / "src" / file
        source.parent.mkdir(parents=True, exist_ok=True)
        source.write_text(write_switched_source([m for m in mutants if m.file == file], original.read_text()))
        objects[file] = folder / "objects" / (file + ".o")
        works.append((commands[str(original)], source, objects[file], state.hexdigest(), header))
    # The tests run the program with the faults.
    places = dict(commands[str(ROOT / "tests/places.cpp")])
    places["command"] = places["command"].replace(f"{ROOT}/build/mien", f"{folder}/mien")
    objects["places"] = folder / "objects/places.o"
    works.append((places, ROOT / "tests/places.cpp", objects["places"], "", None))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        errors = [error for error in pool.map(lambda work: compile_source(*work), works) if error]
    if errors:
        sys.exit("\n".join(errors) + "\nmutants: the build failed")
    inner = [path for file, path in objects.items() if file not in ("main.cpp", "places")]
    main_object = "CMakeFiles/mien.dir/src/main.cpp.o"
    link("mien", {main_object: objects.get("main.cpp", main_object)}, inner, folder)
    link("mien_tests", {"CMakeFiles/mien_tests.dir/tests/places.cpp.o": objects["places"]}, inner, folder)


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
    """What came out the last time, fault by fault, as long as neither the fault nor its source is another one."""

    def __init__(self, path):
        self.path, self.lock = path, threading.Lock()
        self.known = json.loads(path.read_text()) if path.is_file() else {}

    @staticmethod
    def key(mutant):
        text = "\0".join([mutant.tests, mutant.file, mutant.old, mutant.new, (ROOT / "src" / mutant.file).read_text()])
        return hashlib.sha256(text.encode()).hexdigest()

    def find(self, mutant):
        kept = self.known.get(mutant.id)
        return Ended(*kept["ended"]) if kept and kept["key"] == self.key(mutant) else None

    def keep(self, mutant, ended):
        with self.lock:
            self.known[mutant.id] = {"key": self.key(mutant), "ended": dataclasses.astuple(ended)}
            self.path.write_text(json.dumps(self.known, indent=1))


def write_report(mutants, results, described):
    """What is known of all faults, between the two marks of docs/soundness.md."""
    ended = {mutant.id: results.find(mutant) for mutant in mutants}
    tried = [mutant for mutant in mutants if ended[mutant.id]]
    caught = [mutant for mutant in tried if ended[mutant.id].is_caught]
    text = f"Of {described}: {len(caught)} of {len(tried)} faults are caught, {100 * len(caught) / len(tried):.1f} %"
    text += f"; {len(mutants) - len(tried)} more were not tried" if len(tried) < len(mutants) else ""
    text += ".\n\n| room | faults | tried | caught |\n|---|---|---|---|\n"
    for room in sorted({mutant.room for mutant in mutants}):
        counts = [sum(mutant.room == room for mutant in some) for some in (mutants, tried, caught)]
        text += f"| {room} | {counts[0]} | {counts[1]} | {counts[2]} |\n"
    alive = [mutant for mutant in tried if not ended[mutant.id].is_caught]
    if alive:
        text += "\nNot caught:\n\n"
    for mutant in alive:
        text += f"- `{mutant.id}`: {mutant.why} {mutant.excuse or 'No test says otherwise yet.'}\n"
    path = ROOT / "docs/soundness.md"
    begin, end = "<!-- ./run mutants writes what follows -->\n", "<!-- end of ./run mutants -->"
    page = path.read_text()
    before, rest = page.split(begin)
    path.write_text(before + begin + text + end + rest.split(end)[1])
    print("docs/soundness.md has the result.")


def main():
    parser = argparse.ArgumentParser(description="Puts small faults into a copy of src/ and runs the tests.")
    parser.add_argument("--check", action="store_true", help="only say what is wrong with the lists")
    parser.add_argument("--lists", type=pathlib.Path, default=pathlib.Path(__file__).parent, help="where they are")
    parser.add_argument("--only", default="", metavar="ID", help="those whose ROOM.NAME begins so, or so with commas between")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--build-only", action="store_true")
    parser.add_argument("--report", action="store_true", help="only write what is known into docs/soundness.md")
    parser.add_argument("--narrow", action="store_true", help="survivors are not tried on all tests that do not render")
    parser.add_argument("--go-on", action="store_true", help="what was caught the last time is not tried again")
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
    results = Results(folder / "results.json")
    git = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True)
    described = git.stdout.strip() or "a copy without history"
    if asked.report:
        return write_report(mutants, results, described)
    chosen = [mutant for mutant in mutants if mutant.id.startswith(tuple(asked.only.split(",")))]
    print(f"mutants: building {len(chosen)} faults in {folder.name}/", flush=True)
    files = {mutant.file for mutant in chosen}
    build([mutant for mutant in mutants if mutant.file in files], folder, asked.jobs)
    if asked.build_only:
        return
    program = folder / "mien_tests"
    wide = "*-" + ":".join(list_left_out())

    def find_known(mutant):
        known = results.find(mutant) if asked.go_on else None
        return known if known and known.is_caught else None

    # What fails without a fault says nothing of one. And how long each takes bounds the hung.
    filters = sorted({m.tests for m in chosen if not find_known(m)})
    sound = measure_sound(program, filters, asked.jobs) if filters else {}
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:

        def judge(mutant):
            known = find_known(mutant)
            if known:
                return known
            usual_s = sum(seconds for name, seconds in sound.items() if matches(mutant.tests, name))
            ended, _ = run_tests(program, mutant.tests, mutant.number, 60 + 5 * usual_s)
            if not ended.is_caught and not asked.narrow:
                ended, _ = run_tests(program, wide, mutant.number, 3600)
            results.keep(mutant, ended)
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
        write_report(mutants, results, described)
    sys.exit(0 if caught >= LEAST_CAUGHT * len(chosen) and not unexplained else 1)


if __name__ == "__main__":
    main()
