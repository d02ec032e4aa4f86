# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model II, semicircle and pendulum on Exudyn, as comma-separated values.

    exudyn_cases.py [--repeats N]    columns: case,element,elements,error,cpu_ms

Time is that of the model's assembly and solution, of one processor, the least of N runs. An error is the distance of the
tip from the limit of the element's own theory: relative to the length in statics (the cable: a fine mesh of its own),
in m for the pendulum (the largest at 0.3, 0.5, 0.7, 1 s).
"""

import argparse
import math
import time

import exudyn as exu
import exudyn.itemInterface as items
import numpy as np
from exudyn.beams import GenerateStraightBeam

REISSNER_MODEL_2 = (1.784113323480, 0.821971481194)
REISSNER_PENDULUM = {0.3: (1.087608741, -0.445045527), 0.5: (0.374397683, -1.305257813),
                     1.0: (-1.218647154, -0.238806259)}


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


def settings():
    chosen = exu.SimulationSettings()
    chosen.solutionSettings.writeSolutionToFile = False
    chosen.displayStatistics = chosen.displayComputationTime = False
    chosen.staticSolver.verboseMode = chosen.timeIntegration.verboseMode = 0
    chosen.linearSolverType = exu.LinearSolverType.EigenSparse
    return chosen


def position(model, node):
    return np.array(model.GetNodeOutput(node, exu.OutputVariableType.Position))[:2]


def static(element, name, elements):
    """One load step; returns the tip and the milliseconds."""
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
    chosen = settings()
    chosen.staticSolver.numberOfLoadSteps = 1
    chosen.staticSolver.newton.maxIterations = 100
    began = time.process_time()
    model.Assemble()
    good = model.SolveStatic(chosen, showHints=False)
    milliseconds = 1e3 * (time.process_time() - began)
    return (position(model, tip) if good else None), milliseconds


def pendulum(element, elements, step):
    """Returns the largest error at some times and the milliseconds."""
    cable = element.startswith("cable")
    container, model, tip = planar_model(element, PENDULUM, elements, [1, 1, 0, 0] if cable else [1, 1, 0], (0, -9.81, 0))
    seen = {}

    def look(mbs, t):
        for at in REISSNER_PENDULUM:
            if abs(t - at) < step / 2:
                seen[at] = position(mbs, tip)
        return True

    model.SetPostStepUserFunction(look)
    chosen = settings()
    chosen.timeIntegration.numberOfSteps = round(1.2 / step)
    chosen.timeIntegration.endTime = 1.2
    began = time.process_time()
    model.Assemble()
    good = model.SolveDynamic(chosen, solverType=exu.DynamicSolverType.TrapezoidalIndex2, showHints=False)
    milliseconds = 1e3 * (time.process_time() - began)
    return (seen if good else None), milliseconds


def least(run, repeats):
    """The last result and the least time of several runs."""
    results = [run() for _ in range(repeats)]
    return results[-1][0], min(milliseconds for _, milliseconds in results)


def rows(repeats):
    limits = {}
    for name, beam in (("model2", MODEL_2), ("semicircle", SEMICIRCLE)):
        for element in ("cable2d-mixed", "exact2d-2node", "exact2d-3node", "exact3d"):
            limit = REISSNER_MODEL_2 if name == "model2" else (0.0, 2.0 / math.pi)
            if element.startswith("cable") and name == "model2":
                limit = limits.setdefault(name, static(element, name, 256)[0])
            for elements in (2, 4, 8, 16, 32, 64):
                tip, milliseconds = least(lambda: static(element, name, elements), repeats)
                if tip is not None:
                    yield name, element, elements, np.linalg.norm(tip - limit) / beam.length, milliseconds
    for element in ("cable2d-mixed", "exact2d-3node"):
        limit = REISSNER_PENDULUM
        if element.startswith("cable"):
            limit = pendulum(element, 32, 1e-4)[0]
        for step in (4e-3, 2e-3, 1e-3, 5e-4):
            for elements in (4, 8):
                seen, milliseconds = least(lambda: pendulum(element, elements, step), min(repeats, 2))
                if seen is not None and len(seen) == len(limit):
                    error = max(np.linalg.norm(seen[at] - limit[at]) for at in limit)
                    yield "pendulum", element, elements, error, milliseconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=5, help="runs of which the fastest counts")
    repeats = parser.parse_args().repeats
    exu.config.suppressWarnings = True
    print("case,element,elements,error,cpu_ms")
    for name, element, elements, error, milliseconds in rows(repeats):
        print(f"{name},{element},{elements},{error:.3e},{milliseconds:.3f}", flush=True)


if __name__ == "__main__":
    main()
