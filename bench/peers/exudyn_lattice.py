# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cubic lattices of bench/lattices on Exudyn, as comma-separated values.

    exudyn_lattice.py [JOINTS,ELEMENTS ...]    joints along each axis and elements a member; columns: joints,elements,tip,cpu_s

Geometrically exact beams in space with nodes of their own, joined by rigid connections (GenericJoint). The tip is the
displacement along X of the last joint, m. Time is that of assembly and one load step, of one processor. The sparse
linear solver is used. A run that fails has the tip nan.
"""

import contextlib
import math
import sys
import time
import warnings

sys.exudynFast = True  # read by the import
warnings.simplefilter("ignore")  # of names that newer versions call otherwise
with contextlib.redirect_stdout(sys.stderr):
    import exudyn as exu
import exudyn.itemInterface as items
import numpy as np

CELL, SIDE, YOUNG, POISSON, DENSITY = 0.25, 0.01, 2e11, 0.3, 7800.0
SHEAR = YOUNG / (2 * (1 + POISSON))
TURNS = [np.zeros(3), np.array([0, 0, math.pi / 2]), np.array([0, -math.pi / 2, 0])]  # of members along X, Y, Z
FRAMES = [np.eye(3), np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]])]
DEFAULT = ["3,1", "3,4", "3,16", "5,1", "5,4"]


def section():
    area, inertia = SIDE**2, SIDE**4 / 12
    made = exu.BeamSection()
    made.massPerLength = DENSITY * area
    made.inertia = DENSITY * np.diag([2 * inertia, inertia, inertia])
    shear = 5 / 6 * SHEAR * area
    made.stiffnessMatrix = np.diag([YOUNG * area, shear, shear, 0.1406 * SHEAR * SIDE**4, YOUNG * inertia, YOUNG * inertia])
    return made


def member(model, data, start, axis, elements):
    """Adds a beam along an axis; returns the nodes of its ends."""
    step = CELL / elements * np.eye(3)[axis]
    nodes = [model.AddNode(items.NodeRigidBodyRotVecLG(referenceCoordinates=[*(start + k * step), *TURNS[axis]]))
             for k in range(elements + 1)]
    for first, second in zip(nodes, nodes[1:]):
        model.AddObject(items.ObjectBeamGeometricallyExact(nodeNumbers=[first, second], length=CELL / elements, sectionData=data))
    return nodes[0], nodes[-1]


def lattice(count, elements):
    """A cube clamped at its foot, sheared at its head; the container, the model and the node of the last joint."""
    container = exu.SystemContainer()
    model = container.AddSystem()
    data = section()
    ends = {}
    for place in np.ndindex(count, count, count):
        for axis in range(3):
            to = tuple(np.array(place) + np.eye(3, dtype=int)[axis])
            if max(to) < count:
                first, last = member(model, data, CELL * np.array(place), axis, elements)
                ends.setdefault(place, []).append((first, axis))
                ends.setdefault(to, []).append((last, axis))
    ground = model.AddMarker(items.MarkerNodeCoordinate(
        nodeNumber=model.AddNode(items.NodePointGround(referenceCoordinates=[0, 0, 0])), coordinate=0))
    for place, ((node, axis), *others) in ends.items():
        here = model.AddMarker(items.MarkerNodeRigid(nodeNumber=node))
        for other, other_axis in others:
            there = model.AddMarker(items.MarkerNodeRigid(nodeNumber=other))
            model.AddObject(items.GenericJoint(markerNumbers=[here, there], rotationMarker1=FRAMES[other_axis].T @ FRAMES[axis]))
        if place[2] == 0:
            for coordinate in range(6):
                held = model.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
                model.AddObject(items.CoordinateConstraint(markerNumbers=[ground, held]))
        if place[2] == count - 1:
            model.AddLoad(items.Force(markerNumber=here, loadVector=[1, 0.5, 0]))
    return container, model, ends[count - 1, count - 1, count - 1][0][0]


def solve(count, elements):
    """The tip's displacement along X, nan where there is none, and the seconds."""
    container, model, tip = lattice(count, elements)
    chosen = exu.SimulationSettings()
    chosen.solutionSettings.writeSolutionToFile = False
    chosen.displayStatistics = chosen.displayComputationTime = False
    chosen.linearSolverType = exu.LinearSolverType.EigenSparse
    chosen.staticSolver.verboseMode = 0
    chosen.staticSolver.numberOfLoadSteps = 1
    chosen.staticSolver.newton.maxIterations = 100
    began = time.process_time()
    with contextlib.redirect_stdout(sys.stderr):
        try:
            model.Assemble()
            good = model.SolveStatic(chosen, showHints=False)
        except Exception as failure:  # an iteration that diverged, for one
            print(failure)
            good = False
    seconds = time.process_time() - began
    moved = model.GetNodeOutput(tip, exu.OutputVariableType.Displacement)[0]
    del container
    return (moved if good else math.nan), seconds


if __name__ == "__main__":
    print("joints,elements,tip,cpu_s")
    for case in sys.argv[1:] or DEFAULT:
        count, elements = map(int, case.split(","))
        tip, seconds = solve(count, elements)
        print(f"{count},{elements},{tip:.5e},{seconds:.3f}", flush=True)
