"""What a Python user meets of a model: keyword arguments with units, numpy arrays, exceptions with the same sentences."""

import csv
import difflib
import json
import keyword
import os
import sys
import tempfile
import warnings

import numpy as np

_BASES = ("m", "kg", "s", "K", "A", "rad")
# A bare number for one of these is in seconds or rad/s.
_UNITS = {"t-end": "s", "every": "s", "step": "s", "max-step": "s", "at": "s", "limit": "s", "spin": "rad/s"}


class Incomplete(RuntimeError):
    """A calculation ended before its end; `result` holds what there is up to there."""

    def __init__(self, reason, result):
        super().__init__(reason)
        self.result = result


# The units of frequencies, rad/s.
_PER_SECOND = {"rad/s": 1.0, "Hz": 2 * np.pi, "rpm": np.pi / 30}


class Modes:
    """Natural modes about an equilibrium.

    frequencies: those in the reference frame, in `unit`: rad/s, or what the setting `frequency` asks for; growth: 1/s;
    summary: everything else.
    """

    def __init__(self, summary, unit="rad/s"):
        self.summary = summary
        self.unit = unit
        self.notes = summary.get("notes", [])
        modes = summary["modes"]
        self.frequencies = np.array([mode["im [rad/s]"] for mode in modes]) / _PER_SECOND[unit]
        self.growth = np.array([mode["re [1/s]"] for mode in modes])
        ratios = [mode["damping_ratio"] for mode in modes]
        self.damping_ratios = np.array([np.nan if ratio is None else ratio for ratio in ratios])

    def __len__(self):
        return len(self.frequencies)

    def to_pandas(self):
        """A table with a row for each mode."""
        import pandas

        columns = {
            f"frequency [{self.unit}]": self.frequencies,
            "growth [1/s]": self.growth,
            "damping_ratio [1]": self.damping_ratios,
        }
        return pandas.DataFrame(columns, index=pandas.RangeIndex(1, len(self) + 1, name="mode"))

    def __repr__(self):
        shown = ", ".join(f"{value:.6g}" for value in self.frequencies[:6])
        more = ", .." if len(self) > 6 else ""
        return f"<{len(self)} modes of {self.summary['model']}: {shown}{more} {self.unit}>"


class _Table:
    """Rows of outputs; `result["tip.x"]` is a column, `result["tip"]` all components of a vector."""

    def __init__(self, summary, names, units, keys, values):
        self.summary = summary
        self.notes = summary.get("notes", [])
        self.key_name, self.columns = names[0], names[1:]
        self.units = dict(zip(names, units))
        self.key = np.frombuffer(keys).copy()
        self.values = np.frombuffer(values).reshape(len(self.key), len(self.columns)).copy()

    def __getitem__(self, name):
        if name == self.key_name:
            return self.key
        if name in self.columns:
            return self.values[:, self.columns.index(name)]
        parts = [index for index, column in enumerate(self.columns) if column.startswith(f"{name}.")]
        if parts:
            return self.values[:, parts]
        known = [self.key_name, *{column.rsplit(".", 1)[0]: None for column in self.columns}, *self.columns]
        raise KeyError(_unknown("output", name, known))

    def __len__(self):
        return len(self.key)

    def keys(self):
        """Names of all columns."""
        return [self.key_name, *self.columns]

    def to_pandas(self):
        """A table whose columns carry their units: `tip.x [m]`."""
        import pandas

        head = [f"{name} [{self.units[name]}]" for name in self.keys()]
        index = pandas.Index(self.key, name=head[0])
        return pandas.DataFrame(self.values, index=index, columns=head[1:])

    def to_xarray(self):
        """A dataset; every variable has its unit as an attribute."""
        import xarray

        variables = {
            name: (self.key_name, self.values[:, index], {"units": self.units[name]})
            for index, name in enumerate(self.columns)
        }
        coordinate = {self.key_name: (self.key_name, self.key, {"units": self.units[self.key_name]})}
        scalars = {key: value for key, value in self.summary.items() if isinstance(value, (str, int, float))}
        return xarray.Dataset(variables, coordinate, scalars)

    def save(self, path):
        """Writes an .npz: every column by its name, `units` and `summary` as JSON."""
        texts = {"units": np.array(json.dumps(self.units)), "summary": np.array(json.dumps(self.summary))}
        np.savez_compressed(path, **{name: self[name] for name in self.keys()}, **texts)

    def __repr__(self):
        return f"<{type(self).__name__} of {self.summary['model']}: {len(self)} rows of {', '.join(self.keys())}>"


class Run(_Table):
    """A run in time; `t` are the times of its rows, s."""

    @property
    def t(self):
        return self.key


class Equilibria(_Table):
    """Equilibria along a way; `key` is what grows along it."""

    @property
    def critical_values(self):
        """Where the way buckles or snaps, in the unit of `key`."""
        head = f"{self.key_name} [{self.units[self.key_name]}]"
        return np.array([entry[head] for entry in self.summary.get("critical_values", [])])


class Sweep:
    """One row for each point of a sweep: `sweep["speed [rpm]"]`, `sweep["tip.x max [m]"]`."""

    def __init__(self, folder):
        self.folder = folder
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        self.notes = self.summary.get("notes", [])
        with open(os.path.join(folder, "sweep.csv"), newline="", encoding="utf-8") as file:
            head, *rows = list(csv.reader(file))
        self.columns = head
        self._texts = {name: [row[index] for row in rows] for index, name in enumerate(head)}

    def __getitem__(self, name):
        if name not in self._texts:
            raise KeyError(_unknown("column", name, self.columns))
        texts = self._texts[name]
        if name in ("failed", "notes"):
            return texts
        if name == "point":
            return np.array(texts, dtype=int)
        try:
            return np.array([float(text) if text else np.nan for text in texts])
        except ValueError:  # of a param that names files their paths
            return texts

    def __len__(self):
        return len(self._texts["point"])

    def keys(self):
        return self.columns

    def to_pandas(self):
        import pandas

        return pandas.DataFrame({name: self[name] for name in self.columns}).set_index("point")

    def __repr__(self):
        return f"<Sweep of {self.summary['model']}: {len(self)} points, {', '.join(self.columns)}>"


def _unknown(what, name, known):
    near = difflib.get_close_matches(str(name), known, n=1)
    if near:
        return f"there is no {what} `{name}`; did you mean `{near[0]}`?"
    return f"there is no {what} `{name}`; there are {', '.join(known)}"


def _si(dimension):
    """The SI unit of exponents of m, kg, s, K, A and angle."""
    parts = [f"{base}^{power}" for base, power in zip(_BASES, dimension) if power]
    return "*".join(parts)


def _number(value):
    """A number as text that reads back to the same bits, or None."""
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)):
        return None
    return str(int(value)) if isinstance(value, (int, np.integer)) else repr(float(value))


class _Progress:
    """A bar of tqdm where it is installed, a line on standard error otherwise."""

    def __init__(self, wanted):
        self.call, self.bar, self.is_shown = None, None, False
        if callable(wanted):
            self.call = wanted
        elif wanted:
            try:
                from tqdm.auto import tqdm
            except ImportError:
                self.call, self.is_shown = self._line, True
            else:
                self.bar = tqdm(total=100.0, unit="%", bar_format="{l_bar}{bar}| [{elapsed}<{remaining}]")
                self.call = self._move

    def _line(self, share, at):
        sys.stderr.write(f"\r{100 * share:5.1f} %  at {at:.6g} ")
        sys.stderr.flush()

    def _move(self, share, at):
        self.bar.update(100.0 * share - self.bar.n)

    def end(self):
        if self.bar is not None:
            self.bar.update(100.0 - self.bar.n)
            self.bar.close()
        elif self.is_shown:
            sys.stderr.write("\n")


class _Model:
    """Base of the models' classes; params are keyword arguments and attributes, texts with a unit or numbers in SI."""

    _core = None
    _described = None

    def __init__(self, **params):
        object.__setattr__(self, "_given", {})
        for name, value in params.items():
            if name not in self._params():
                raise TypeError(_unknown("param", name, list(self._params())))
            setattr(self, name, value)

    @classmethod
    def _params(cls):
        return {param["name"]: param for param in cls._described["params"]}

    @classmethod
    def _word(cls, name, value):
        """`name=value` as the command line reads it."""
        if name not in cls._params():
            raise TypeError(_unknown("param", name, list(cls._params())))
        if isinstance(value, str):
            return f"{name}={value}"
        if isinstance(value, (list, tuple, np.ndarray)):
            return f"{name}=" + ",".join(cls._word(name, one).split("=", 1)[1] for one in value)
        param, number = cls._params()[name], _number(value)
        if param["is_file"]:
            if not hasattr(value, "__fspath__"):
                raise TypeError(f"`{name}` is the path of a file with a table")
            return f"{name}={os.fspath(value)}"
        if number is None:
            raise TypeError(f"`{name}` is a text with its unit, as in '4 {param['unit']}', or a number in SI")
        if param["is_count"]:
            return f"{name}={int(value) if float(value).is_integer() else value}"
        return f"{name}={number} {_si(param['dimension'])}".rstrip()

    def __setattr__(self, name, value):
        if name not in self._params():
            raise AttributeError(_unknown("param", name, list(self._params())))
        if isinstance(value, (list, tuple, np.ndarray)):
            raise TypeError(f"`{name}` takes one value; sweep({name}=[..]) takes several")
        word = self._word(name, value)
        self._core.values(["run", word])
        self._given[name] = word

    def __getattr__(self, name):
        names = list(self._params())
        if name in names:
            return self._values()[name]
        raise AttributeError(_unknown("param or method", name, [*names, "run", "steady", "static", "modes", "sweep"]))

    def _values(self):
        """Names and values of the params: SI, whole numbers for counts, paths for files."""
        words = ["run", *self._given.values()]
        values, texts = self._core.values(words), self._core.texts(words)
        return {
            name: text if param["is_file"] else int(value) if param["is_count"] else value
            for (name, param), value, text in zip(self._params().items(), values, texts)
        }

    def __dir__(self):
        return [*super().__dir__(), *self._params()]

    def __repr__(self):
        values = self._values().items()
        shown = [f"{name}={value!r}" if isinstance(value, str) else f"{name}={value:.6g}" for name, value in values]
        return f"{type(self).__name__}({', '.join(shown)})"

    @property
    def params(self):
        """Names, units and meanings of the params, with the values in SI."""
        values = self._values()
        return {
            name: {"value": values[name], "unit": param["unit"], "doc": param["doc"]}
            for name, param in self._params().items()
        }

    @property
    def source(self):
        """The text of the model."""
        return self._described["source"]

    def _words(self, command, settings, params=None):
        given = dict(self._given)
        given.update({name: self._word(name, value) for name, value in (params or {}).items()})
        words = [command, *given.values()]
        for name, value in settings.items():
            flag = name.replace("_", "-")
            if flag != "out" and flag not in self._described["settings"]:
                known = [one.replace("-", "_") for one in self._described["settings"]]
                raise TypeError(_unknown("setting", name, known))
            if value is None or value is False:
                continue
            if value is True:
                words.append(f"--{flag}")
                continue
            if isinstance(value, (list, tuple)):
                value = ",".join(str(one) for one in value)
            number = _number(value)
            text = str(value) if number is None else number
            if number is not None and flag in _UNITS:
                text = f"{number} {_UNITS[flag]}"
            words.append(f"--{flag}={text}")
        return words

    def _found(self, kind, call, command, settings, over, progress):
        bar = _Progress(progress)
        params = dict([over.split("=", 1)]) if isinstance(over, str) else over
        try:
            summary, *table = call(self._words(command, settings, params), bar.call)
        finally:
            bar.end()
        result = kind(json.loads(summary), *table)
        if not result.summary["completed"]:
            raise Incomplete(result.summary["reason"], result)
        return self._told(result)

    def _told(self, result):
        """The result, after its notes; those of the model are the same for all results."""
        for note in result.notes[self._notes :]:
            warnings.warn(note, stacklevel=3)
        return result

    def run(self, *, progress=False, **settings):
        """Integrates in time. Settings are those of the command line: rtol, integrator, t_end, every, step, ..

        `progress`: True, or a function of the share that is done and the time.
        """
        return self._found(Run, self._core.run, "run", settings, None, progress)

    def steady(self, *, over=None, progress=False, **settings):
        """Relative equilibria, the spin growing from rest, or along a param: over="speed=0..100 rad/s"."""
        return self._found(Equilibria, self._core.equilibria, "steady", settings, over, progress)

    def static(self, *, over=None, progress=False, **settings):
        """Equilibria at rest, the loads growing from nothing, or along a param: over="load=0..5 N"."""
        return self._found(Equilibria, self._core.equilibria, "static", settings, over, progress)

    def modes(self, count=None, **settings):
        """Natural modes about the relative equilibrium, the lowest `count`."""
        words = self._words("modes", {"modes": count, **settings})
        unit = settings.get("frequency", "rad/s")
        return self._told(Modes(json.loads(self._core.modes(words)), unit))

    def sweep(self, *, of="run", out=None, settings=None, **varied):
        """Many calculations: lists, "1..5 N in 9", "normal(5, 0.1) N" for params; settings={"samples": 100, "rtol": 1e-7}.

        `out`: folder of the points, which are kept there and not computed again; a temporary one without it.
        """
        with tempfile.TemporaryDirectory() as temporary:
            folder = os.fspath(out or temporary)
            words = self._words("sweep", {"of": of, "out": folder, **(settings or {})}, varied)
            self._core.command(words)
            result = Sweep(folder)
        return self._told(result)


def model_class(core, module):
    """The class of a model."""
    described = json.loads(core.describe())
    doc = [described["doc"], "", "Params (texts with a unit, or numbers in SI):"]
    for param in described["params"]:
        unit = "path of a file" if param["is_file"] else param["unit"]
        doc.append(f"    {param['name']} [{unit}]: {param['doc']}")
    doc += ["", "Outputs:"]
    doc += [f"    {output['name']} [{output['unit']}]: {output['doc']}" for output in described["outputs"]]
    fields = {"_core": core, "_described": described, "_notes": described["notes"], "__doc__": "\n".join(doc)}
    return type(described["name"], (_Model,), {**fields, "__module__": str(module)})


def stubs(module):
    """The text of the module's .pyi file, for editors and type checkers."""
    models = [value for value in vars(module).values() if isinstance(value, type) and issubclass(value, _Model)]
    has_files = any(param["is_file"] for model in models for param in model._params().values())
    lines = ["from os import PathLike"] if has_files else []
    lines += ["from typing import Any, Callable", "", "import numpy as np", ""]
    lines += ["Progress = bool | Callable[[float, float], Any]", ""]
    shown = {
        "Incomplete(RuntimeError)": ["result: Any"],
        "Modes": [
            "frequencies: np.ndarray",
            "unit: str",
            "growth: np.ndarray",
            "damping_ratios: np.ndarray",
            "summary: dict[str, Any]",
            "notes: list[str]",
            "def __len__(self) -> int: ...",
            "def to_pandas(self) -> Any: ...",
        ],
        "_Table": [
            "key: np.ndarray",
            "values: np.ndarray",
            "columns: list[str]",
            "units: dict[str, str]",
            "summary: dict[str, Any]",
            "notes: list[str]",
            "def __getitem__(self, name: str) -> np.ndarray: ...",
            "def __len__(self) -> int: ...",
            "def keys(self) -> list[str]: ...",
            "def to_pandas(self) -> Any: ...",
            "def to_xarray(self) -> Any: ...",
            "def save(self, path: str) -> None: ...",
        ],
        "Run(_Table)": ["t: np.ndarray"],
        "Equilibria(_Table)": ["critical_values: np.ndarray"],
        "Sweep": [
            "columns: list[str]",
            "summary: dict[str, Any]",
            "notes: list[str]",
            "def __getitem__(self, name: str) -> Any: ...",
            "def __len__(self) -> int: ...",
            "def keys(self) -> list[str]: ...",
            "def to_pandas(self) -> Any: ...",
        ],
    }
    for name, body in shown.items():
        lines += [f"class {name}:", *(f"    {line}" for line in body), ""]
    for name, value in vars(module).items():
        if isinstance(value, type) and issubclass(value, _Model):
            kinds = value._params().items()
            params = {name: "str" if one["is_file"] else "int" if one["is_count"] else "float" for name, one in kinds}
            params = {param: kind for param, kind in params.items() if not keyword.iskeyword(param)}
            lines.append(f"class {name}:")
            wider = {"str": "str | PathLike[str]", "int": "int | str", "float": "float | str"}
            for param, kind in params.items():
                # More can be set than is read: texts with units.
                lines += ["    @property", f"    def {param}(self) -> {kind}: ..."]
                lines += [f"    @{param}.setter", f"    def {param}(self, value: {wider[kind]}) -> None: ..."]
            lines += ["    @property", "    def params(self) -> dict[str, dict[str, Any]]: ..."]
            lines += ["    @property", "    def source(self) -> str: ..."]
            given = "".join(f", {param}: {wider[kind]} = ..." for param, kind in params.items())
            star = ", *" if params else ""
            lines.append(f"    def __init__(self{star}{given}) -> None: ...")
            lines.append("    def run(self, *, progress: Progress = ..., **settings: Any) -> Run: ...")
            for kind in ("steady", "static"):
                over = "over: str | None = ..., progress: Progress = ..., **settings: Any"
                lines.append(f"    def {kind}(self, *, {over}) -> Equilibria: ...")
            lines.append("    def modes(self, count: int | None = ..., **settings: Any) -> Modes: ...")
            lines.append(
                "    def sweep(self, *, of: str = ..., out: str | None = ..., "
                "settings: dict[str, Any] | None = ..., **varied: Any) -> Sweep: ..."
            )
            lines.append("")
    lines.append("def stubs(module: Any) -> str: ...")
    return "\n".join(lines) + "\n"
