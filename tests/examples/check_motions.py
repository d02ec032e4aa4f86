# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the motions of the pendulum programs with known ones: heights, energy, constraints, restarts.

    check_motions.py FOLDER    exits 1 with one line per value that is wrong
"""

import math
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True
from check_results import Checks  # noqa: E402
from programs import report, run_all  # noqa: E402

HEADER = "t,x,y,z,kinetic,strain,potential,total,constraint,constraint_rate"
FIXED = ["generalized-alpha", "energy"]
IDA = ["ida-index3", "ida-ggl"]

# tip height of four elements, exact in time
HEIGHTS = {0.2: -0.194023, 0.5: -1.303027, 0.8: -0.766241, 1.2: 0.170784}
# tip (x, y) on the finest meshes
LIMIT = {0.3: (1.082058, -0.446681), 0.5: (0.337547, -1.301135), 0.7: (-0.696049, -1.011694), 1.0: (-1.188550, -0.128545)}
STEPS = r"(\d+) steps"
STEEL = ["--young", "2.07e11", "--shear", "7.9615e10", "--length", "2", "--width", "0.01", "--height", "0.01",
         "--density", "7850"]


class Motion:
    """One run of a program with CSV output."""

    def __init__(self, checks, run):
        checks.expect(run.code == 0, f"{run.command}: status {run.code}; {run.errors}")
        checks.expect(run.header() == HEADER, f"{run.command}: header {run.header()}")
        self.name, self.errors = run.command, run.errors
        rows = run.rows() if run.code == 0 else []
        self.rows = [{key: float(value) for key, value in row.items()} for row in rows]
        self.kinetic = max(row["kinetic"] for row in self.rows) if self.rows else math.nan

    def at(self, time):
        return min(self.rows, key=lambda row: abs(row["t"] - time), default=dict.fromkeys(HEADER.split(","), math.nan))

    def largest(self, column):
        return max((abs(row[column]) for row in self.rows), default=math.nan)

    def said(self, pattern):
        """A number of the summary on stderr."""
        found = re.search(pattern, self.errors)
        return float(found.group(1)) if found else math.nan


def motions(checks, cases):
    """The motions of (program, arguments), side by side."""
    runs = run_all(checks.folder, [(program, ["--csv", *arguments]) for program, arguments in cases])
    return [Motion(checks, run) for run in runs]


def check_heights(checks, integrators):
    for name, motion in zip(integrators, motions(checks, [("pendulum", ["--integrator", name]) for name in integrators])):
        for time, height in HEIGHTS.items():
            checks.near(motion.at(time)["y"], height, 2e-5 if name in IDA else 2e-4, f"{motion.name} at {time} s")
        # 5e-7 measured, and less
        checks.expect(motion.largest("total") <= 1e-5 * motion.kinetic, f"{motion.name}: energy {motion.largest('total')}")
        checks.expect(motion.largest("z") <= 1e-12, f"{motion.name}: leaves the plane by {motion.largest('z')}")
        checks.near(motion.largest("potential"), 114.0, 2.0, f"{motion.name}: potential energy")


def check_convergence(checks):
    meshes = [2, 4, 8, 16]
    errors = []
    for motion in motions(checks, [("pendulum", ["--elements", str(mesh), "--pass-degenerate"]) for mesh in meshes]):
        errors.append(max(math.hypot(motion.at(t)["x"] - x, motion.at(t)["y"] - y) for t, (x, y) in LIMIT.items()))
    # 0.069, 0.022, 2.6e-3 and 9.6e-4 m measured, 2.0e-4 m with 32: of second order on the average
    checks.expect(errors == sorted(errors, reverse=True), f"pendulum: errors {errors} of {meshes} elements")
    order = math.log2(errors[0] / errors[-1]) / 3
    checks.expect(order >= 2.0 and errors[-1] <= 1.5e-3, f"pendulum: errors {errors}, order {order:.2f}")


def check_energy(checks):
    """Ten seconds by the energy-momentum scheme, with steps that it must take in parts too. Two elements fold on the
    way, which the run must be told to pass."""
    steps = ["5e-3", "2e-2"]
    arguments = ["--integrator", "energy", "--duration", "10", "--output-interval", "0.1", "--elements", "2"]
    ended, = run_all(checks.folder, [("pendulum", [*arguments, "--step", steps[0]])])
    checks.expect(ended.code == 1 and "is degenerate at" in ended.errors, f"{ended.command}: {ended.errors}")
    for motion in motions(checks, [("pendulum", [*arguments, "--pass-degenerate", "--step", step]) for step in steps]):
        checks.expect("is degenerate at" in motion.errors, f"{motion.name}: {motion.errors}")
        drift = motion.said(r"energy drift ([-+.0-9e]+) J")
        checks.expect(drift <= 1e-8 * motion.kinetic, f"{motion.name}: energy drift {drift} J")
        checks.expect(motion.largest("total") <= 1e-8 * motion.kinetic, f"{motion.name}: {motion.largest('total')} J")


def check_link(checks, integrators):
    cases = [("pendulum", ["--link", "0.4", "--elements", "6", "--step", "1e-3", "--integrator", name]) for name in integrators]
    for name, motion in zip(integrators, motions(checks, cases)):
        for column in ["constraint", "constraint_rate"]:
            checks.expect(motion.largest(column) <= 1e-12, f"{motion.name}: {column} {motion.largest(column)}")
        if name != "ida-index3":
            continue
        before = motion.said(r"before projection: constraint ([-+.0-9e]+) m"), motion.said(r"its rate ([-+.0-9e]+) m/s")
        checks.expect(before[0] <= 2e-8 and before[1] <= 5e-4, f"{motion.name}: before projection {before}")
        checks.expect(motion.said(STEPS) <= 8000, f"{motion.name}: {motion.said(STEPS)} steps")


def check_steel(checks):
    motion, = motions(checks, [("pendulum", [*STEEL, "--tolerance", "1e-7", "--output-interval", "0.005"])])
    checks.expect("order at most 2" in motion.errors, f"{motion.name}: {motion.errors}")
    checks.expect(motion.said(STEPS) <= 12000, f"{motion.name}: {motion.said(STEPS)} steps")
    gain = max((row["total"] for row in motion.rows), default=math.nan)
    checks.expect(gain <= 1e-3 * motion.kinetic, f"{motion.name}: energy gain {gain} J")


def check_restart(checks):
    """A run in two parts is the whole run, bit for bit: so is every digit printed."""
    with tempfile.TemporaryDirectory() as name:
        state = pathlib.Path(name) / "state"
        for integrator in FIXED:
            arguments = ["--integrator", integrator, "--step", "1e-3", "--link", "0.4"]
            whole, = motions(checks, [("pendulum", [*arguments, "--duration", "0.4"])])
            motions(checks, [("pendulum", [*arguments, "--duration", "0.2", "--save", str(state)])])
            rest, = motions(checks, [("pendulum", [*arguments, "--duration", "0.2", "--restart", str(state)])])
            checks.expect(len(rest.rows) == 5 and rest.rows[1:] == whole.rows[-4:],
                          f"{rest.name}: {rest.rows[-1:]}, in one run {whole.rows[-1:]}")
        other, = run_all(checks.folder, [("pendulum", ["--restart", str(state), "--elements", "2"])])
        checks.expect(other.code == 2 and "coordinates" in other.errors, f"{other.command}: {other.errors}")


def check_refusals(checks):
    wrong = [["--density", "0"], ["--tolerance", "-1e-8"], ["--step", "0"], ["--duration", "-1"], ["--rho", "1.5"],
             ["--output-interval", "0"], ["--link", "-0.4"], ["--integrator", "euler"], ["--restart", "missing.state"]]
    cases = [(program, arguments) for program in ["pendulum", "double_pendulum"] for arguments in wrong]
    cases.remove(("double_pendulum", ["--link", "-0.4"]))
    for (_, arguments), run in zip(cases, run_all(checks.folder, cases)):
        told = run.code == 2 and run.output == "" and (arguments[0] in run.errors or arguments[1] in run.errors)
        checks.expect(told, f"{run.command}: status {run.code}, {run.output}{run.errors}")


def check_explicit(checks, integrators):
    """Explicit methods of SUNDIALS refuse constraints and name what takes them."""
    cases = [("double_pendulum", ["--integrator", name]) for name in integrators]
    for run in run_all(checks.folder, cases):
        told = run.code == 2 and run.output == "" and all(name in run.errors for name in ("multipliers", "RadauIIA"))
        checks.expect(told, f"{run.command}: status {run.code}, {run.output}{run.errors}")


def main(folder):
    checks = Checks(folder)
    probe, = run_all(folder, [("pendulum", ["--integrator", "ida-index3", "--duration", "1e-3"])])
    with_ida = not (probe.code == 2 and "needs SUNDIALS" in probe.errors)
    integrators = [*(IDA if with_ida else []), *FIXED, "leapfrog", "radau", "radau9"]
    check_heights(checks, [*integrators, *(["explicit"] if with_ida else [])])
    check_explicit(checks, ["explicit"] if with_ida else [])
    check_link(checks, integrators)
    check_energy(checks)
    check_restart(checks)
    check_refusals(checks)
    if with_ida:
        check_convergence(checks)
        check_steel(checks)
        motions(checks, [("double_pendulum", [])])
    report(checks.findings, checks.count, "checks")


if __name__ == "__main__":
    main(sys.argv[1])
