# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the example programs random command lines for a while.

    fuzz_command_lines.py FOLDER [SECONDS] [SEED]    exits 1 with one line per command that crashed, hung, ran out
                                                     of memory, or gave a number that is none as a result

The options and the names they allow are read from what each program prints for --help. The work a command asks for
is bounded: a few elements and iterations, at most some 3000 steps of a motion, 100 where a sanitizer slows programs
down, or so many that they must be refused.
"""

import os
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "examples"))
from programs import report, run_all  # noqa: E402

PROGRAMS = ["cantilever", "semicircle", "twist", "bend45", "princeton", "hanging_chain", "pendulum", "double_pendulum",
            "four_bar", "probe"]
MEMORY = 2 << 30  # bytes of one program
BATCH = 16
NUMBERS = ["0", "-1", "1", "nan", "inf", "1e300", "-1e300", "1e-300", "1e-9", "1e9", "0.1", "2.07e11", "", "x", "1e999"]
WORDS = ["", "nothing", "-", "--", "\u03bb", "paper paper", "PAPER", "0"]
COUNTS = ["0", "-1", "x", "1e3", "1.5", "", "1,", ",1", "99999999999999999999"]
ENDINGS = [".vtp", ".vtu", ".vtk", ".txt", ""]
NO_NUMBER = re.compile(r"(?<![a-z_])[-+]?(nan|inf)(?![a-z_])")
ENTRY = re.compile(r"^  (?:-h,)?(--[\w-]+)(?: ([A-Z][A-Z,.]*)(?:=(\S*))?)?")


class Option:
    """One option as --help shows it: a kind (None: a flag), its default, and the names it allows."""

    def __init__(self, name, kind, default, text):
        self.name, self.kind, self.default = name, kind, default
        self.names = re.split(r",\s+", text.rsplit(": ", 1)[-1].strip()) if kind == "NAME" else []


def options_of(folder, program):
    """The options of a program."""
    help_text = subprocess.run([pathlib.Path(folder) / program, "--help"], capture_output=True, text=True,
                               check=True).stdout
    entries = []
    for line in help_text.splitlines():
        found = ENTRY.match(line)
        if found:
            entries.append([*found.groups(), line[found.end():]])
        elif entries and line.startswith("   "):
            entries[-1][3] += " " + line.strip()
    found = [Option(*entry) for entry in entries if entry[0] != "--help"]
    if not found or any(option.kind == "NAME" and len(option.names) < 2 for option in found):
        sys.exit(f"fuzz_command_lines.py: the options of {program} were not understood:\n{help_text}")
    return found


class Fuzzer:
    """Draws commands; the same seed gives the same ones."""

    MOTION = ["--duration", "--step", "--output-interval"]  # drawn together
    FILES = ["--save", "--restart", "--vtk", "--shape", "--shapes"]

    def __init__(self, folder, seed, powers=(2.0, 3.5)):
        self.random = random.Random(seed)
        self.powers = powers  # of ten: usual and most steps of a motion
        self.programs = {program: options_of(folder, program) for program in PROGRAMS}
        self.count = 0

    def command(self):
        """A program, its arguments and its standard input."""
        program = self.random.choice(PROGRAMS)
        options = {option.name: option for option in self.programs[program]}
        self.count += 1
        wild = self.random.choice([0.0, 0.0, 0.1, 0.5])  # the share of values that are odd
        drawn = {name: self.file(program, name, wild) for name in self.FILES
                 if name in options and self.random.random() < 0.15}
        others = [name for name in options if name not in self.MOTION and name not in self.FILES]
        if "--restart" in drawn and self.random.random() < 0.7:
            others = ["--integrator", "--csv"]  # what the state fits
        others += 2 * [name for name in others if options[name].kind == "NAME"]  # they lead to the most code
        for name in self.random.sample(others, min(len(others), self.random.choice([0, 1, 1, 2, 2, 3, 4, 6]))):
            drawn[name] = self.value(options[name], wild)
        for name, value in [("--max-iterations", "20"), ("--elements", "2")]:
            if name in options:
                drawn.setdefault(name, value)
        if "--duration" in options:
            drawn.update(self.motion(wild))
        arguments = [name if value is None else f"{name}={value}" for name, value in drawn.items()]
        return program, arguments, self.coordinates(wild) if program == "probe" else ""

    def value(self, option, wild):
        """A value of an option's kind, or an odd one; None: the option is a flag."""
        odd = self.random.random() < wild
        if option.kind is None:
            return None
        if option.kind == "NAME":
            return self.random.choice(WORDS if odd else option.names)
        if option.kind.startswith("COUNT"):
            return self.random.choice(COUNTS) if odd else self.counts(option.kind != "COUNT")
        if option.kind == "X,Y,Z":
            return ",".join(self.number(option, odd) for _ in range(self.random.choice([2, 3, 4]) if odd else 3))
        return self.number(option, odd)

    def counts(self, several):
        """A small number, or some of them."""
        most = self.random.choice([1, 2, 8])
        return ",".join(str(self.random.randint(1, most)) for _ in range(self.random.randint(1, 3) if several else 1))

    def number(self, option, odd):
        """A number of the default's size, or an odd one."""
        if odd:
            return self.random.choice(NUMBERS)
        size = abs(float(option.default or "1")) or 1.0
        value = size * 10.0 ** self.random.choice([0.0, self.random.uniform(-0.3, 0.3), self.random.uniform(-3.0, 3.0)])
        return f"{value if self.random.random() < 0.95 else -value:.6g}"

    def motion(self, wild):
        """Duration, step and output interval: short, with few enough steps, or with one of them odd."""
        duration = 10.0 ** self.random.uniform(-4.0, -2.0)
        usual, most = self.powers
        steps = 10.0 ** self.random.choice([self.random.uniform(0.0, usual), self.random.uniform(usual, most)])
        values = {"--duration": duration, "--step": duration / steps,
                  "--output-interval": duration / self.random.choice([0.5, 1.0, 3.0, 10.0])}
        values = {name: f"{value:.6g}" for name, value in values.items()}
        if self.random.random() < wild:
            # what is long by request must be long enough to be refused
            odd = ["0", "-1", "nan", "inf", "", "x", "1e999", "1e-300", "1e300"]
            values[self.random.choice(self.MOTION)] = self.random.choice(odd)
        return values

    def file(self, program, option, wild):
        """A file to write, of its own for every command of a batch, or to read; or what is none."""
        if self.random.random() < wild:
            return self.random.choice(["", ".", "missing/file", "/dev/full", "state-cut", "state-other", "state-words"])
        if option == "--restart":
            return f"state-{program}"
        return f"out-{self.count % BATCH}{self.random.choice(ENDINGS)}"

    def coordinates(self, wild):
        """Coordinates of one element at rest, some of them changed; or too few, or too many."""
        values = "0 0 0 1 0 0 0 1 0 0 0 1 2 0 0 1 0 0 0 1 0 0 0 1".split()
        for _ in range(self.random.choice([0, 1, 3, 24])):
            near = f"{self.random.uniform(-2.0, 2.0):.6g}"
            values[self.random.randrange(24)] = self.random.choice(NUMBERS) if self.random.random() < wild else near
        if self.random.random() < 0.1 * wild:
            values = values[:self.random.randrange(24)] if self.random.random() < 0.5 else values + ["1"]
        return " ".join(values)


def prepare(folder):
    """Leaves states to go on from in the working folder: one of each program, one cut off, one with other bytes."""
    for program in ["pendulum", "double_pendulum"]:
        subprocess.run([folder / program, "--duration=0.002", "--elements=2", f"--save=state-{program}"],
                       capture_output=True, check=True)
    state = pathlib.Path("state-pendulum").read_bytes()
    pathlib.Path("state-cut").write_bytes(state[:len(state) // 2])
    pathlib.Path("state-other").write_bytes(state[:len(state) // 3] + b"\xff\x00nan" + state[len(state) // 3 + 5:])
    pathlib.Path("state-words").write_text("no state\n", encoding="utf-8")


def limit_memory(folder):
    """Limits the memory of what is started from here; returns whether the programs are free of sanitizers."""
    os.environ["ASAN_OPTIONS"] = f"{os.environ.get('ASAN_OPTIONS', '')}:hard_rss_limit_mb={MEMORY >> 20}".lstrip(":")
    usual, most = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, most))
    run = subprocess.run([folder / PROGRAMS[0], "--help"], capture_output=True, check=False)
    if run.returncode != 0:  # a sanitizer keeps account in a far larger space of addresses
        resource.setrlimit(resource.RLIMIT_AS, (usual, most))
    return run.returncode == 0


def written():
    """The files of the last batch; forgotten once they were looked at."""
    for path in sorted(pathlib.Path().glob("out-*")):
        for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
            if file.is_file():
                yield path.name, file.read_text(encoding="utf-8", errors="replace")
                file.unlink()


def fault(run, files):
    """What is wrong with a run and the files it wrote; None: nothing."""
    if run.code is None:
        return "no end"
    if "bad_alloc" in run.errors or "rss limit" in run.errors:
        return f"out of memory: {run.errors.strip()[-300:]}"
    if run.code not in (0, 1, 2):
        return f"status {run.code}: {run.errors.strip()[-300:]}"
    if run.code == 2 and not run.errors.strip():
        return "refused without a word"
    good = run.code == 0 or ": converged at t" in run.errors
    for line in run.output.splitlines():
        if NO_NUMBER.search(line) and (good or "converged" in line):
            return f"a number that is none: {line[:200]}"
    for name, text in files:
        found = NO_NUMBER.search(text) if run.code == 0 and name in run.command else None
        if found:
            return f"a number that is none in {name}: {text[max(0, found.start() - 80):found.end()]}"
    return None


def main(folder, seconds="5", seed="1"):
    folder = pathlib.Path(folder).resolve()
    findings, count = [], 0
    with tempfile.TemporaryDirectory() as name:
        os.chdir(name)
        fast = limit_memory(folder)
        prepare(folder)
        fuzzer = Fuzzer(folder, int(seed), (2.0, 3.5) if fast else (1.0, 2.0))
        end = time.monotonic() + float(seconds)
        while time.monotonic() < end:
            runs = run_all(folder, [fuzzer.command() for _ in range(BATCH)])
            files = list(written())
            for run in runs:
                found = fault(run, files)
                if found is not None:
                    findings.append(f"{run.command}: {found}")
                count += 1
        os.chdir(folder)
    report(findings, count, f"random command lines, seed {seed}")


if __name__ == "__main__":
    main(*sys.argv[1:])
