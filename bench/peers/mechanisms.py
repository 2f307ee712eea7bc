"""Exudyn and rncf on two small mechanisms, the heavy top and Andrews' squeezer, in turns: errors, times, their ratio at equal error.

    cargo build --release --example heavy_top --example andrews_squeezer
    .venv/bin/python bench/peers/mechanisms.py [--rounds 5] [--only heavy_top]

Errors are against published numbers at the end of the run. Exudyn's time is that of `SolveDynamic` alone, rncf's that of its
program: model, start, steps and the rows at start and end. The least of all rounds counts.
"""

import os

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "RAYON_NUM_THREADS"):
    os.environ[name] = "1"

import argparse
import csv
import itertools
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

INSTALL = "python3 -m venv .venv && .venv/bin/pip install -r bench/peers/requirements.txt"
try:
    import exudyn_mechanisms
except ImportError as error:
    sys.exit(f"{error}: run `{INSTALL}`, then `.venv/bin/python bench/peers/mechanisms.py`")

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release" / "examples"
TOLERANCES = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9]
METHODS = ["radau", "radau9", "radau13"]
OURS = list(itertools.product(METHODS, TOLERANCES))
WANTED = {
    "heavy_top": [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8],
    "andrews_squeezer": [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7],
}
EXACT = {
    "heavy_top": {"x [m]": 0.17334396410, "y [m]": 0.64008859207, "z [m]": -0.74849079113},
    "andrews_squeezer": {"beta [rad]": 15.81077119629904, "gamma [rad]": 0.04082224013073101},
}
"""Published values at the end: Brüls, Cardona & Arnold (2012), converged, and the IVP test set."""
END = {"heavy_top": 1.0, "andrews_squeezer": 0.03}


def main() -> None:
    """Both mechanisms, all settings in turns."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5, help="times that every setting gets its turn")
    parser.add_argument("--only", choices=list(EXACT), help="one of the two")
    arguments = parser.parse_args()
    rounds, chosen = arguments.rounds, [arguments.only] if arguments.only else list(EXACT)
    missing = [name for name in EXACT if not (PROGRAMS / name).exists()]
    if missing:
        sys.exit(f"there is no {PROGRAMS / missing[0]}: run `cargo build --release --example {' --example '.join(EXACT)}` in {ROOT}")
    for name in chosen:
        settings = exudyn_mechanisms.settings(name)
        points: dict = {}
        for _, run in itertools.product(range(rounds), [*settings, *OURS]):
            done = rncf(name, *run) if isinstance(run, tuple) else exudyn_mechanisms.run(name, run)
            if done is not None:
                values, seconds, steps = done
                error = max(abs(value - exact) for value, exact in zip(values, EXACT[name].values()))
                before = points.get(run, (error, math.inf, steps))
                points[run] = (error, min(seconds, before[1]), steps)
        show(name, points)


def rncf(name: str, method: str, rtol: float):
    """Values at the end, processor time (s), steps."""
    with tempfile.TemporaryDirectory() as folder:
        flags = ["--integrator", method, "--rtol", repr(rtol), "--every", f"{END[name]} s", "--out", folder, "--quiet", "--unjudged"]
        done = subprocess.run([PROGRAMS / name, *flags], capture_output=True, text=True)
        if done.returncode != 0:
            print(f"rncf, {name}, {method}, rtol {rtol:.0e}: {done.stderr.strip()}", file=sys.stderr)
            return None
        summary = json.loads(Path(folder, "summary.json").read_text())
        with open(Path(folder, "history.csv"), newline="") as file:
            last = list(csv.DictReader(file))[-1]
    return [float(last[column]) for column in EXACT[name]], summary["cpu_seconds"], summary["steps"]


def show(name: str, points: dict) -> None:
    """All points, and the ratios."""
    print(f"\n## {name}\n\n| code | setting | error | steps | ms |\n|---|---|---|---|---|")
    for run, (error, seconds, steps) in sorted(points.items(), key=lambda item: (isinstance(item[0], tuple), str(item[0]))):
        code, setting = ("rncf", words(run)) if isinstance(run, tuple) else ("Exudyn", run)
        print(f"| {code} | {setting} | {error:.1e} | {steps} | {1e3 * seconds:.2f} |")
    print("\n| error | Exudyn, ms: setting | rncf, ms: setting | ratio |\n|---|---|---|---|")
    for wanted in WANTED[name]:
        good = [(seconds, run) for run, (error, seconds, _) in points.items() if error <= wanted]
        ours = min(((s, run) for s, run in good if isinstance(run, tuple)), default=None)
        theirs = min(((s, run) for s, run in good if not isinstance(run, tuple)), default=None, key=lambda item: item[0])
        columns = [f"{1e3 * seconds:.2f}: {words(run)}" for seconds, run in (theirs, ours)] if ours and theirs else []
        if columns:
            print(f"| {wanted:.0e} | {columns[0]} | {columns[1]} | {theirs[0] / ours[0]:.1f} |")
        else:
            print(f"| {wanted:.0e} | {words(theirs[1]) if theirs else 'no setting'} | {words(ours[1]) if ours else 'no setting'} | |")


def words(run) -> str:
    """A setting in words."""
    return f"{run[0]}, rtol {run[1]:.0e}" if isinstance(run, tuple) else run


if __name__ == "__main__":
    main()
