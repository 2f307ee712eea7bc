"""Hands out the points of a plan with Dask: `python tools/sweep_dask.py PROGRAM plan.toml --out FOLDER`.

The folder must be one that all workers see. A point that is there is not computed again, and a point whose worker dies is
given to another one, so that the same command goes on wherever it was ended. Needs `pip install distributed`.
"""

import argparse
import pathlib
import subprocess
import sys
import tomllib

from distributed import Client, LocalCluster, as_completed


def point(program, plan, index, out):
    """Computes one point in a process of its own; what went wrong, or None."""
    line = [program, "task", "--plan", plan, "--index", str(index), "--out", out]
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    return None if done.returncode == 0 else f"point {index}: {done.stderr.strip()}"


def sweep(client, program, plan, out, progress=lambda done, count: None):
    """Computes all points and collects them; raises RuntimeError where points are missing."""
    with open(plan, "rb") as file:
        count = tomllib.load(file)["points"]
    program, plan, out = (str(pathlib.Path(path).resolve()) for path in (program, plan, out))
    tasks = client.map(lambda index: point(program, plan, index, out), range(count), pure=False, retries=3)
    wrong = []
    for done, task in enumerate(as_completed(tasks), 1):
        try:
            found = task.result()
        except Exception as error:  # the worker is gone for the fourth time
            found = str(error)
        wrong += [found] if found else []
        progress(done, count)
    collected = subprocess.run(
        [program, "collect", "--plan", plan, "--out", out], capture_output=True, text=True, check=False
    )
    if wrong or collected.returncode:
        raise RuntimeError("\n".join([*wrong, collected.stderr.strip()]))
    return collected.stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the model's program")
    parser.add_argument("plan", help="its plan.toml, written by `plan` or `sweep`")
    parser.add_argument("--out", required=True, help="folder of the points, seen by all workers")
    parser.add_argument("--scheduler", help="address of a running scheduler (default: workers on this machine)")
    parser.add_argument("--workers", type=int, help="how many workers on this machine (default: one a core)")
    given = parser.parse_args()
    cluster = None if given.scheduler else LocalCluster(n_workers=given.workers, threads_per_worker=1)
    with Client(given.scheduler or cluster) as client:
        show = lambda done, count: print(f"\r{done} of {count} points", end="", file=sys.stderr, flush=True)
        try:
            print("\n" + sweep(client, given.program, given.plan, given.out, show))
        except RuntimeError as error:
            sys.exit(f"\nerror: {error}")
        finally:
            if cluster:
                cluster.close()


if __name__ == "__main__":
    main()
