#!/usr/bin/env python3
"""Share of the instructions of short runs that compute with four numbers at once already, and what four runs side by side, one
in each lane, could gain at best: those instructions would be needed four times, all others once for the four runs.

    cargo build --release --example instructions
    python3 bench/lanes.py spin_up andrews_squeezer

Needs valgrind and objdump. What counts is in the program itself; the C library's share is told beside it.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TARGET = Path(os.environ.get("CARGO_TARGET_DIR", Path(__file__).parent.parent / "target"))
PROGRAM = TARGET / "release/examples/instructions"
# An instruction's address, the line of its source, and how often it was executed.
EXECUTED = re.compile(r"0x([0-9a-f]+) \S+ (\d+)")
DISASSEMBLED = re.compile(r"\s+([0-9a-f]+):\s+\S+\s*(.*)")


def wide(program):
    """For every address whether its instruction has registers of four doubles."""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], capture_output=True, text=True, check=True).stdout
    found = map(DISASSEMBLED.match, text.splitlines())
    return {int(line[1], 16): "ymm" in line[2] for line in found if line}


def counted(scene):
    """Pairs of address and number of executions in a run of a scene."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "counts"
        command = ["valgrind", "--tool=callgrind", "--dump-instr=yes", "--compress-pos=no", f"--callgrind-out-file={out}"]
        subprocess.run([*command, PROGRAM, scene], capture_output=True, check=True, env={**os.environ, "RAYON_NUM_THREADS": "1"})
        of_call = False
        for line in out.read_text().splitlines():
            if line.startswith("calls="):
                of_call = True
            elif executed := EXECUTED.match(line):
                # The line behind a call has what the called function takes.
                if not of_call:
                    yield int(executed[1], 16), int(executed[2])
                of_call = False


def main():
    is_wide = wide(PROGRAM)
    print("| scene | millions | four at once | C library | gain at best |")
    print("|---|---|---|---|---|")
    for scene in sys.argv[1:]:
        total = four = library = 0
        for address, count in counted(scene):
            total += count
            four += count * is_wide.get(address, False)
            library += count * (address not in is_wide)
        share = four / total
        print(f"| {scene} | {total / 1e6:.1f} | {share:.1%} | {library / total:.1%} | {4 / (4 * share + 1 - share):.2f} |")


if __name__ == "__main__":
    main()
