"""The model from Python: `python test_swing.py`, or pytest. Needs numpy; pandas and xarray where they are installed."""

import ast
import json
import os
import signal
import tempfile
import threading
import time
import warnings

import numpy as np
import swing

HERE = os.path.dirname(os.path.abspath(__file__))


def raised(kind, call):
    try:
        call()
    except kind as error:
        return str(error)
    raise AssertionError("nothing was raised")


def test_params_have_units():
    model = swing.Swing(length="200 cm", elements=6)
    assert (model.length, model.elements, model.g) == (2.0, 6, 9.81)
    model.g = 1.62
    assert model.g == 1.62 and model.params["g"]["unit"] == "m/s^2"
    assert "did you mean `length`?" in raised(TypeError, lambda: swing.Swing(lenght=1))
    assert "does not have the dimension of m" in raised(ValueError, lambda: swing.Swing(length="2 s"))
    assert "a whole number" in raised(ValueError, lambda: swing.Swing(elements=2.5))


def test_a_run_keeps_its_energy_and_falls_as_a_rope_does():
    shown = []
    # With 16 elements the force of the hook is 1.5 % off, and the run says so.
    model = swing.Swing(elements=24)
    run = model.run(t_end=1.0, every=0.01, rtol=1e-7, progress=lambda share, t: shown.append(share))
    assert run.t.shape == (101,) and run["tip"].shape == (101, 2) and run.units["pull.x"] == "N"
    assert run.summary["energy_error"] < 1e-6
    # Until the wave from the hook arrives the free end falls freely; bending runs ahead of it by a little.
    early = run.t < 0.1
    assert np.allclose(run["tip.y"][early], -0.5 * model.g * run.t[early] ** 2, atol=2e-4)
    assert run.summary["parameters"]["length"] == 1.0
    assert all(0 < share <= 1 for share in shown)
    long = swing.Swing(length=2.0, elements=6)
    text = raised(swing.Incomplete, lambda: long.run(integrator="hht", step=0.5, t_end=2.0))
    assert "take a shorter step" in text
    assert "did you mean `rtol`?" in raised(TypeError, lambda: model.run(rtl=1))
    assert "did you mean `tip`?" in raised(KeyError, lambda: run["tipp"])


def test_modes_are_those_of_a_hanging_chain():
    model = swing.Swing(elements=16)
    modes = model.modes(3)
    # The first zero of the Bessel function J0; higher modes bend the rope, which is a little stiff.
    exact = 2.404826 / 2 * np.sqrt(model.g / model.length)
    assert abs(modes.frequencies[0] / exact - 1) < 5e-3, modes
    hertz = model.modes(3, frequency="Hz")
    assert np.allclose(hertz.frequencies * 2 * np.pi, modes.frequencies, rtol=1e-14) and "Hz>" in repr(hertz)
    assert len(modes) == 3 and np.all(np.diff(modes.frequencies) > 0) and np.all(np.abs(modes.growth) < 1e-9)
    static = model.static()
    assert abs(static["tip.y"][-1] + 1.0) < 0.01


def test_sweeps_and_tables():
    model = swing.Swing(elements=16)
    sweep = model.sweep(length=[1.0, 2.0], g="5..10 m/s^2 in 3", settings={"t_end": 0.2})
    assert len(sweep) == 6 and list(sweep["length [m]"]) == [1, 1, 1, 2, 2, 2]
    one = swing.Swing(elements=16, length=2.0, g=10.0).run(t_end=0.2)
    assert sweep["tip.y last [m]"][-1] == one["tip.y"][-1]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "run.npz")
        one.save(path)
        with np.load(path) as kept:
            assert np.array_equal(kept["tip.y"], one["tip.y"])
            assert json.loads(str(kept["units"]))["tip.y"] == "m"
    try:
        import pandas
        import xarray
    except ImportError:
        return
    assert one.to_pandas()["tip.y [m]"].iloc[-1] == one["tip.y"][-1]
    assert one.to_xarray()["tip.y"].attrs["units"] == "m"
    assert isinstance(sweep.to_pandas(), pandas.DataFrame) and xarray is not None


def test_notes_are_warnings():
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        run = swing.Swing(elements=2).run(t_end=1.0)
    assert any("mesh is too coarse" in str(one.message) for one in told), run.notes


def test_ctrl_c_ends_a_run_and_other_threads_go_on():
    beats, is_over = [], threading.Event()

    def beat():
        while not is_over.wait(0.02):
            beats.append(time.monotonic())

    threading.Thread(target=beat, daemon=True).start()
    threading.Timer(0.4, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.monotonic()
    raised(KeyboardInterrupt, lambda: swing.Swing(elements=64).run(t_end=1000.0, every=1.0))
    is_over.set()
    assert time.monotonic() - start < 10 and len(beats) > 5


def test_stubs_are_up_to_date():
    text = swing.stubs(swing)
    ast.parse(text)
    with open(os.path.join(HERE, "swing.pyi"), encoding="utf-8") as file:
        assert file.read() == text, "write them anew: python -c 'import swing; print(swing.stubs(swing), end=\"\")' > swing.pyi"


def test_type_checkers_know_what_may_be_set_and_read():
    try:
        from mypy import api
    except ImportError:
        return
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "use.py")

        def told(text):
            with open(path, "w", encoding="utf-8") as file:
                file.write(f"import swing\nmodel = swing.Swing(elements=8)\n{text}\n")
            os.environ["MYPYPATH"] = HERE
            return api.run(["--strict", "--cache-dir", os.path.join(folder, "cache"), path])[0]

        right = 'model.length = "2 m"\nlength: float = model.length\nlen(model.modes(3))\nmodel.params["g"]["unit"]'
        assert told(right).startswith("Success"), told(right)
        assert "lenght" in told('swing.Swing(lenght="2 m")')
        assert "Incompatible types" in told("model.elements = 2.5")


if __name__ == "__main__":
    warnings.simplefilter("error")
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print(f"{name}: ok")
