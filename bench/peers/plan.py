"""What is run at each speed: meshes, steps, tolerances and the error at which times are compared."""

from dataclasses import dataclass

from exudyn_spin_up import Setting as Exudyn
from rncf_spin_up import Setting as Rncf
from scipy_spin_up import Setting as Scipy


@dataclass(frozen=True)
class Plan:
    """`wanted`: error of v at which times are compared (m); `elements` of all codes, `finest` of the finest converged runs."""

    speed: float
    wanted: float
    elements: int
    finest: int
    settings: list

    def __str__(self) -> str:
        return f"spin-up at {self.speed:g} rad/s"


def plan(speed: float, quick: bool) -> Plan:
    """The plan for one of `SPEEDS`; `quick` keeps the settings near the wanted error alone."""
    wanted, elements, finest, fine, coarse = SPEEDS[speed]
    settings = [Exudyn(elements, step, tolerance) for step, tolerance in fine]
    settings += [Exudyn(elements, step, tolerance, "GeneralizedAlpha") for step, tolerance in coarse]
    step, tolerance = coarse[0]
    settings += [Exudyn(elements, step, tolerance, "GeneralizedAlpha", reduced=True)]
    settings += [Rncf(elements, "radau", rtol) for rtol in NEAR[speed]]
    if not quick:
        variants = ({"sparse": False}, {"radius": 0.7})
        settings += [Exudyn(elements, step, tolerance, "GeneralizedAlpha", **variant) for variant in variants]
        settings += [Rncf(elements, "radau", rtol) for rtol in (1e-4, 1e-6, 1e-8) if rtol not in NEAR[speed]]
        settings += [Rncf(elements, "generalized-alpha", rtol) for rtol in (1e-7, 1e-8, 1e-9)]
        settings += [Rncf(elements, "hht", rtol) for rtol in (1e-7, 1e-8, 1e-9)]
        if speed < 40:
            settings += [Rncf(elements, "radau", rtol, "ancf") for rtol in (1e-5, 1e-7)]
        settings += [Scipy(elements, "Radau", rtol) for rtol in SCIPY[speed]]
    return Plan(speed, wanted, elements, finest, settings)


SPEEDS = {
    4.0: (3e-6, 16, 32, [(1e-3, 1e-9), (0.05 / 60, 1e-9), (5e-4, 1e-9), (2e-3, 1e-9)], [(1e-3, 1e-9), (2.5e-3, 1e-9)]),
    10.0: (1e-4, 16, 32, [(1e-3, 1e-8), (5e-4, 1e-8)], [(1e-3, 1e-8), (2.5e-3, 1e-8)]),
    40.0: (1e-3, 48, 64, [(5e-4, 1e-6)], [(6.25e-4, 1e-5), (1e-3, 1e-5), (6.25e-4, 1e-4), (1e-3, 1e-4)]),
    100.0: (2e-3, 72, 96, [], [(5e-4, 1e-5), (5e-4, 1e-4), (4e-4, 1e-4)]),
}
"""By speed: wanted error (m), elements, finest mesh; steps (s) and Newton tolerances of Exudyn's trapezoidal rule, and of
its generalized-alpha. The trapezoidal rule fails at 40 rad/s from 6.25e-4 s on, and at 100 rad/s with 5e-4 s."""

NEAR = {4.0: [1e-6, 5e-7, 1e-7], 10.0: [1e-5, 1e-6], 40.0: [3e-4, 1e-4, 1e-5], 100.0: [1e-4, 3e-5, 1e-5]}
"""Tolerances of Radau near the wanted error."""

SCIPY = {4.0: [1e-3, 1e-4, 1e-5], 10.0: [1e-3, 1e-4], 40.0: [1e-4], 100.0: []}
"""Tolerances of scipy's Radau; at 100 rad/s its dense matrices take minutes."""

CONVERGED = {
    4.0: (5e-4, 1e-10, "TrapezoidalIndex2"),
    10.0: (5e-4, 1e-10, "TrapezoidalIndex2"),
    40.0: (5e-4, 1e-10, "TrapezoidalIndex2"),
    100.0: (2.5e-4, 1e-9, "GeneralizedAlpha"),
}
"""Exudyn's converged runs are extrapolated from this step and its half; Newton tolerance, solver."""
