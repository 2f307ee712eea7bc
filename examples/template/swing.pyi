from typing import Any, Callable

import numpy as np

Progress = bool | Callable[[float, float], Any]

class Incomplete(RuntimeError):
    result: Any

class Modes:
    frequencies: np.ndarray
    growth: np.ndarray
    damping_ratios: np.ndarray
    summary: dict[str, Any]
    notes: list[str]
    def to_pandas(self) -> Any: ...

class _Table:
    key: np.ndarray
    values: np.ndarray
    columns: list[str]
    units: dict[str, str]
    summary: dict[str, Any]
    notes: list[str]
    def __getitem__(self, name: str) -> np.ndarray: ...
    def __len__(self) -> int: ...
    def keys(self) -> list[str]: ...
    def to_pandas(self) -> Any: ...
    def to_xarray(self) -> Any: ...
    def save(self, path: str) -> None: ...

class Run(_Table):
    t: np.ndarray

class Equilibria(_Table):
    critical_values: np.ndarray

class Sweep:
    columns: list[str]
    summary: dict[str, Any]
    notes: list[str]
    def __getitem__(self, name: str) -> Any: ...
    def __len__(self) -> int: ...
    def to_pandas(self) -> Any: ...

class Swing:
    length: float
    g: float
    elements: int
    def __init__(self, *, length: float | str = ..., g: float | str = ..., elements: int | str = ...) -> None: ...
    def run(self, *, progress: Progress = ..., **settings: Any) -> Run: ...
    def steady(self, *, over: str | None = ..., progress: Progress = ..., **settings: Any) -> Equilibria: ...
    def static(self, *, over: str | None = ..., progress: Progress = ..., **settings: Any) -> Equilibria: ...
    def modes(self, count: int | None = ..., **settings: Any) -> Modes: ...
    def sweep(self, *, of: str = ..., out: str | None = ..., settings: dict[str, Any] | None = ..., **varied: Any) -> Sweep: ...

def stubs(module: Any) -> str: ...
