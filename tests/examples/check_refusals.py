# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the example programs command lines and coordinates that cannot be meant.

    check_refusals.py FOLDER    exits 1 with one line per program that did not refuse as it should

Each must end with status 2, print nothing on stdout, and name the option and the value on stderr.
"""

import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
from programs import report, run_all  # noqa: E402

STATICS = ["cantilever", "semicircle", "twist"]
ALL = STATICS + ["probe"]
MOTIONS = ["pendulum", "double_pendulum"]
OTHERS = {  # further programs: options of a positive number, of a count, of one word
    "pendulum": (["--length", "--density", "--link", "--tolerance", "--step", "--duration", "--output-interval"],
                 ["--elements"], ["--element", "--rule", "--integrator", "--preset"]),
    "double_pendulum": (["--length", "--density", "--tolerance", "--step", "--duration", "--output-interval"],
                        ["--elements"], ["--element", "--rule", "--integrator", "--preset"]),
    "bend45": ([], ["--elements", "--steps", "--max-iterations"], ["--element", "--rule", "--solver", "--clamp"]),
    "four_bar": (["--step", "--duration", "--output-interval"], ["--elements"], []),
    "hanging_chain": (["--span", "--length", "--stiffness"], ["--elements", "--steps"], ["--element", "--rule", "--solver"]),
    "lattice": ([], ["--elements", "--steps", "--max-iterations"], ["--load", "--solver"]),
    "net": ([], ["--along", "--across", "--elements", "--steps"], ["--solver"]),
    "princeton": ([], ["--elements", "--steps", "--max-iterations"], ["--rule", "--solver"]),
}

NO_NUMBER = ["abc", "", " ", "1.5m", "1,5", "nan", "inf", "-inf", "1e999", "--"]
NOT_POSITIVE = ["0", "-1", "-1e-300", "1e-999"]
NO_COUNT = ["0", "-4", "2.5", "1e2", "many", "", "99999999999999999999", "nan", "0x4", "4 "]
POSITIVE = ["--length", "--width", "--height", "--young", "--shear", "--shear-correction"]
CHOICES = {
    "--element": (ALL, ["beam", "Cross-Section", "continuum_hooke", "", "cross-section-2"]),
    "--rule": (ALL, ["gauss2", "paper ", "7", ""]),
    "--directors": (ALL, ["straight", ""]),
    "--transverse": (ALL, ["Green", "engineering", ""]),
    "--section": (ALL, ["circle", "saint venant", ""]),
    "--preset": (ALL, ["worst", ""]),
    "--clamp": (STATICS, ["free", "none", ""]),
    "--solver": (STATICS, ["pardiso", "CHOLMOD", ""]),
    "--on": (["semicircle"], ["r_z", "r", "3", ""]),
}

REFERENCE = "0 0 0  1 0 0  0 1 0  0 0 1   2 0 0  1 0 0  0 1 0  0 0 1".split()


def with_coordinate(index, text):
    return " ".join(REFERENCE[:index] + [text] + REFERENCE[index + 1:])


def missing_or_wrong(option, value):
    """An option with a wrong value, or without one."""
    return ([f"{option}={value}"], [option, f'"{value}"']) if value else ([option], [option, "missing"])


def option_cases():
    """(program, arguments, words that stderr must hold) for every wrong value of every option."""
    for program in ALL:
        for option in POSITIVE:
            # one program sees every wrong value of an option, the others a few
            values = NO_NUMBER + NOT_POSITIVE if program == "cantilever" else ["nan", "-1", "0", "x"]
            for value in values:
                yield program, *missing_or_wrong(option, value)
    for program, option in [("cantilever", "--load-factor"), ("semicircle", "--moment-factor"),
                            ("twist", "--torque")]:
        for value in NO_NUMBER:
            yield program, *missing_or_wrong(option, value)
    for program in STATICS:
        for option in ["--elements", "--steps", "--max-iterations"]:
            for value in NO_COUNT:
                yield program, [option, value], [option, value.strip()]
        for value in ["1,,2", ",1", "1,2,", "1,0", "2,-3", "1;2", "100001", "1,two"]:
            yield program, ["--elements", value], ["--elements"]
    yield "cantilever", ["--model", "3"], ["--model", "3"]
    yield "cantilever", ["--model", "II"], ["--model", "II"]
    for value in ["1", "1,2", "1,2,3,4", "1,2,x", "1,nan,0", "inf,0,0", "", ",,", "0,1e999,0"]:
        wrong = next((part for part in ["x", "nan", "inf", "1e999"] if part in value), "")
        yield "cantilever", ["--force", value], ["--force", f'{wrong}"']
    for option, (programs, values) in CHOICES.items():
        for program in programs:
            for value in values:
                yield program, [option, value], [option, f'"{value}"']


def line_cases():
    """Command lines that are wrong as a whole."""
    for program in ALL:
        yield program, ["--lenght", "1"], ["--lenght"]
        yield program, ["stray"], ["stray"]
        yield program, ["-q"], ["-q"]
        yield program, ["--length"], ["--length"]
        yield program, ["--length", "1", "--length", "2"], ["--length"]
        yield program, ["--vtk", ""], ["--vtk"]
        yield program, ["--vtk", "beam.stl"], ["beam.stl", ".vtp"]
        yield program, ["--vtk", "beam"], ["beam", ".vtp"]
        yield program, ["--element", "continuum-hooke", "--shear", "1"], ["Poisson"]
    for program in STATICS:
        yield program, ["--csv=perhaps"], ["csv"]
        yield program, ["--adaptive=7"], ["adaptive"]
        yield program, ["--elements", "1", "--vtk", "/no/such/folder/beam.vtp"], ["/no/such/folder/beam.vtp"]
        yield program, ["--elements", "1", "--shape", "/no/such/folder/beam.csv"], ["/no/such/folder/beam.csv"]
        yield program, ["--csv", "--shape", "/no/such/folder/beam.csv"], ["/no/such/folder/beam.csv"]
        yield program, ["--elements", "1", "--vtk", "x.vtp", "--shape", "./x.vtp"], ["--vtk", "--shape", "same file"]
    yield "lattice", ["--vtk", "x.vtp", "--lines", "x.vtp"], ["--vtk", "--lines", "same file"]
    yield "cantilever", ["--force", "0,1,0", "--load-factor", "1"], ["--force", "--load-factor"]
    for joints in ["2.5,3,3", "0,1,2", "1,1,1", "3,3"]:
        yield "lattice", ["--joints", joints], ["--joints"]


def element_cases():
    """Options that an element has no use for."""
    for element in ["continuum", "cable", "cable-2d", "continuum-2d", "cross-section-2d", "cross-section-pointwise"]:
        for directors in ["transported", "geodesic"]:
            yield "cantilever", ["--element", element, "--directors", directors], [f"--directors {directors}", element]
    for element in ["continuum", "cable", "cable-2d", "continuum-2d"]:
        yield "semicircle", ["--element", element, "--transverse", "stretch"], ["--transverse stretch", element]
        yield "pendulum", ["--element", element, "--section", "saint-venant"], ["--section saint-venant", element]
    for element in ["cable", "cable-2d"]:
        yield "semicircle", ["--element", element, "--on", "r_y"], ["--on r_y", element]
        yield "cantilever", ["--element", element, "--clamp", "free-slope"], ["--clamp free-slope", element]
    for element in ["cross-section-2d", "continuum-2d", "cable-2d"]:
        yield "cantilever", ["--element", element, "--force", "0,1,2"], ["--force", element]
        yield "twist", ["--element", element], ["--element", element]
        yield "bend45", ["--element", element], ["--element", element]
    yield "cantilever", ["--rule", "cable"], ["--rule cable", "cross-section"]
    yield "cantilever", ["--model", "1", "--element", "cable"], ["equally"]  # a flat section has no place in it


def other_cases():
    """The same mistakes in every other program, and files that cannot be read or written."""
    for program, (positive, counts, choices) in OTHERS.items():
        for option in positive:
            for value in ["nan", "-1", "0", "x", "inf", "1e999"]:
                yield program, *missing_or_wrong(option, value)
        for option in counts:
            for value in ["0", "-4", "2.5", "many", "nan", "99999999999999999999"]:
                yield program, [option, value], [option, value]
        for option in choices:
            for value in ["none of them", "7"]:
                yield program, [option, value], [option, f'"{value}"']
        yield program, ["--lenght", "1"], ["--lenght"]
        yield program, ["stray"], ["stray"]
    for option in ["--step", "--output-interval"]:
        yield "four_bar", [option, "1e-20"], [option, "too short"]
    for program in MOTIONS:
        yield program, ["--restart", "/no/such/folder/state"], ["/no/such/folder/state"]
        yield program, ["--duration", "1e-3", "--save", "/no/such/folder/state"], ["/no/such/folder/state"]
        yield program, ["--duration", "1e-3", "--save", "x", "--shapes", "./x"], ["--shapes", "--save", "same file"]
        yield program, ["--restart", "x", "--shapes", "x"], ["--shapes", "--restart", "same file"]


def coordinate_cases():
    """(arguments, stdin, words that stderr must hold) for the probe."""
    whole = " ".join(REFERENCE)
    yield [], "", ["24", "got 0"]
    yield [], " ".join(REFERENCE[:23]), ["24", "got 23"]
    yield [], "\n \t\n", ["got 0"]
    yield [], whole + " 7", ["24", "7"]
    yield [], whole + " x", ["24", "x"]
    for index, text in [(0, "nan"), (5, "inf"), (12, "-inf"), (23, "NaN"), (3, "1e999"), (7, "one"),
                        (8, "1,0"), (20, "0x"), (13, "1.0.0"), (1, "--"), (2, "1e"), (9, ";")]:
        yield [], with_coordinate(index, text), [f"coordinate {index + 1}", text]
    yield [], " ".join(["0"] * 24), ["degenerate"]
    yield [], with_coordinate(7, "0"), ["degenerate"]                        # r_y of no length
    yield [], with_coordinate(3, "0"), ["degenerate"]                        # r_x of no length
    yield [], "0 0 0  1 0 0  1 0 0  0 0 1   2 0 0  1 0 0  0 1 0  0 0 1", ["degenerate"]
    yield [], "0 0 0  1 0 0  0 1 0  -2 0 0   2 0 0  1 0 0  0 1 0  0 0 1", ["degenerate"]
    half_turn = "0 0 0  1 0 0  0 1 0  0 0 1   2 0 0  1 0 0  0 -1 0  0 0 -1"  # no slope is left halfway
    for rule in ["paper", "gauss4", "mixed", "lobatto3", "gauss3", "gauss5"]:
        yield ["--rule", rule], half_turn, ["degenerate"]
    yield ["--element", "continuum"], "0 0 0  1 0 0  0 1 0  0 1 0   2 0 0  1 0 0  0 1 0  0 0 1", ["degenerate"]
    yield ["--element", "continuum"], with_coordinate(7, "-1"), ["degenerate"]
    for element in ["cross-section", "cross-section-pointwise", "continuum"]:
        yield ["--element", element], with_coordinate(12, "1e200"), ["overflows"]
        yield ["--element", element], with_coordinate(4, "1e300"), ["overflows"]
        stiff = ["--young", "1e308", "--width", "10", "--height", "10"]
        yield ["--element", element, *stiff], with_coordinate(12, "2.5"), ["finite"]


def lost_output(folder):
    """What standard output does not take must not end as a success."""
    if not pathlib.Path("/dev/full").exists():
        return
    commands = [(["cantilever"], ""), (["cantilever", "--help"], ""), (["table_1"], ""), (["probe"], " ".join(REFERENCE))]
    for (program, *options), text in commands:
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([pathlib.Path(folder) / program, *options], input=text, text=True, stdout=full,
                                  stderr=subprocess.PIPE, check=False)
        if done.returncode != 2 or "standard output" not in done.stderr:
            yield f"{program} {options} > /dev/full: status {done.returncode}, {done.stderr.strip()!r}"


def main(folder):
    cases = [(program, arguments, "", words)
             for program, arguments, words in [*option_cases(), *line_cases(), *element_cases(), *other_cases()]]
    cases += [("probe", arguments, text, words) for arguments, text, words in coordinate_cases()]
    findings = []
    runs = run_all(folder, [case[:3] for case in cases])
    for (_, _, text, words), run in zip(cases, runs):
        shown = run.command + (f" <<< {text!r}" if text else "")
        if run.code != 2:
            findings.append(f"{shown}: status {run.code}, expected 2; {run.errors.strip()[:200]}")
        elif run.output:
            findings.append(f"{shown}: wrote on stdout: {run.output[:60]!r}")
        elif not run.errors.strip() or not all(word in run.errors for word in words):
            findings.append(f"{shown}: the message lacks {words}: {run.errors.strip()!r}")
    findings += lost_output(folder)
    if len(cases) < 600:
        findings.append(f"only {len(cases)} wrong calls were made")
    report(findings, len(cases), "wrong calls")


if __name__ == "__main__":
    main(sys.argv[1])
