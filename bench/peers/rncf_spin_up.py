"""The spin-up with rncf: its example program, as anybody would start it."""

import csv
import json
import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import spin_up
from spin_up import Failed, Run

ROOT = Path(__file__).resolve().parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
PROGRAM = TARGET / "release" / "examples" / "spin_up"
BUILD = "cargo build --release --example spin_up"


@dataclass(frozen=True)
class Setting:
    """`formulation`: rncf or ancf; `integrator` and `rtol` as on the command line; no step ceiling."""

    elements: int
    integrator: str
    rtol: float
    formulation: str = "rncf"

    def __str__(self) -> str:
        return f"{self.formulation.upper()} {self.integrator} rtol {self.rtol:.0e}; {self.elements} elements"


def missing() -> str | None:
    """What to do before this code can run; `None` where it can."""
    return None if PROGRAM.exists() else f"there is no {PROGRAM}: run `{BUILD}` in {ROOT}"


def run(speed: float, setting: Setting) -> Run:
    """One process that writes all rows; its time is what `summary.json` says: model, integration and rows."""
    summary, rows = started(speed, setting, spin_up.EVERY)
    u, v = (np.array([float(row[column]) for row in rows]) for column in ("u [m]", "v [m]"))
    if len(v) != len(spin_up.ROWS):
        raise Failed(f"{len(v)} rows instead of {len(spin_up.ROWS)}")
    counts = f"{summary['newton_iterations']} iterations, {summary['factorizations']} factorizations"
    share = summary["share_at_ceiling"] or 0.0
    return Run(u, v, summary["cpu_seconds"], summary["steps"], counts, share)


def without_rows(speed: float, setting: Setting) -> float:
    """Processor time of the same steps with rows at the start and the end only, s."""
    return started(speed, setting, spin_up.RAMP)[0]["cpu_seconds"]


def started(speed: float, setting: Setting, every: float):
    """Summary and rows of one process."""
    with tempfile.TemporaryDirectory() as folder:
        arguments = [
            PROGRAM,
            f"omega_s={speed!r} rad/s",
            f"elements={setting.elements}",
            *("--formulation", setting.formulation),
            *("--integrator", setting.integrator),
            *("--rtol", repr(setting.rtol)),
            *("--t-end", f"{spin_up.RAMP} s"),
            *("--every", f"{every} s"),
            *("--out", folder),
            "--quiet",
        ]
        environment = dict(os.environ, RAYON_NUM_THREADS="1")
        done = subprocess.run(arguments, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            raise Failed(done.stderr.strip() or f"exit code {done.returncode}")
        summary = json.loads(Path(folder, "summary.json").read_text())
        with open(Path(folder, "history.csv"), newline="") as file:
            return summary, list(csv.DictReader(file))
