# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the example programs random command lines for a while.

    fuzz_command_lines.py FOLDER [SECONDS] [SEED]    exits 1 with one line per command that crashed, hung, or
                                                     printed a number that is none beside "converged"
"""

import pathlib
import random
import re
import sys
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "examples"))
from programs import report, run_all  # noqa: E402

NUMBERS = ["0", "-1", "1", "nan", "inf", "1e300", "-1e300", "1e-300", "1e-9", "1e9", "0.1", "2.07e11", "", "x", "1e999"]
WORDS = ["paper", "mixed", "gauss3", "lobatto3", "cross-section", "continuum", "continuum-enhanced", "green", "stretch",
         "saint-venant", "eigen", "umfpack", "cholmod", "full", "best", "nothing", "", "-", "--", "\u03bb"]
COUNTS = ["1", "2", "3", "1,2", "0", "-1", "x", "1e3", "99999999999999999999"]
PROGRAMS = {  # numbers, words, counts; a motion is kept short unless --duration stands in the random part
    "cantilever": (["--length", "--width", "--height", "--young", "--shear", "--load-factor", "--force"],
                   ["--element", "--rule", "--transverse", "--section", "--solver", "--clamp", "--preset"],
                   ["--elements", "--steps"]),
    "semicircle": (["--length", "--width", "--height", "--young", "--moment-factor"],
                   ["--element", "--rule", "--transverse", "--solver", "--on", "--clamp"], ["--elements", "--steps"]),
    "twist": (["--torque", "--length", "--width", "--height", "--young", "--shear"],
              ["--element", "--rule", "--transverse", "--section", "--solver"], ["--elements", "--steps"]),
    "pendulum": (["--length", "--width", "--young", "--density", "--gravity", "--link", "--tolerance", "--rho"],
                 ["--element", "--rule", "--integrator"], ["--elements"]),
    "probe": (["--length", "--width", "--height", "--young", "--shear"], ["--element", "--rule", "--transverse"], []),
}
ALWAYS = {"cantilever": ["--csv", "--max-iterations", "20"], "semicircle": ["--csv", "--max-iterations", "20"],
          "twist": ["--csv", "--max-iterations", "20"],
          "pendulum": ["--csv", "--duration", "0.002", "--output-interval", "0.001", "--step", "1e-3"], "probe": []}
NO_NUMBER = re.compile(r"(?<![a-z_])[-+]?(nan|inf)(?![a-z_])")


def command(generator):
    program = generator.choice(list(PROGRAMS))
    numbers, words, counts = PROGRAMS[program]
    arguments = list(ALWAYS[program])
    for options, values in ((numbers, NUMBERS), (words, WORDS), (counts, COUNTS)):
        for option in generator.sample(options, min(len(options), generator.choice([0, 0, 1, 1, 2]))):
            arguments.append(f"{option}={generator.choice(values)}")
    text = ""
    if program == "probe":
        values = "0 0 0 1 0 0 0 1 0 0 0 1 2 0 0 1 0 0 0 1 0 0 0 1".split()
        for _ in range(generator.choice([0, 1, 3, 24])):
            values[generator.randrange(24)] = generator.choice(NUMBERS) or "0"
        text = " ".join(values)
    return program, arguments, text


def fault(run):
    """What is wrong with a run; None: nothing."""
    if run.code is None:
        return "no end"
    if run.code not in (0, 1, 2):
        return f"status {run.code}: {run.errors.strip()[-300:]}"
    if run.code == 2 and not run.errors.strip():
        return "refused without a word"
    for line in run.output.splitlines():
        if NO_NUMBER.search(line) and (run.code == 0 or "converged" in line):
            return f"a number that is none: {line[:200]}"
    return None


def main(folder, seconds="5", seed="1"):
    generator, end = random.Random(int(seed)), time.monotonic() + float(seconds)
    findings, count = [], 0
    while time.monotonic() < end:
        for run in run_all(folder, [command(generator) for _ in range(16)]):
            found = fault(run)
            if found is not None:
                findings.append(f"{run.command}: {found}")
            count += 1
    report(findings, count, f"random command lines, seed {seed}")


if __name__ == "__main__":
    main(*sys.argv[1:])
