"""Errors, the time at an error, and the files."""

import csv
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from spin_up import Run

HEAD = ["code", "setting", "output", "error_max", "error_rms", "cpu_s", "steps"]
"""Columns of the files, as `chart --beside` reads them: SI units, time of one thread."""

CHANGING = ("step", "rtol")
"""What sets the accuracy within a family of settings."""


@dataclass
class Point:
    """A setting of a code with its errors: `same`: against the converged run of its mesh, `finest`: of the finest mesh (m);
    `alone`: the time without model and rows, where it is known apart (s)."""

    code: str
    setting: object
    run: Run
    cpu: float
    alone: float
    same: dict
    finest: dict | None

    def of(self, kind: str) -> float:
        """Largest error of v, `kind` being `same` or `finest`."""
        return getattr(self, kind)["v"][0]


def errors(run: Run, exact: Run) -> dict:
    """Largest and root-mean-square difference of u and v over all rows, m."""
    differences = {"u": run.u - exact.u, "v": run.v - exact.v}
    return {name: (float(np.abs(d).max()), float(np.sqrt((d * d).mean()))) for name, d in differences.items()}


def write(path: Path, points: list[Point], kind: str) -> None:
    """The points as a file, sorted by code; rncf's time is that without rows, as `chart` measures it."""
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(HEAD)
        for point in sorted(points, key=lambda point: point.code):
            for output, (largest, mean) in getattr(point, kind).items():
                values = [f"{value:.4e}" for value in (largest, mean, point.alone)]
                table.writerow([point.code, point.setting, output, *values, point.run.steps])


def cheapest(points: list[Point], wanted: float, kind: str, cost=lambda point: point.cpu):
    """Least time at the wanted error and the setting: of points that reach it, and between neighbours of one family, log-log."""
    found = [(cost(point), str(point.setting)) for point in points if point.of(kind) <= wanted]
    families: dict = {}
    for point in points:
        families.setdefault(family(point), []).append(point)
    for members in families.values():
        members.sort(key=lambda point: -next(vars(point.setting)[name] for name in CHANGING if name in vars(point.setting)))
        for coarse, fine in zip(members, members[1:]):
            if fine.of(kind) <= wanted < coarse.of(kind):
                part = math.log(coarse.of(kind) / wanted) / math.log(coarse.of(kind) / fine.of(kind))
                seconds = cost(coarse) ** (1 - part) * cost(fine) ** part
                found.append((seconds, f"between `{coarse.setting}` and `{fine.setting}`"))
    return min(found, default=None)


def family(point: Point):
    """What points must share so that a value between them means anything: all but the step or the tolerance."""
    return point.code, *(value for name, value in vars(point.setting).items() if name not in CHANGING)
