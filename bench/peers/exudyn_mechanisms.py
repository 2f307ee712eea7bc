"""The heavy top and Andrews' squeezer with Exudyn.

Tuned as the spin-up is: module without range checks, Newton's iteration judged by its increments, modified and full Newton,
dense matrices (small systems), one thread, nothing written. The top has Euler parameters; the squeezer planar bodies.
"""

import math
import sys
import time
from dataclasses import dataclass

import numpy as np

TOP = {"mass": 15.0, "inertia": [0.234375, 0.46875, 0.234375], "spin": [0, 150, -4.61538], "speed": [4.61538, 0, 0]}

BETA, GAMMA, PHI, DELTA, EPSILON = (
    -0.0617138900142764496,
    0.455279819163070380,
    0.222668390165885885,
    0.487364979543842550,
    1.23054744454982119,
)
RR, D, SS, E, ZT, ZF, U = 0.007, 0.028, 0.035, 0.02, 0.04, 0.02, 0.04
A, B, C = (-0.06934, -0.00227), (-0.03635, 0.03273), (0.014, 0.072)
BODIES = {
    1: (0.04325, 2.194e-6, (0.92e-3, 0), (0, 0), BETA),
    2: (0.00365, 4.410e-7, (-11.5e-3, 0), (RR * math.cos(BETA), RR * math.sin(BETA)), BETA),
    3: (0.02373, 5.255e-6, (10.43e-3, -18.74e-3), B, GAMMA),
    4: (0.00706, 5.667e-7, (0, -5.79e-3), (A[0] + ZT * math.cos(DELTA), A[1] + ZT * math.sin(DELTA)), PHI + DELTA),
    5: (0.07050, 1.169e-5, (23.08e-3, 9.16e-3), A, DELTA),
    6: (0.00706, 5.667e-7, (5.79e-3, 0), (A[0] + U * math.sin(EPSILON), A[1] - U * math.cos(EPSILON)), EPSILON - PHI),
    7: (0.05498, 1.912e-5, (-4.49e-3, -12.28e-3), A, EPSILON),
}
"""Mass, inertia about the centre, centre in the axes of the body, origin, angle; SI units, as in models/src/andrews_squeezer.rs."""
JOINTS = [
    (0, (0, 0), 1, (0, 0)),
    (0, A, 5, (0, 0)),
    (0, A, 7, (0, 0)),
    (0, B, 3, (0, 0)),
    (1, (RR, 0), 2, (0, 0)),
    (5, (ZT, 0), 4, (0, 0)),
    (7, (0, -U), 6, (0, 0)),
    (2, (-D, 0), 3, (0, -SS)),
    (2, (-D, 0), 4, (0, -E)),
    (2, (-D, 0), 6, (ZF, 0)),
]
"""Bodies (0 is the ground) and points in their axes, from their origins."""


@dataclass(frozen=True)
class Setting:
    """Number of fixed steps, tolerance of the Newton increments, solver."""

    steps: int
    solver: str
    radius: float
    tolerance: float
    modified: bool

    def __str__(self) -> str:
        solver = "trapezoidal" if self.solver == "TrapezoidalIndex2" else f"generalized-alpha {self.radius:g}"
        return f"{solver}, {self.steps} steps, Newton {self.tolerance:.0e}{'' if self.modified else ', full'}"


def settings(name: str) -> list[Setting]:
    """All that are tried."""
    counts = {"heavy_top": [500, 1000, 2000, 5000, 20000, 50000], "andrews_squeezer": [500, 1000, 2000, 5000, 10000]}
    solvers = [("TrapezoidalIndex2", 1.0), ("GeneralizedAlpha", 0.9)]
    return [
        Setting(steps, solver, radius, tolerance, modified)
        for steps in counts[name]
        for solver, radius in solvers
        for tolerance in (1e-6, 1e-8)
        for modified in (True, False)
    ]


def run(name: str, setting: Setting):
    """Values at the end, processor time of `SolveDynamic` (s), steps; `None` where it fails."""
    sys.exudynFast = True
    import exudyn as exu

    container = exu.SystemContainer()
    system = container.AddSystem()
    read = (heavy_top if name == "heavy_top" else squeezer)(exu, system)
    chosen = exu.SimulationSettings()
    integration = chosen.timeIntegration
    integration.numberOfSteps = setting.steps
    integration.endTime = 1.0 if name == "heavy_top" else 0.03
    integration.adaptiveStep = False
    integration.generalizedAlpha.spectralRadius = setting.radius
    integration.newton.useModifiedNewton = setting.modified
    integration.newton.residualMode = 1
    integration.newton.relativeTolerance = setting.tolerance
    integration.newton.absoluteTolerance = setting.tolerance
    integration.verboseMode = 0
    chosen.solution.file.write = False
    chosen.parallel.numberOfThreads = 1
    begin = time.process_time()
    try:
        system.SolveDynamic(chosen, solverType=getattr(exu.DynamicSolverType, setting.solver))
    except Exception:
        return None
    seconds = time.process_time() - begin
    values = read()
    return (values, seconds, setting.steps) if all(math.isfinite(value) for value in values) else None


def heavy_top(exu, system):
    """A function that reads the centre of mass."""
    from exudyn.rigidBodyUtilities import RigidBodyInertia

    body = system.CreateRigidBody(
        inertia=RigidBodyInertia(mass=TOP["mass"], inertiaTensor=np.diag(TOP["inertia"])),
        referencePosition=[0, 1, 0],
        initialVelocity=TOP["speed"],
        initialAngularVelocity=TOP["spin"],
        gravity=[0, 0, -9.81],
        nodeType=exu.NodeType.RotationEulerParameters,
    )
    ground = system.CreateGround()
    system.CreateSphericalJoint(bodyNumbers=[ground, body], position=[0, 0, 0], show=False)
    system.Assemble()
    return lambda: list(system.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0]))


def squeezer(exu, system):
    """A function that reads the angles of the crank and of the triangle."""
    from exudyn import itemInterface as items

    bodies, nodes = {0: system.AddObject(items.ObjectGround())}, {}
    centres = {0: (0, 0)}
    for number, (mass, inertia, centre, origin, angle) in BODIES.items():
        c, s = math.cos(angle), math.sin(angle)
        place = [origin[0] + c * centre[0] - s * centre[1], origin[1] + s * centre[0] + c * centre[1], angle]
        nodes[number] = system.AddNode(items.NodeRigidBody2D(referenceCoordinates=place))
        body = items.ObjectRigidBody2D(physicsMass=mass, physicsInertia=inertia, nodeNumber=nodes[number])
        bodies[number], centres[number] = system.AddObject(body), centre

    def marker(body, point):
        local = [point[0] - centres[body][0], point[1] - centres[body][1], 0]
        return system.AddMarker(items.MarkerBodyPosition(bodyNumber=bodies[body], localPosition=local))

    for one, at, other, point in JOINTS:
        system.AddObject(items.ObjectJointRevolute2D(markerNumbers=[marker(one, at), marker(other, point)]))
    ends = [marker(3, (0.02, -0.018)), marker(0, C)]
    system.AddObject(items.ObjectConnectorSpringDamper(markerNumbers=ends, stiffness=4530.0, damping=0.0, referenceLength=0.07785))
    crank = system.AddMarker(items.MarkerBodyRigid(bodyNumber=bodies[1]))
    system.AddLoad(items.LoadTorqueVector(markerNumber=crank, loadVector=[0, 0, 0.033]))
    system.Assemble()

    def angle(number):
        return BODIES[number][4] + system.GetNodeOutput(nodes[number], exu.OutputVariableType.Coordinates)[2]

    return lambda: [angle(1), angle(3)]
