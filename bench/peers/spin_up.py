"""The spin-up (Ren & Yang 2021, section 4.1.1), and what a run of any of the codes gives. SI units throughout."""

from dataclasses import dataclass

import numpy as np

LENGTH = 8.0
MASS_PER_LENGTH = 2766.67 * 0.7299e-4
AXIAL_STIFFNESS = 68.95e9 * 0.7299e-4
BENDING_STIFFNESS = 68.95e9 * 0.8215e-8
RAMP = 15.0
"""Time over which the hub reaches its speed, and the end of all runs (s)."""
EVERY = 0.05
"""Time between rows (s)."""
ROWS = np.linspace(0.0, RAMP, round(RAMP / EVERY) + 1)


class Failed(Exception):
    """A run that a code gave up; the message is its own."""


@dataclass
class Run:
    """One run over `ROWS`: tip in the axes of the hub (m), processor time of the integration (s), and counts."""

    u: np.ndarray
    v: np.ndarray
    cpu: float
    steps: int
    counts: str
    share_at_ceiling: float = 0.0


def hub_angle(speed: float, t, m=np):
    """Angle of the hub, Eq. (22) up to `RAMP`; `m` gives sine and cosine."""
    slow = RAMP / (2 * np.pi)
    return speed / RAMP * (t * t / 2 + slow * slow * (m.cos(t / slow) - 1))


def hub_rate(speed: float, t, m=np):
    """First derivative of `hub_angle`."""
    slow = RAMP / (2 * np.pi)
    return speed / RAMP * (t - slow * m.sin(t / slow))


def hub_acceleration(speed: float, t, m=np):
    """Second derivative of `hub_angle`."""
    return speed / RAMP * (1 - m.cos(2 * np.pi * t / RAMP))
