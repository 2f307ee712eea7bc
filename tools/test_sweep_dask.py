"""A sweep on three Dask workers, one of which is killed in the middle: nothing is lost, nothing is there twice.

`python tools/test_sweep_dask.py target/release/examples/spin_up`
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile

from distributed import Client, LocalCluster
from sweep_dask import sweep

POINTS = 24
VARIED = ["T_s=5..15 s in 4", "omega_s=1..6 rad/s in 6"]
SETTINGS = ["elements=8", "--outputs=u,v"]


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        alone, shared = (pathlib.Path(folder, name) for name in ("alone", "shared"))
        for command, out in (("sweep", alone), ("plan", shared)):
            line = [program, command, *VARIED, *SETTINGS, "--quiet", "--out", str(out)]
            subprocess.run(line, check=True)
        killed = []
        with LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
            with Client(cluster) as client:

                def progress(done, count):
                    print(f"{done} of {count} points", flush=True)
                    if done == count // 3 and not killed:
                        pids = client.run(os.getpid)
                        killed.append(next(iter(pids.values())))
                        os.kill(killed[0], signal.SIGKILL)
                        print(f"killed the worker with process {killed[0]}", flush=True)

                print(sweep(client, program, shared / "plan.toml", shared, progress))
        assert killed, "no worker was killed"
        names = sorted(path.name for path in shared.glob("points-*/*"))
        assert names == [f"point-{index:06}.json" for index in range(POINTS)], names
        assert (shared / "sweep.csv").read_bytes() == (alone / "sweep.csv").read_bytes()
        print("ok: all points are there once, and the table is that of one machine")


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]))
