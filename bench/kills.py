#!/usr/bin/env python3
"""What a run loses: kills at random moments with every signal, a full disk, memory over rows.

    cargo build --release --examples
    python3 bench/kills.py [--programs target/release/examples] [--kills 20] [--only KILL,disk,memory,..]

A run is ended again and again, and goes on with `--resume` each time; in the end its history.csv, its animation and its
summary (but for date and times) must be those of a run that was not ended, byte for byte. Python alone is needed; the full
disk is a small tmpfs where this user may mount one, else a limit of the size of files. The log of one call is
docs/kills.md.
"""

import argparse
import filecmp
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENES = {
    "beam, Radau": ["spin_up", "--t-end", "100 s", "--every", "1 ms", "--rtol", "1e-11", "--animate"],
    "beam, HHT": ["spin_up", "--integrator", "hht", "--formulation", "ancf", "--every", "1 ms", "--rtol", "1e-8", "--t-end", "60 s"],
    "motor, sections": ["motor", "--every", "50 us", "--rtol", "1e-8"],
    "slider-crank": ["slider_crank", "--integrator", "generalized-alpha", "--no-elimination", "--every", "1 ms", "--rtol", "1e-9", "--t-end", "8 s"],
}
SIGNALS = {
    "KILL": [signal.SIGKILL],
    "TERM": [signal.SIGTERM],
    "HUP": [signal.SIGHUP],
    "INT twice": [signal.SIGINT, signal.SIGINT],
}


class Bench:
    def __init__(self, programs, work, kills):
        self.programs, self.work, self.kills = programs, work, kills
        self.random = random.Random(14)
        self.whole = {}

    def command(self, scene, out, more=()):
        program, *words = SCENES[scene]
        return [str(self.programs / program), "run", *words, "--quiet", *more, "--out", str(out)]

    def reference(self, scene):
        """The run that nothing ends: its folder and the time it takes."""
        if scene not in self.whole:
            out = self.work / f"whole-{len(self.whole)}"
            start = time.monotonic()
            subprocess.run(self.command(scene, out), check=True)
            self.whole[scene] = (out, time.monotonic() - start)
        return self.whole[scene]

    def compare(self, scene, out):
        whole, _ = self.reference(scene)
        assert filecmp.cmp(whole / "history.csv", out / "history.csv", shallow=False), f"{scene}: history.csv differs"
        if (whole / "animation.html").exists():
            same = filecmp.cmp(whole / "animation.html", out / "animation.html", shallow=False)
            assert same, f"{scene}: animation.html differs"
        assert summary(whole) == summary(out), f"{scene}: summary.json differs"
        left = sorted(path.name for path in out.iterdir())
        assert left == sorted(path.name for path in whole.iterdir()), left

    def kill(self, name):
        """One signal, many times: chains of five kills of one run."""
        ended, missed, repeated, oldest = 0, 0, 0.0, 0.0
        while ended < self.kills:
            scene = list(SCENES)[(ended // 5) % len(SCENES)]
            _, takes = self.reference(scene)
            out = self.work / f"killed-{name.replace(' ', '-')}-{ended}"
            shutil.rmtree(out, ignore_errors=True)
            start, more = time.monotonic(), []
            for _ in range(5):
                if ended == self.kills:
                    break
                process = subprocess.Popen(self.command(scene, out, more), stderr=subprocess.DEVNULL)
                # Also before there is anything to lose.
                delay = self.random.uniform(0.0, 0.4 * takes)
                time.sleep(delay)
                for number in SIGNALS[name]:
                    if process.poll() is None:
                        process.send_signal(number)
                        time.sleep(self.random.uniform(0.0, 0.01))
                killed = time.time()
                code = process.wait()
                if code == 0:
                    missed += 1
                    break
                ended += 1
                rows, written = history(out)
                # A run that goes on repeats some steps first.
                if rows and not more:
                    oldest = max(oldest, killed - written)
                # Killed before the first checkpoint there is nothing to go on with.
                more = ["--resume"] if (out / "checkpoint").exists() else []
            subprocess.run(self.command(scene, out, more), check=True)
            repeated += max(0.0, time.monotonic() - start - takes)
            self.compare(scene, out)
            shutil.rmtree(out)
        print(
            f"{name}: {ended} kills, all results as without; rows on disk up to {oldest:.2f} s before the signal; "
            f"{repeated / max(ended, 1):.1f} s of repeated work a kill ({missed} runs ended before the signal)",
            flush=True,
        )

    def disk(self):
        """A disk that is full, and has room again."""
        scene = next(iter(SCENES))
        whole, _ = self.reference(scene)
        size = sum(path.stat().st_size for path in whole.iterdir())
        place = self.work / "small"
        place.mkdir()
        mounted = os.geteuid() == 0 and mount(place, f"size={size // 2}")
        out = place / "out"
        limit = None if mounted else (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size // 3, size // 3)))
        try:
            ended = subprocess.run(self.command(scene, out), stderr=subprocess.PIPE, text=True, preexec_fn=limit)
            assert ended.returncode != 0, "the disk was not full"
            told = ended.stderr.strip().splitlines()[:1]
            rows, _ = history(out)
            if mounted:
                assert mount(place, f"remount,size={4 * size}"), "no room can be made"
            subprocess.run(self.command(scene, out, ["--resume"]), check=True)
            self.compare(scene, out)
        finally:
            if mounted:
                subprocess.run(["umount", str(place)], check=False)
        kind = "a tmpfs" if mounted else "a limit of the size of files (the system kills the program)"
        told = f": {told[0].replace(str(self.work), '..')}" if told else ""
        print(f"full disk ({kind}): exit code {ended.returncode} after {rows} rows{told}; with room again, the result is as without", flush=True)

    def memory(self):
        """Largest memory of runs with ever more rows."""
        for rows in (10_000, 100_000, 1_000_000):
            out = self.work / "rows"
            command = [str(self.programs / "spin_up"), "run", "--quiet", "--every", f"{20.0 / rows} s", "--out", str(out)]
            start = time.monotonic()
            process = subprocess.Popen(command)
            most = 0.0
            while process.poll() is None:
                most = max(most, peak(process.pid))
                time.sleep(0.01)
            assert process.returncode == 0, process.returncode
            took, size = time.monotonic() - start, (out / "history.csv").stat().st_size
            print(
                f"memory: {rows:>9,} rows, {size / 1e6:7.1f} MB of history, {most:6.1f} MiB, {took:5.1f} s",
                flush=True,
            )
            shutil.rmtree(out)


def mount(place, options):
    command = ["mount", "-t", "tmpfs", "-o", options, "tmpfs", str(place)]
    return subprocess.run(command, stderr=subprocess.DEVNULL, check=False).returncode == 0


def peak(process):
    """Largest memory of a process so far, MiB."""
    try:
        lines = Path(f"/proc/{process}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return max((int(line.split()[1]) / 1024 for line in lines if line.startswith("VmHWM")), default=0.0)


def history(out):
    """Whole rows of a table, and when it was written last."""
    path = out / "history.csv"
    if not path.exists():
        return 0, 0.0
    return max(0, path.read_bytes().count(b"\n") - 1), path.stat().st_mtime


def summary(out):
    known = json.loads((out / "summary.json").read_text())
    for key in ("date", "cpu_seconds", "wall_seconds", "command_line"):
        del known[key]
    return known


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, default=Path("target/release/examples"))
    parser.add_argument("--kills", type=int, default=20, help="kills with each signal")
    parser.add_argument("--only", help="names of signals, disk, memory; separated by commas")
    chosen = parser.parse_args()
    parts = chosen.only.split(",") if chosen.only else [*SIGNALS, "disk", "memory"]
    work = Path(tempfile.mkdtemp(prefix="rncf-kills-"))
    bench = Bench(chosen.programs.resolve(), work, chosen.kills)
    try:
        for part in parts:
            match part:
                case "disk":
                    bench.disk()
                case "memory":
                    bench.memory()
                case name:
                    bench.kill(name)
        for scene, (_, takes) in bench.whole.items():
            print(f"without: {scene} takes {takes:.1f} s")
    finally:
        shutil.rmtree(work, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
