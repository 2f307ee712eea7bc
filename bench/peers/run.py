"""Exudyn, scipy and rncf on the spin-up in one run, in turns: errors, times and their ratios at equal error.

    .venv/bin/python bench/peers/run.py [--speeds 4,10,40,100] [--quick] [--defaults] [--rounds 2] [--out out/peers]
"""

import os

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"

import argparse
import itertools
import sys
from pathlib import Path

INSTALL = "python3 -m venv .venv && .venv/bin/pip install -r bench/peers/requirements.txt"
try:
    import numpy as np

    import exudyn_spin_up
    import measure
    import rncf_spin_up
    import scipy_spin_up
    from plan import CONVERGED, SPEEDS, Plan, plan
    from spin_up import Failed, Run
except ImportError as error:
    sys.exit(f"{error}: run `{INSTALL}`, then `.venv/bin/python bench/peers/run.py`")

CODES = {"exudyn": exudyn_spin_up, "rncf": rncf_spin_up, "scipy": scipy_spin_up}
SHORT = 1.0
"""Of runs shorter than this the least of three counts (s)."""
BEGINNING = 0.02
"""Time over which Exudyn's defaults are shown: all 15 s would take half an hour (s)."""


def main() -> None:
    """Compares at every speed asked for."""
    arguments = options()
    missing = [sentence for module in CODES.values() if (sentence := module.missing())]
    if missing:
        sys.exit("\n".join(missing))
    arguments.out.mkdir(parents=True, exist_ok=True)
    for speed in arguments.speeds:
        try:
            compare(plan(speed, arguments.quick), arguments)
        except Failed as failure:
            sys.exit(f"no converged run at {speed:g} rad/s: {failure}")


def options() -> argparse.Namespace:
    """The command line."""

    def speeds(text: str) -> list[float]:
        chosen = [float(part) for part in text.split(",")]
        if unknown := [speed for speed in chosen if speed not in SPEEDS]:
            raise argparse.ArgumentTypeError(f"no plan for {unknown[0]:g} rad/s; choose among 4, 10, 40 and 100")
        return chosen

    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--speeds", type=speeds, default=list(SPEEDS), metavar="4,10,40,100", help="of the hub, rad/s")
    parser.add_argument("--quick", action="store_true", help="only settings near the wanted error, no finest mesh")
    parser.add_argument("--defaults", action="store_true", help="the first 0.02 s of Exudyn with its defaults, too")
    parser.add_argument("--rounds", type=int, default=2, help="times that every setting gets its turn")
    parser.add_argument("--out", type=Path, default=Path("out/peers"), help="folder of the files")
    return parser.parse_args()


def compare(task: Plan, arguments: argparse.Namespace) -> None:
    """Everything about one speed: converged runs, all settings in turns, files, tables."""
    print(f"\n## {task}, {task.elements} elements\n", flush=True)
    kept = arguments.out / "converged"
    codes = ("exudyn", "rncf")
    exact = {code: converged(code, task.speed, task.elements, kept) for code in codes}
    finest = {} if arguments.quick else {code: converged(code, task.speed, task.finest, kept) for code in codes}
    exact["scipy"] = exact["rncf"]
    finest |= {"scipy": finest["rncf"]} if finest else {}
    agreement(task, exact, finest)
    if arguments.defaults:
        defaults(task)
    points = in_turns(task, arguments.rounds, exact, finest)
    kinds = ["same", "finest"] if finest else ["same"]
    for kind in kinds:
        path = arguments.out / f"spin_up_{task.speed:g}_{kind}.csv"
        measure.write(path, [point for point in points if point.code != "rncf"], kind)
        measure.write(path.with_name(f"{path.stem}_rncf.csv"), [point for point in points if point.code == "rncf"], kind)
    table(points)
    ratios(task, points, kinds)


def converged(code: str, speed: float, elements: int, folder: Path) -> Run:
    """A run whose error is far below those that are compared; Exudyn's takes long and is kept in `folder`."""
    if code == "rncf":
        return rncf_spin_up.run(speed, rncf_spin_up.Setting(elements, "radau", 1e-10))
    step, tolerance, solver = CONVERGED[speed]
    file = folder / f"exudyn_{speed:g}_{elements}_{step:g}.npy"
    if not file.exists():
        settings = (exudyn_spin_up.Setting(elements, h, tolerance, solver) for h in (step, step / 2))
        coarse, fine = (exudyn_spin_up.run(speed, setting) for setting in settings)
        folder.mkdir(parents=True, exist_ok=True)
        np.save(file, [fine.u + (fine.u - coarse.u) / 3, fine.v + (fine.v - coarse.v) / 3])
    u, v = np.load(file)
    return Run(u, v, 0.0, 0, "extrapolated")


def agreement(task: Plan, exact: dict, finest: dict) -> None:
    """How far the codes' converged runs are apart, and how far the mesh is from the finest."""
    for elements, runs in ((task.elements, exact), (task.finest, finest)):
        if runs:
            apart = np.abs(runs["exudyn"].v - runs["rncf"].v).max()
            print(f"- {elements} elements: converged Exudyn and rncf differ by {apart:.1e} m in v")
    for code in ("exudyn", "rncf") if finest else ():
        apart = np.abs(exact[code].v - finest[code].v).max()
        print(f"- {code}: {task.elements} elements differ from {task.finest} by {apart:.1e} m")


def defaults(task: Plan) -> None:
    """The beginning with Exudyn as it comes: an unfair comparison, as Newton's test on residuals stalls at round-off."""
    for plain in (True, False):
        setting = exudyn_spin_up.Setting(task.elements, 1e-3, solver="GeneralizedAlpha", plain=plain)
        seconds, steps = exudyn_spin_up.beginning(task.speed, setting, BEGINNING)
        name = "defaults (unfair)" if plain else "tuned"
        print(f"- Exudyn, {name}, first {BEGINNING:g} s in steps of 1e-3 s: {seconds:.2g} s, {steps} steps")


def in_turns(task: Plan, rounds: int, exact: dict, finest: dict) -> list:
    """All settings, codes in turns; the least time of all rounds counts."""
    by_code = [[(code, s) for s in task.settings if isinstance(s, CODES[code].Setting)] for code in CODES]
    turns = [turn for group in itertools.zip_longest(*by_code) for turn in group if turn]
    points: dict = {}
    for _ in range(rounds):
        for code, setting in turns:
            if (code, setting) in points and points[code, setting] is None:
                continue
            try:
                run, cpu, alone = timed(code, task.speed, setting)
            except Failed as failure:
                print(f"- {code}, {setting}: {failure}", flush=True)
                points[code, setting] = None
                continue
            against = measure.errors(run, finest[code]) if finest else None
            point = points.setdefault(
                (code, setting), measure.Point(code, setting, run, cpu, alone, measure.errors(run, exact[code]), against)
            )
            point.cpu, point.alone = min(point.cpu, cpu), min(point.alone, alone)
    return [point for point in points.values() if point]


def timed(code: str, speed: float, setting):
    """A run, its time and that of the same steps without rows; the least of three if it is short."""
    run = CODES[code].run(speed, setting)
    times = [run.cpu]
    if run.cpu < SHORT:
        times += [CODES[code].run(speed, setting).cpu for _ in range(2)]
    if code != "rncf":
        return run, min(times), min(times)
    return run, min(times), min(rncf_spin_up.without_rows(speed, setting) for _ in times)


def table(points: list) -> None:
    """All points, cheapest first."""
    print("\n| code | setting | error of v (m) | against the finest mesh | CPU s | without rows, s | steps | |")
    print("|---|---|---|---|---|---|---|---|")
    for p in sorted(points, key=lambda point: point.cpu):
        finest = f"{p.of('finest'):.1e}" if p.finest else ""
        row = [p.code, p.setting, f"{p.of('same'):.1e}", finest, f"{p.cpu:.4g}", f"{p.alone:.4g}", p.run.steps, p.run.counts]
        print("| " + " | ".join(str(value) for value in row) + " |")


def ratios(task: Plan, points: list, kinds: list[str]) -> None:
    """Times at the wanted error and their ratios to rncf's."""
    for kind in kinds:
        against = f"its own converged run of {task.elements if kind == 'same' else task.finest} elements"
        print(f"\nAt an error of {task.wanted:g} m against {against}:\n")
        ours = [p for p in points if p.code == "rncf" and p.setting.formulation == "rncf" and p.run.share_at_ceiling <= 0.1]
        whole = measure.cheapest(ours, task.wanted, kind)
        alone = measure.cheapest(ours, task.wanted, kind, lambda point: point.alone)
        if not whole:
            print("- rncf does not reach it")
            continue
        print(f"- rncf: {whole[0]:.4f} s with all rows, {alone[0]:.4f} s without; {whole[1]}")
        for code in ("exudyn", "scipy"):
            theirs = [point for point in points if point.code == code]
            best = measure.cheapest(theirs, task.wanted, kind)
            if best:
                print(f"- {code}: {best[0]:.3f} s, {best[0] / whole[0]:.0f} times, {best[0] / alone[0]:.0f} times; {best[1]}")
            elif theirs:
                print(f"- {code} does not reach it with these settings")


if __name__ == "__main__":
    main()
