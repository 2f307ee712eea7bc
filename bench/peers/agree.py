"""Do the codes solve one problem? Converged runs on a coarse mesh, law of the element and root exchanged one at a time.

    .venv/bin/python bench/peers/agree.py [--speed 4] [--elements 6]
"""

import argparse
import os
import sys

os.environ["OPENBLAS_NUM_THREADS"] = "1"

try:
    import numpy as np

    import exudyn_spin_up
    import rncf_spin_up
    import scipy_spin_up
    from spin_up import Failed
except ImportError as error:
    sys.exit(f"{error}: run `python3 -m venv .venv && .venv/bin/pip install -r bench/peers/requirements.txt`")


def main() -> None:
    """Runs all and prints the differences."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--speed", type=float, default=4.0, help="of the hub, rad/s")
    parser.add_argument("--elements", type=int, default=6)
    parser.add_argument("--step", type=float, default=5e-4, help="Exudyn is extrapolated from this step and its half, s")
    arguments = parser.parse_args()
    if missing := exudyn_spin_up.missing() or rncf_spin_up.missing():
        sys.exit(missing)
    speed, elements, step = arguments.speed, arguments.elements, arguments.step

    def by_scipy(law: str, free_norm: bool) -> np.ndarray:
        setting = scipy_spin_up.Setting(elements, "Radau", 1e-7, law, free_norm, patience=300.0)
        return scipy_spin_up.run(speed, setting).v

    coarse, fine = (exudyn_spin_up.run(speed, exudyn_spin_up.Setting(elements, h, 1e-11)).v for h in (step, step / 2))
    exudyn = fine + (fine - coarse) / 3
    rncf = rncf_spin_up.run(speed, rncf_spin_up.Setting(elements, "radau", 1e-10)).v
    same_element, free_root, ours = by_scipy("exact", False), by_scipy("exact", True), by_scipy("quartic", True)
    print(f"Largest differences of the tip's v over [0, 15 s], spin-up at {speed:g} rad/s, {elements} elements:")
    for name, one, other in (
        ("Exudyn, extrapolated, and its element in scipy", exudyn, same_element),
        ("root slope of length 1 and root slope of free length", same_element, free_root),
        ("strain |r_x| - 1 with exact curvature and the quartic energy of rncf", free_root, ours),
        ("rncf's element in scipy and rncf", ours, rncf),
    ):
        print(f"- {name}: {np.abs(one - other).max():.1e} m")


if __name__ == "__main__":
    try:
        main()
    except Failed as failure:
        sys.exit(str(failure))
