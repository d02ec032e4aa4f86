# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model II, semicircle and pendulum on Exudyn, as comma-separated values.

    exudyn_cases.py [--cases model2,semicircle,pendulum]    columns: case,element,solver,elements,step,error,cpu_ms
    exudyn_cases.py --version                               what was imported

Time is that of the model's assembly and solution, of one processor, the least of several runs. An error is the distance of
the tip from the limit of the element's own theory: relative to the length in statics, in m for the pendulum (the largest at
0.3, 0.5, 0.7 and 1 s); for the cable in Model II and the pendulum, from a fine mesh of its own. A run that fails has the error nan. Exudyn's fast
module is used: without range checks and, where the processor has it, with AVX2. Of its linear solvers the sparse one and
both dense ones are run.
"""

import argparse
import contextlib
import math
import sys
import time

sys.exudynFast = True  # read by the import
with contextlib.redirect_stdout(sys.stderr):
    import exudyn as exu
import exudyn.itemInterface as items
import numpy as np
from exudyn.beams import GenerateStraightBeam

REISSNER_MODEL_2 = (1.784113323480, 0.821971481194)
# At 0.7 s: 128 three-node elements and steps of 1e-4 s, which have the other three to 1e-6 m.
REISSNER_PENDULUM = {0.3: (1.087608741, -0.445045527), 0.5: (0.374397683, -1.305257813),
                     0.7: (-0.677004, -1.098658), 1.0: (-1.218647154, -0.238806259)}
SENSED = 0.1  # s, between two records of the tip; divides the times above, and every step divides it
SOLVERS = {"eigen-sparse": exu.LinearSolverType.EigenSparse, "exu-dense": exu.LinearSolverType.EXUdense,
           "eigen-dense": exu.LinearSolverType.EigenDense}


class Beam:
    """A straight beam of square section from the origin along X."""

    def __init__(self, length, side, young, shear, density):
        area, inertia = side**2, side**4 / 12
        self.length, self.bending, self.axial = length, young * inertia, young * area
        self.shear = 5 / 6 * shear * area
        self.torsion = 5 / 6 * shear * 2 * inertia
        self.mass, self.rotary = density * area, density * inertia


MODEL_2 = Beam(2.0, 0.01, 2.07e11, 7.9615e10, 7850.0)
SEMICIRCLE = Beam(1.0, 0.035, 2e8, 1e8, 7850.0)
PENDULUM = Beam(1.2, 0.05, 0.7e6, 2.6923e5, 5540.0)


def planar(element, beam):
    """The template of a planar element."""
    if element == "cable2d-mixed":
        return items.ObjectANCFCable2D(
            massPerLength=beam.mass, bendingStiffness=beam.bending, axialStiffness=beam.axial,
            useReducedOrderIntegration=2)
    count = 3 if element == "exact2d-3node" else 2
    return items.ObjectBeamGeometricallyExact2D(
        nodeNumbers=[0] * count, massPerLength=beam.mass, crossSectionInertia=beam.rotary,
        bendingStiffness=beam.bending, axialStiffness=beam.axial, shearStiffness=beam.shear)


def planar_model(element, beam, elements, fixed, gravity=(0, 0, 0)):
    container = exu.SystemContainer()
    model = container.AddSystem()
    chain = GenerateStraightBeam.__wrapped__(
        model, [0, 0, 0], [beam.length, 0, 0], elements, planar(element, beam), gravity=list(gravity),
        fixedConstraintsNode0=fixed)
    return container, model, chain[0][-1]


def spatial_model(beam, elements):
    """Geometrically exact beams in space, clamped at the origin."""
    container = exu.SystemContainer()
    model = container.AddSystem()
    section = exu.BeamSection()
    section.massPerLength = beam.mass
    section.inertia = np.diag([2 * beam.rotary, beam.rotary, beam.rotary])
    section.stiffnessMatrix = np.diag([beam.axial, beam.shear, beam.shear, beam.torsion, beam.bending, beam.bending])
    nodes = [model.AddNode(items.NodeRigidBodyRotVecLG(
        referenceCoordinates=[beam.length * k / elements, 0, 0, 0, 0, 0])) for k in range(elements + 1)]
    for first, second in zip(nodes, nodes[1:]):
        model.AddObject(items.ObjectBeamGeometricallyExact(
            nodeNumbers=[first, second], length=beam.length / elements, sectionData=section))
    ground = model.AddMarker(items.MarkerNodeCoordinate(
        nodeNumber=model.AddNode(items.NodePointGround(referenceCoordinates=[0, 0, 0])), coordinate=0))
    for coordinate in range(6):
        end = model.AddMarker(items.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
        model.AddObject(items.CoordinateConstraint(markerNumbers=[ground, end]))
    return container, model, nodes[-1]


def settings(solver):
    chosen = exu.SimulationSettings()
    chosen.solutionSettings.writeSolutionToFile = False
    chosen.displayStatistics = chosen.displayComputationTime = False
    chosen.staticSolver.verboseMode = chosen.timeIntegration.verboseMode = 0
    chosen.linearSolverType = SOLVERS[solver]
    return chosen


def timed(model, solve):
    """Whether assembly and solution succeeded, and their milliseconds."""
    with contextlib.redirect_stdout(sys.stderr):  # where Exudyn tells of failures
        began = time.process_time()
        try:
            model.Assemble()
            good = solve()
        except Exception as failure:  # a singular matrix, for one
            print(failure)
            good = False
        return good, 1e3 * (time.process_time() - began)


def static(element, name, elements, solver):
    """One load step; returns the tip, None where there is none, and the milliseconds."""
    beam = MODEL_2 if name == "model2" else SEMICIRCLE
    if element == "exact3d":
        container, model, tip = spatial_model(beam, elements)
    else:
        cable = element.startswith("cable")
        container, model, tip = planar_model(element, beam, elements, [1, 1, 1, 1] if cable else [1, 1, 1])
    if name == "model2":
        marker = model.AddMarker(items.MarkerNodePosition(nodeNumber=tip))
        model.AddLoad(items.Force(markerNumber=marker, loadVector=[0, 1.5 * beam.bending / beam.length**2, 0]))
    else:
        marker = model.AddMarker(items.MarkerNodeRigid(nodeNumber=tip))
        model.AddLoad(items.Torque(markerNumber=marker, loadVector=[0, 0, math.pi * beam.bending / beam.length]))
    chosen = settings(solver)
    chosen.staticSolver.numberOfLoadSteps = 1
    chosen.staticSolver.newton.maxIterations = 100
    good, milliseconds = timed(model, lambda: model.SolveStatic(chosen, showHints=False))
    place = np.array(model.GetNodeOutput(tip, exu.OutputVariableType.Position))[:2]
    return (place if good else None), milliseconds


def pendulum(element, elements, step, solver):
    """Returns the tip at some times, None where the motion failed, and the milliseconds."""
    cable = element.startswith("cable")
    container, model, tip = planar_model(element, PENDULUM, elements, [1, 1, 0, 0] if cable else [1, 1, 0], (0, -9.81, 0))
    sensor = model.AddSensor(items.SensorNode(
        nodeNumber=tip, storeInternal=True, outputVariableType=exu.OutputVariableType.Position))
    chosen = settings(solver)
    chosen.solutionSettings.sensorsWritePeriod = SENSED
    chosen.timeIntegration.numberOfSteps = round(1.2 / step)
    chosen.timeIntegration.endTime = 1.2
    good, milliseconds = timed(model, lambda: model.SolveDynamic(
        chosen, solverType=exu.DynamicSolverType.TrapezoidalIndex2, showHints=False))
    if not good:
        return None, milliseconds
    sensed = np.array(model.GetSensorStoredData(sensor))
    seen = {}
    for at in REISSNER_PENDULUM:
        row = sensed[np.argmin(abs(sensed[:, 0] - at))]
        if abs(row[0] - at) > 1e-9:
            sys.exit(f"exudyn_cases.py: the step {step} does not meet {at} s")
        seen[at] = row[1:3]
    return seen, milliseconds


def least(run, enough, most):
    """The result and the least time of runs that fill `enough` ms, at most `most`: as speed_against_error does it."""
    result, best = run()
    spent = best
    for _ in range(most - 1):
        if spent >= enough:
            break
        _, again = run()
        spent += again
        best = min(best, again)
    return result, best


def statics(name):
    beam = MODEL_2 if name == "model2" else SEMICIRCLE
    for element in ("cable2d-mixed", "exact2d-2node", "exact2d-3node", "exact3d"):
        limit = REISSNER_MODEL_2 if name == "model2" else (0.0, 2.0 / math.pi)
        if element.startswith("cable") and name == "model2":
            limit = static(element, name, 256, "eigen-sparse")[0]
        for solver in SOLVERS:
            for elements in (1, 2, 3, 4, 6, 8, 12, 16, 32, 64):
                tip, milliseconds = least(lambda: static(element, name, elements, solver), 20.0, 30)
                error = math.nan if tip is None else np.linalg.norm(tip - limit) / beam.length
                yield name, element, solver, elements, "", error, milliseconds


def pendulums():
    for element in ("cable2d-mixed", "exact2d-2node", "exact2d-3node"):
        limit = REISSNER_PENDULUM
        if element.startswith("cable"):
            limit = pendulum(element, 64, 1e-4, "eigen-sparse")[0]
        for solver in SOLVERS:
            for step in (1e-2, 4e-3, 2e-3, 1e-3, 5e-4):
                for elements in (2, 4, 8, 16):
                    seen, milliseconds = least(lambda: pendulum(element, elements, step, solver), 60.0, 3)
                    error = math.nan if seen is None else max(np.linalg.norm(seen[at] - limit[at]) for at in limit)
                    yield "pendulum", element, solver, elements, step, error, milliseconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", default="model2,semicircle,pendulum")
    parser.add_argument("--version", action="store_true", help="print what was imported")
    arguments = parser.parse_args()
    if arguments.version:
        print(f"Exudyn {exu.config.Version()}, {exu._compiledModuleName}")
        return
    exu.config.suppressWarnings = True
    print("case,element,solver,elements,step,error,cpu_ms")
    for case in arguments.cases.split(","):
        for name, element, solver, elements, step, error, milliseconds in pendulums() if case == "pendulum" else statics(case):
            print(f"{name},{element},{solver},{elements},{step},{error:.3e},{milliseconds:.3f}", flush=True)


if __name__ == "__main__":
    main()
