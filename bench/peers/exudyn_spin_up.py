"""The spin-up with Exudyn: `ANCFCable2D` in absolute coordinates, root position held, root slope prescribed.

Tuned: module without range checks, prescribed motion as symbolic user functions (evaluated without Python), Newton's
iteration judged by its increments (`residualMode = 1`), modified Newton, sparse or dense matrices, one thread, nothing written.
"""

import importlib.util
import math
import sys
import time
from dataclasses import dataclass

import numpy as np

import spin_up
from spin_up import AXIAL_STIFFNESS, BENDING_STIFFNESS, LENGTH, MASS_PER_LENGTH, Failed, Run

@dataclass(frozen=True)
class Setting:
    """Fixed step (s), tolerance of the Newton increments, solver; `plain`: the defaults but for the step, for comparison."""

    elements: int
    step: float
    tolerance: float = 1e-9
    solver: str = "TrapezoidalIndex2"
    radius: float = 0.9
    sparse: bool = True
    reduced: bool = False
    plain: bool = False

    def __str__(self) -> str:
        if self.plain:
            return f"defaults; h {self.step:.3g} s; {self.elements} elements"
        solver = {"TrapezoidalIndex2": "trapezoidal", "GeneralizedAlpha": f"generalized-alpha {self.radius:g}"}[self.solver]
        extra = ("" if self.sparse else " dense") + (" reduced quadrature" if self.reduced else "")
        return f"{solver}{extra} h {self.step:.3g} s Newton {self.tolerance:.0e}; {self.elements} elements"


def missing() -> str | None:
    """What to do before this code can run; `None` where it can."""
    if importlib.util.find_spec("exudyn"):
        return None
    return "Exudyn is not installed: run `python3 -m venv .venv && .venv/bin/pip install -r bench/peers/requirements.txt`"


def run(speed: float, setting: Setting) -> Run:
    """Integrates over `spin_up.ROWS`; the time is that of `SolveDynamic` alone."""
    sys.exudynFast = True
    import exudyn as exu

    container = exu.SystemContainer()
    system = container.AddSystem()
    sensor, alive = build(exu, system, speed, setting)
    settings = solver_settings(exu, setting)
    begin = time.process_time()
    try:
        system.SolveDynamic(settings, solverType=getattr(exu.DynamicSolverType, setting.solver))
    except Exception as error:
        raise Failed(str(error).splitlines()[0]) from error
    cpu = time.process_time() - begin
    del alive
    u, v = in_hub_axes(speed, system.GetSensorStoredData(sensor))
    done = system.sys["dynamicSolver"].it
    counts = f"{done.newtonStepsCount} iterations, {done.newtonJacobiCount} Jacobians"
    return Run(u, v, cpu, done.currentStepIndex - 1, counts)


def beginning(speed: float, setting: Setting, end: float) -> tuple[float, int]:
    """Processor time and steps of the first seconds of the run, up to `end` (s)."""
    sys.exudynFast = True
    import exudyn as exu

    container = exu.SystemContainer()
    system = container.AddSystem()
    _, alive = build(exu, system, speed, setting)
    settings = solver_settings(exu, setting)
    settings.timeIntegration.numberOfSteps = round(end / setting.step)
    settings.timeIntegration.endTime = end
    begin = time.process_time()
    system.SolveDynamic(settings, solverType=getattr(exu.DynamicSolverType, setting.solver))
    del alive
    return time.process_time() - begin, system.sys["dynamicSolver"].it.currentStepIndex - 1


def build(exu, system, speed: float, setting: Setting):
    """The assembled model; the number of the sensor at the tip, and what has to live as long as the model."""
    from exudyn import itemInterface as items
    from exudyn.advancedUtilities import CreateSymbolicUserFunction

    length = LENGTH / setting.elements
    ground = system.AddNode(items.NodePointGround())
    places = [[i * length, 0, 1, 0] for i in range(setting.elements + 1)]
    nodes = [system.AddNode(items.NodePoint2DSlope1(referenceCoordinates=place)) for place in places]
    for pair in zip(nodes, nodes[1:]):
        cable = items.ObjectANCFCable2D(
            length=length,
            massPerLength=MASS_PER_LENGTH,
            bendingStiffness=BENDING_STIFFNESS,
            axialStiffness=AXIAL_STIFFNESS,
            nodeNumbers=list(pair),
            useReducedOrderIntegration=int(setting.reduced),
        )
        system.AddObject(cable)
    fixed = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    alive = []
    for coordinate in range(4):
        marker = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
        held = system.AddObject(items.CoordinateConstraint(markerNumbers=[fixed, marker]))
        if coordinate < 2:
            continue
        motion = prescribed(math if setting.plain else exu.symbolic, speed, coordinate)
        for name, function in zip(("offsetUserFunction", "offsetUserFunction_t"), motion):
            if not setting.plain:
                function = CreateSymbolicUserFunction(system, function=function, userFunctionName=name, itemIndex=held)
            alive.append(function)
            system.SetObjectParameter(held, name, function)
    position = exu.OutputVariableType.Position
    tip = items.SensorNode(nodeNumber=nodes[-1], storeInternal=True, writeToFile=False, outputVariableType=position)
    sensor = system.AddSensor(tip)
    system.Assemble()
    return sensor, alive


def prescribed(m, speed: float, coordinate: int):
    """Displacement of a component of the root's slope and its rate; `m` gives sine and cosine."""

    def x(mbs, t, item, offset):
        return m.cos(spin_up.hub_angle(speed, t, m)) - 1.0

    def x_rate(mbs, t, item, offset):
        return -1.0 * m.sin(spin_up.hub_angle(speed, t, m)) * spin_up.hub_rate(speed, t, m)

    def y(mbs, t, item, offset):
        return m.sin(spin_up.hub_angle(speed, t, m))

    def y_rate(mbs, t, item, offset):
        return m.cos(spin_up.hub_angle(speed, t, m)) * spin_up.hub_rate(speed, t, m)

    return (x, x_rate) if coordinate == 2 else (y, y_rate)


def solver_settings(exu, setting: Setting):
    """Fixed steps, one thread, no files; Newton's iteration tuned unless `plain`."""
    settings = exu.SimulationSettings()
    integration = settings.timeIntegration
    integration.numberOfSteps = round(spin_up.RAMP / setting.step)
    integration.endTime = spin_up.RAMP
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = spin_up.EVERY
    settings.parallel.numberOfThreads = 1
    integration.generalizedAlpha.spectralRadius = setting.radius
    if setting.plain:
        return settings
    integration.adaptiveStep = False
    integration.newton.useModifiedNewton = True
    integration.newton.residualMode = 1
    integration.newton.relativeTolerance = setting.tolerance
    integration.newton.absoluteTolerance = setting.tolerance
    if setting.sparse:
        settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    return settings


def in_hub_axes(speed: float, data: np.ndarray):
    """Elongation and deflection of the tip from rows (t, x, y, z) in inertial axes."""
    t, x, y = data[:, 0], data[:, 1], data[:, 2]
    if len(t) != len(spin_up.ROWS) or abs(t - spin_up.ROWS).max() > 1e-9:
        raise Failed("rows at other times than asked for: the step must divide the time between rows")
    angle = spin_up.hub_angle(speed, t)
    c, s = np.cos(angle), np.sin(angle)
    return c * x + s * y - LENGTH, c * y - s * x
