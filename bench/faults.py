#!/usr/bin/env python3
"""What the tests catch: twenty-two deliberate faults, one after the other.

    python3 bench/faults.py [--folder FOLDER] [--only NAME,NAME]

Each fault is a text that stands exactly once in a file, and what replaces it: a wrong sign, a lost row, a lost message. The
committed state is copied to a folder outside (default: a temporary one; a folder that is given keeps what was built), the
fault is written into the copy, and the tests that should see it are run, the cheapest first. A fault is caught where a test
fails, or where the models of the repository do not compile any more. Python and git are needed. Takes about half an hour on four cores; the
log of one call is in docs/building.md.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

RUNTIME = "-p rncf-runtime --lib"
CODEGEN = "-p rncf-codegen --lib"
TEXTS = "-p rncf-codegen --test texts"
APP = "-p rncf --features app --lib"
ACCURACY = "-p rncf-tests --test accuracy"

# name: file, text, replacement, tests in the order in which they are asked
FAULTS = {
    "sign of the moment of inertia forces on a frame": (
        "rncf-runtime/src/scene/terms/inertia.rs",
        "moment += first(&spread::<D, W>(&places, &q[place])).cross(&first(&g));",
        "moment -= first(&spread::<D, W>(&places, &q[place])).cross(&first(&g));",
        [RUNTIME],
    ),
    "a Gauss weight": (
        "rncf-runtime/src/emitted/gauss.rs",
        "(0.5, 0.284_444_444_444_444_45)",
        "(0.5, 0.284_444_454_444_444_45)",
        [RUNTIME],
    ),
    "a lost constraint row": (
        "rncf-macros/codegen/src/joints/kinds.rs",
        "    for which in 0..2 {\n        let normal = joint.normal_to(1, start, which);",
        "    for which in 0..1 {\n        let normal = joint.normal_to(1, start, which);",
        [CODEGEN, ACCURACY + " multibody"],
    ),
    "a unit's factor": (
        "rncf-macros/codegen/src/units/table.rs",
        'times("deg", ANGLE, PI / 180.0)',
        'times("deg", ANGLE, PI / 200.0)',
        [CODEGEN],
    ),
    "a lost message": (
        "rncf-macros/codegen/src/check/loads/marker_forces.rs",
        "                self.errors.at(expr.area, say::FOLLOWER_COMPONENTS);\n",
        "",
        [CODEGEN, TEXTS],
    ),
    "a coefficient of Radau's method": (
        "rncf-runtime/src/integrate/radau/coefficients.rs",
        "return weights[j] / own / (at - nodes[j]);",
        "return weights[j] / own / (at + nodes[j]);",
        [RUNTIME],
    ),
    "the gyroscopic term of small motions": (
        "rncf-runtime/src/scene/turning/uniform.rs",
        "out.damping[place] += mass[i] * self.coriolis[i * k + j];",
        "out.damping[place] += 0.0 * mass[i] * self.coriolis[i * k + j];",
        [RUNTIME],
    ),
    "a shape function": (
        "rncf-macros/codegen/src/library/cable.rncf",
        "shape xi - 2*xi^2 + xi^3;",
        "shape xi - 2*xi^2 + 2*xi^3;",
        [CODEGEN],
    ),
    "a lost term of the tangent of inertia": (
        "rncf-runtime/src/scene/terms/inertia_tangent.rs",
        "let swing = sum(&[(1.0, &(rate * w)), (1.0, &(w * rate))]);",
        "let swing = sum(&[(1.0, &(rate * w))]);",
        [RUNTIME],
    ),
    "sign of a follower force": (
        "rncf-macros/codegen/src/check/loads/marker_forces.rs",
        "let mut force = algebra::scale(&along, &tangent);",
        "let mut force = algebra::scale(&algebra::subtract(Value::Number(0.0), along), &tangent);",
        [CODEGEN, ACCURACY + " hanging", "-p rncf-tests --test beams"],
    ),
    "sign of a dead force": (
        "rncf-runtime/src/scene/terms/dead_loads.rs",
        "self.buffers.force[component] -= weight * value[place % dimension];",
        "self.buffers.force[component] += weight * value[place % dimension];",
        [RUNTIME, ACCURACY + " hanging"],
    ),
    "Radau's error estimate, a hundredth": (
        "rncf-runtime/src/integrate/radau/error.rs",
        "        (sum / (2 * self.x.len()).max(1) as f64).sqrt()",
        "        0.01 * (sum / (2 * self.x.len()).max(1) as f64).sqrt()",
        [RUNTIME, ACCURACY],
    ),
    "a tolerance that is not passed on": (
        "rncf-runtime/src/integrate/options.rs",
        "(self.rtol / ALPHA_CONSTANT).powf(1.5)",
        "(Self::default().rtol / ALPHA_CONSTANT).powf(1.5)",
        [RUNTIME, ACCURACY],
    ),
    "four elements that are left out": (
        "rncf-runtime/src/scene/pieces/batches.rs",
        "    for unit in 0..count {\n        evaluate(unit, result);",
        "    for unit in 1..count {\n        evaluate(unit, result);",
        [RUNTIME],
    ),
    "a lost kink": (
        "rncf-runtime/src/integrate/switches.rs",
        "    if sign(to.1[0]) != old {\n        return",
        "    if sign(to.1[0]) != old && to.1[0] > 0.0 {\n        return",
        [RUNTIME],
    ),
    "sign of a spring's damping": (
        "rncf-macros/codegen/src/check/loads/spring.rs",
        "force = add(force, multiply(damping, rate));",
        "force = add(force, multiply(Value::Number(-1.0), multiply(damping, rate)));",
        [CODEGEN, ACCURACY],
    ),
    "axes of a section, exchanged": (
        "rncf-macros/codegen/src/check/sections/section.rs",
        "(area, [cubed(z, y), cubed(y, z)], torsion)",
        "(area, [cubed(y, z), cubed(z, y)], torsion)",
        [CODEGEN],
    ),
    "the torsion constant of a circle": (
        "rncf-macros/codegen/src/check/sections/section.rs",
        "let torsion = product([number(PI / 2.0), power(radius, 4.0)]);",
        "let torsion = product([number(PI / 4.0), power(radius, 4.0)]);",
        [CODEGEN],
    ),
    "slopes of monotone tables": (
        "rncf-macros/codegen/src/import/spline.rs",
        "(weights[0] + weights[1]) / (weights[0] / left + weights[1] / right)",
        "0.5 * (left + right)",
        [RUNTIME],
    ),
    "files that are not renamed when whole": (
        "src/app/machine/files.rs",
        "fs::write(&partial, bytes).and_then(|()| fs::rename(&partial, &path))",
        "fs::write(&path, bytes)",
        [APP],
    ),
    "a lost unit in the head of a column": (
        "src/app/results/history.rs",
        'format!("{} [{}]", self.name, self.unit)',
        "self.name.to_string()",
        [APP],
    ),
    "a note that is not told": (
        "src/app/runs/run.rs",
        "    result.warnings.extend(told);\n}",
        "    let _ = told;\n}",
        [APP, ACCURACY + " coarse_meshes"],
    ),
}


def copied(folder):
    """The committed state in a folder, whatever was built there before."""
    archive = subprocess.run(["git", "archive", "HEAD"], check=True, capture_output=True).stdout
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["tar", "x", "-C", folder], input=archive, check=True)


def asked(folder, tests):
    """The first test that fails, 'does not compile' where nothing runs, or None."""
    environment = {**os.environ, "CARGO_INCREMENTAL": "0", "CARGO_PROFILE_DEV_DEBUG": "0"}
    for test in tests:
        command = ["cargo", "test", "--quiet", "--profile", "edit", *test.split()]
        ended = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
        if ended.returncode == 0:
            continue
        failed = re.findall(r"^test (\S+) \.\.\. FAILED|^    ([a-z_0-9:]+)$", ended.stdout, re.MULTILINE)
        names = sorted({first or second for first, second in failed})
        if names:
            return f"{len(names)} failed, {names[0]}"
        return "does not compile: " + next((line for line in ended.stderr.splitlines() if "error" in line), "")[:100]
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--check", action="store_true", help="only whether each text still stands once")
    parser.add_argument("--only", type=lambda text: text.split(","))
    arguments = parser.parse_args()
    root = Path(subprocess.run(["git", "rev-parse", "--show-toplevel"], check=True, capture_output=True, text=True).stdout.strip())
    os.chdir(root)
    chosen = {name: fault for name, fault in FAULTS.items() if not arguments.only or name in arguments.only}
    for name, (file, text, _, _) in chosen.items():
        count = (root / file).read_text().count(text)
        if count != 1:
            sys.exit(f"{name}: its text stands {count} times in {file}, and it must stand once: renew the fault")
    if arguments.check:
        return
    folder = arguments.folder or Path(tempfile.mkdtemp(prefix="rncf-faults-"))
    copied(folder)
    missed = 0
    for name, (file, text, replacement, tests) in chosen.items():
        path = folder / file
        right = path.read_text()
        start = time.monotonic()
        try:
            path.write_text(right.replace(text, replacement))
            caught = asked(folder, tests)
        finally:
            path.write_text(right)
        missed += caught is None
        print(f"| {name} | {caught or 'NOT CAUGHT'} | {time.monotonic() - start:.0f} s |", flush=True)
    print(f"{len(chosen) - missed} of {len(chosen)} caught")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
