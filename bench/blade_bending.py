"""Frequencies of the NREL 5-MW blade by an independent program: a slender beam without shear and without rotary inertia, by cubic
Hermite elements between the stations of `models/data/nrel5mw_elastodyn.csv`, properties linear between them, six points an element.
The blade is clamped to a hub (radius 1.5 m) and turns in the rotor's plane.

    python3 bench/blade_bending.py        needs numpy and scipy; prints Hz for 1, 2 and 4 elements between stations
"""

from pathlib import Path

import numpy as np
from scipy.linalg import eigh

LENGTH, HUB = 61.5, 1.5  # m
TABLE = Path(__file__).parent.parent / "models/data/nrel5mw_elastodyn.csv"

lines = [line.split(",") for line in TABLE.read_text().splitlines() if not line.startswith("#")]
names = [head.split("[")[0] for head in lines[0]]
rows = np.array(lines[1:], dtype=float)
column = {name: rows[:, place] for place, name in enumerate(names)}
stations = column["BlFract"] * LENGTH
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(6)


def along(name, x):
    """A property at arclengths, linear between stations."""
    return np.interp(x, stations, column[name])


def integral(f, a, b):
    """Of a function from a to b, without a station between them."""
    return np.sum(WEIGHTS * (b - a) / 2 * f((a + b) / 2 + (b - a) / 2 * POINTS))


def frequencies(rpm, parts, count=3):
    """Least frequencies, Hz, of a blade that turns, with `parts` elements between two stations."""
    spin = rpm * np.pi / 30
    pull = lambda x: along("BMassDen", x) * spin**2 * (HUB + x)
    ends = np.unique(stations)
    nodes = np.concatenate([np.linspace(a, b, parts, endpoint=False) for a, b in zip(ends, ends[1:])] + [ends[-1:]])
    # Deflection and slope out of the rotor's plane, then in it.
    stiffness, mass = np.zeros((2, 4 * len(nodes), 4 * len(nodes)))
    tension = 0.0
    for e in reversed(range(len(nodes) - 1)):
        a, b = nodes[e : e + 2]
        l = b - a
        x = (a + b) / 2 + l / 2 * POINTS
        s = (x - a) / l
        weight = WEIGHTS * l / 2
        shape = np.array([1 - 3 * s**2 + 2 * s**3, l * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, l * (s**3 - s**2)]).T
        slope = np.array([(6 * s**2 - 6 * s) / l, 1 - 4 * s + 3 * s**2, (6 * s - 6 * s**2) / l, 3 * s**2 - 2 * s]).T
        bent = np.array([(12 * s - 6) / l**2, (6 * s - 4) / l, (6 - 12 * s) / l**2, (6 * s - 2) / l]).T
        pulled = np.array([tension + integral(pull, place, b) for place in x])
        density = along("BMassDen", x)
        flap, edge, twist = along("FlpStff", x), along("EdgStff", x), np.radians(along("StrcTwst", x))
        bending = {
            (0, 0): flap * np.cos(twist) ** 2 + edge * np.sin(twist) ** 2,
            (2, 2): flap * np.sin(twist) ** 2 + edge * np.cos(twist) ** 2,
            (0, 2): (edge - flap) * np.cos(twist) * np.sin(twist),
        }
        bending[2, 0] = bending[0, 2]
        own = np.array([4 * e, 4 * e + 1, 4 * e + 4, 4 * e + 5])
        add = lambda to, of, factor, f, g: np.add.at(to, np.ix_(own + of[0], own + of[1]), (f * (weight * factor)[:, None]).T @ g)
        for of, factor in bending.items():
            add(stiffness, of, factor, bent, bent)
        for of in [(0, 0), (2, 2)]:
            add(stiffness, of, pulled, slope, slope)
            add(mass, of, density, shape, shape)
        # In the plane the inertia pulls away from the blade, too.
        add(stiffness, (2, 2), -density * spin**2, shape, shape)
        tension += integral(pull, a, b)
    # Clamped; scaled, for deflections and slopes differ by orders.
    free = slice(4, None)
    stiffness, mass = stiffness[free, free], mass[free, free]
    scale = 1 / np.sqrt(np.diag(stiffness))
    stiffness, mass = stiffness * np.outer(scale, scale), mass * np.outer(scale, scale)
    last = len(mass) - 1
    inverses = eigh(mass, stiffness, eigvals_only=True, subset_by_index=[last - count + 1, last])
    return 1 / np.sqrt(inverses[::-1]) / (2 * np.pi)


for rpm in [0, 12.1]:
    for parts in [1, 2, 4]:
        print(f"{rpm:5} rpm, {parts} between stations: " + " ".join(f"{value:.6f}" for value in frequencies(rpm, parts)))
