//! Where a particle will be: what is fixed in a frame moves on a screw for a while, whose turns a step need not follow.

use super::interval::Interval;

/// The way of a particle along and about an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// When it is known, s.
    pub from: f64,
    /// Middle of its turns then, m.
    pub middle: [f64; 3],
    /// Velocity of the middle, m/s.
    pub velocity: [f64; 3],
    /// Its acceleration, m/s^2.
    pub acceleration: [f64; 3],
    /// Way from the middle then, m.
    pub arm: [f64; 3],
    /// The same a quarter of a turn later, m.
    pub quarter: [f64; 3],
    /// rad/s
    pub spin: f64,
    /// rad/s^2
    pub spin_rate: f64,
}

impl Path {
    /// With the accelerations that lead to it from the way as it was known before, or those of that where no time has passed.
    pub(crate) fn after(self, before: &Self) -> Self {
        let since = self.from - before.from;
        if since <= 0.0 {
            return Self {
                acceleration: before.acceleration,
                spin_rate: before.spin_rate,
                ..self
            };
        }
        let acceleration = std::array::from_fn(|axis| (self.velocity[axis] - before.velocity[axis]) / since);
        let spin_rate = (self.spin - before.spin) / since;
        Self {
            acceleration,
            spin_rate,
            ..self
        }
    }

    /// Bounds of a component over a span of time, s.
    pub(super) fn bounds(&self, component: usize, span: Interval) -> Interval {
        let since = span.subtract(Interval::point(self.from));
        let middle = Interval::point(self.middle[component]);
        let rate = Interval::point(self.velocity[component]);
        let bend = Interval::point(0.5 * self.acceleration[component]);
        let moved = middle.add(since.multiply(rate.add(bend.multiply(since))));
        let (arm, quarter) = (self.arm[component], self.quarter[component]);
        let turned = self.turn(since, quarter.atan2(arm)).cos();
        moved.add(Interval::point(arm.hypot(quarter)).multiply(turned))
    }

    /// Bounds of the rate of a component over a span of time, s.
    pub(super) fn rates(&self, component: usize, span: Interval) -> Interval {
        let since = span.subtract(Interval::point(self.from));
        let even = Interval::point(self.velocity[component]);
        let even = even.add(Interval::point(self.acceleration[component]).multiply(since));
        let (arm, quarter) = (self.arm[component], self.quarter[component]);
        let turned = self.turn(since, quarter.atan2(arm)).sin().negate();
        let spin = Interval::point(self.spin).add(Interval::point(self.spin_rate).multiply(since));
        even.add(Interval::point(arm.hypot(quarter)).multiply(turned).multiply(spin))
    }

    /// Bounds of the second derivative of a component over a span of time, s.
    pub(super) fn accelerations(&self, component: usize, span: Interval) -> Interval {
        let since = span.subtract(Interval::point(self.from));
        let (arm, quarter) = (self.arm[component], self.quarter[component]);
        let turn = self.turn(since, quarter.atan2(arm));
        let spin = Interval::point(self.spin).add(Interval::point(self.spin_rate).multiply(since));
        let inward = spin.power(2).multiply(turn.cos());
        let along = Interval::point(self.spin_rate).multiply(turn.sin());
        let turned = Interval::point(arm.hypot(quarter)).multiply(inward.add(along).negate());
        Interval::point(self.acceleration[component]).add(turned)
    }

    /// Bounds of the turn since then, less a phase, rad.
    fn turn(&self, since: Interval, phase: f64) -> Interval {
        let bend = Interval::point(0.5 * self.spin_rate).multiply(since);
        let turn = since.multiply(Interval::point(self.spin).add(bend));
        turn.subtract(Interval::point(phase))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_particle_on_a_screw_is_within_its_bounds_and_they_are_close() {
        let path = Path {
            from: 2.0,
            middle: [1.0, -3.0, 0.5],
            velocity: [0.2, 0.0, -0.1],
            acceleration: [0.03, -0.02, 0.0],
            arm: [0.7, 0.4, 0.0],
            quarter: [-0.4, 0.7, 0.0],
            spin: 9.0,
            spin_rate: 0.4,
        };
        let at = |t: f64, k: usize| {
            let since = t - path.from;
            let turn = since * (path.spin + 0.5 * path.spin_rate * since);
            path.middle[k]
                + since * (path.velocity[k] + 0.5 * path.acceleration[k] * since)
                + path.arm[k] * turn.cos()
                + path.quarter[k] * turn.sin()
        };
        for (low, width) in [(2.0, 0.01), (2.3, 0.2), (1.9, 3.0)] {
            for component in 0..3 {
                let bounds = path.bounds(component, Interval::new(low, low + width));
                let values = (0..=1000).map(|number| at(low + width * f64::from(number) / 1000.0, component));
                let seen = values.map(Interval::point).reduce(Interval::hull).unwrap();
                let close = bounds.wider(1e-12);
                assert!(close.contains(seen), "{component}: {bounds:?} {seen:?}");
                let rates = (0..=1000).map(|number| {
                    let t = low + width * f64::from(number) / 1000.0;
                    (at(t + 1e-6, component) - at(t - 1e-6, component)) / 2e-6
                });
                let rates = rates.map(Interval::point).reduce(Interval::hull).unwrap();
                let close = path.rates(component, Interval::new(low, low + width)).wider(1e-6);
                assert!(close.contains(rates), "{component}: {close:?} {rates:?}");
                let drift = 2.0 * path.velocity[component].abs() * width + 0.1 * width * width + 1e-4;
                assert!(
                    bounds.width() <= seen.width() + drift,
                    "{component}: {bounds:?} {seen:?}"
                );
            }
        }
    }
}
