"""The spin-up with numpy and `scipy.integrate.solve_ivp`: Hermite beam in the axes of the hub, analytic Jacobian.

What somebody who writes the equations in Python gets. With `law="exact"` and `free_norm=False` it is the element of
Exudyn's `ANCFCable2D` with the root that Exudyn is given here: the check that all codes solve one problem.
"""

import time
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import cho_factor, cho_solve

import spin_up
from spin_up import AXIAL_STIFFNESS, BENDING_STIFFNESS, LENGTH, MASS_PER_LENGTH, Failed, Run

QUARTER_TURN = np.array([[0.0, -1.0], [1.0, 0.0]])


@dataclass(frozen=True)
class Setting:
    """`method` and `rtol` of `solve_ivp`; `law` of the strain energy; `free_norm`: the root's slope may
    change its length; `patience`: processor time after which the run is given up (s)."""

    elements: int
    method: str
    rtol: float
    law: str = "quartic"
    free_norm: bool = True
    patience: float = 60.0

    def __str__(self) -> str:
        return f"{self.method} rtol {self.rtol:.0e}; {self.elements} elements"


class Beam:
    """Position-only Hermite beam in the plane; coordinates (x, y) of position and slope of every node, flat."""

    def __init__(self, elements: int, law: str, free_norm: bool):
        length = LENGTH / elements
        self.law = law
        self.power = {"quartic": 0, "exact": 2}[law]
        self.nodes = np.array([np.arange(2 * e, 2 * e + 4) for e in range(elements)])
        size = 2 * (elements + 1)
        mass = np.zeros((size, size))
        block = hermite_mass(length)
        for nodes in self.nodes:
            mass[np.ix_(nodes, nodes)] += block
        held = [0, 1, 3] if free_norm else [0, 1, 2, 3]
        self.free = np.setdiff1d(np.arange(2 * size), held)
        self.mass = np.kron(mass, np.eye(2))
        self.inverse = cho_solve(cho_factor(self.mass[np.ix_(self.free, self.free)]), np.eye(len(self.free)))
        self.rows = self.inverse @ self.mass[self.free]
        self.gyro = np.kron(np.eye(size), QUARTER_TURN)
        self.turning = (self.rows @ self.gyro, self.rows)
        self.rest = np.zeros((size, 2))
        self.rest[0::2, 0] = np.linspace(0, LENGTH, elements + 1)
        self.rest[1::2, 0] = 1
        bending_points = 5 if law == "quartic" else 3
        self.slopes, self.curvatures, self.axial, self.bending = quadrature(length, 5, bending_points)
        self.dofs = (2 * self.nodes[:, :, None] + np.arange(2)).reshape(elements, 8)

    def forces(self, q: np.ndarray) -> np.ndarray:
        """Elastic forces, the gradient of the strain energy."""
        local = q.reshape(-1, 2)[self.nodes]
        a, b = self.slopes @ local, self.curvatures @ local
        s, c = (a * a).sum(-1), a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
        p = self.power
        stress = self.axial * AXIAL_STIFFNESS * ((s - 1) / 2 if p == 0 else 1 - 1 / np.sqrt(s))
        moment = self.bending * BENDING_STIFFNESS * c * s ** -p
        by_slope = (stress - p * moment * c / s)[..., None] * a - moment[..., None] * (b @ QUARTER_TURN.T)
        by_curvature = moment[..., None] * (a @ QUARTER_TURN.T)
        element = self.slopes.T @ by_slope + self.curvatures.T @ by_curvature
        total = np.zeros(q.size)
        np.add.at(total, self.dofs, element.reshape(len(element), 8))
        return total

    def stiffness(self, q: np.ndarray) -> np.ndarray:
        """Tangent stiffness, the second derivative of the strain energy."""
        local = q.reshape(-1, 2)[self.nodes]
        a, b = self.slopes @ local, self.curvatures @ local
        s, c = (a * a).sum(-1), a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
        p, one = self.power, np.eye(2)

        def outer(left, right):
            return left[..., :, None] * right[..., None, :]

        def times(factor, matrix):
            return factor[..., None, None] * matrix

        root = np.sqrt(s)
        flat, along = ((s - 1) / 2, np.ones_like(s)) if p == 0 else (1 - 1 / root, root**-3)
        c_a, c_b = -b @ QUARTER_TURN.T, a @ QUARTER_TURN.T
        ea, ei = self.axial * AXIAL_STIFFNESS + 0 * s, self.bending * BENDING_STIFFNESS * s ** -p
        mixed = outer(c_a, a)
        aa = times(ea * flat - ei * p * c * c / s, one) + times(ea * along + ei * 2 * p * (p + 1) * (c / s) ** 2, outer(a, a))
        aa += times(ei, outer(c_a, c_a)) - times(ei * 2 * p * c / s, mixed + np.swapaxes(mixed, -1, -2))
        ab = times(ei, outer(c_a, c_b)) - times(ei * c, QUARTER_TURN) - times(ei * 2 * p * c / s, outer(a, c_b))
        bb = times(ei, outer(c_b, c_b))
        n, m = self.slopes, self.curvatures
        cross = np.einsum("gi,egxy,gj->eixjy", n, ab, m, optimize=True)
        element = np.einsum("gi,egxy,gj->eixjy", n, aa, n, optimize=True)
        element += np.einsum("gi,egxy,gj->eixjy", m, bb, m, optimize=True)
        element += cross + cross.transpose(0, 3, 4, 1, 2)
        total = np.zeros((q.size, q.size))
        for dofs, block in zip(self.dofs, element.reshape(-1, 8, 8)):
            total[np.ix_(dofs, dofs)] += block
        return total


def hermite_mass(length: float) -> np.ndarray:
    """Consistent mass matrix of one element for positions and slopes."""
    l = length
    table = [
        [156, 22 * l, 54, -13 * l],
        [22 * l, 4 * l * l, 13 * l, -3 * l * l],
        [54, 13 * l, 156, -22 * l],
        [-13 * l, -3 * l * l, -22 * l, 4 * l * l],
    ]
    return MASS_PER_LENGTH * l / 420 * np.array(table)


def quadrature(length: float, axial_points: int, bending_points: int):
    """First and second derivatives of the shape functions at all Gauss points, and weights of axial and of bending energy."""
    (xa, wa), (xb, wb) = (np.polynomial.legendre.leggauss(k) for k in (axial_points, bending_points))
    x, l = (np.concatenate([xa, xb]) + 1) / 2, length
    slopes = np.stack([6 * (x * x - x) / l, 1 - 4 * x + 3 * x * x, 6 * (x - x * x) / l, 3 * x * x - 2 * x], 1)
    curvatures = np.stack([(12 * x - 6) / l**2, (6 * x - 4) / l, (6 - 12 * x) / l**2, (6 * x - 2) / l], 1)
    axial = np.concatenate([wa, 0 * wb]) * l / 2
    bending = np.concatenate([0 * wa, wb]) * l / 2
    return slopes, curvatures, axial, bending


def run(speed: float, setting: Setting) -> Run:
    """Integrates over `spin_up.ROWS`."""
    beam = Beam(setting.elements, setting.law, setting.free_norm)
    free, count = beam.free, len(beam.free)
    q = beam.rest.ravel().copy()
    rate = np.zeros_like(q)
    gyro, rows = beam.turning

    def derivative(t, y):
        if time.process_time() - begin > setting.patience:
            raise Failed(f"given up at t = {t:.3g} s, after {setting.patience:g} s of processor time")
        q[free], rate[free] = y[:count], y[count:]
        w, dw = spin_up.hub_rate(speed, t), spin_up.hub_acceleration(speed, t)
        force = beam.inverse @ beam.forces(q)[free]
        return np.concatenate([y[count:], w * w * (rows @ q) - gyro @ (2 * w * rate + dw * q) - force])

    def jacobian(t, y):
        q[free] = y[:count]
        w, dw = spin_up.hub_rate(speed, t), spin_up.hub_acceleration(speed, t)
        result = np.zeros((2 * count, 2 * count))
        result[:count, count:] = np.eye(count)
        stiffness = beam.inverse @ beam.stiffness(q)[np.ix_(free, free)]
        result[count:, :count] = w * w * rows[:, free] - dw * gyro[:, free] - stiffness
        result[count:, count:] = -2 * w * gyro[:, free]
        return result

    start = np.concatenate([q[free], np.zeros(count)])
    implicit = {"jac": jacobian} if setting.method in ("Radau", "BDF", "LSODA") else {}
    begin = time.process_time()
    solution = solve_ivp(
        derivative,
        (0.0, spin_up.RAMP),
        start,
        method=setting.method,
        t_eval=spin_up.ROWS,
        rtol=setting.rtol,
        atol=1e-2 * setting.rtol,
        first_step=1e-4,
        dense_output=True,
        **implicit,
    )
    cpu = time.process_time() - begin
    if not solution.success:
        raise Failed(solution.message)
    x, y = (solution.y[np.searchsorted(free, 4 * setting.elements + component)] for component in (0, 1))
    counts = f"{solution.nfev} evaluations, {solution.njev} Jacobians, {solution.nlu} factorizations"
    return Run(x - LENGTH, y, cpu, len(solution.sol.ts) - 1, counts)


def missing() -> str | None:
    """What to do before this code can run; `None`: `run.py` itself needs numpy and scipy."""
    return None
