//! Where a particle will be: what is fixed in a frame moves on a screw for a while, whose turns a step need not follow.

use super::interval::Interval;

/// The way of a particle, evenly along and about an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// When it is known, s.
    pub from: f64,
    /// Middle of its turns then, m.
    pub middle: [f64; 3],
    /// Velocity of the middle, m/s.
    pub velocity: [f64; 3],
    /// Way from the middle then, m.
    pub arm: [f64; 3],
    /// The same a quarter of a turn later, m.
    pub quarter: [f64; 3],
    /// rad/s
    pub spin: f64,
}

impl Path {
    /// Bounds of a component over a span of time, s.
    pub(super) fn bounds(&self, component: usize, span: Interval) -> Interval {
        let since = span.subtract(Interval::point(self.from));
        let [middle, velocity, arm, quarter] =
            [&self.middle, &self.velocity, &self.arm, &self.quarter].map(|of| Interval::point(of[component]));
        let moved = middle.add(velocity.multiply(since));
        let (arm, quarter) = (arm.low, quarter.low);
        let phase = Interval::point(quarter.atan2(arm));
        let turned = Interval::point(self.spin).multiply(since).subtract(phase).cos();
        moved.add(Interval::point(arm.hypot(quarter)).multiply(turned))
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
            arm: [0.7, 0.4, 0.0],
            quarter: [-0.4, 0.7, 0.0],
            spin: 9.0,
        };
        let at = |t: f64, k: usize| {
            let (turn, since) = (path.spin * (t - path.from), t - path.from);
            path.middle[k] + path.velocity[k] * since + path.arm[k] * turn.cos() + path.quarter[k] * turn.sin()
        };
        for (low, width) in [(2.0, 0.01), (2.3, 0.2), (1.9, 3.0)] {
            for component in 0..3 {
                let bounds = path.bounds(component, Interval::new(low, low + width));
                let values = (0..=1000).map(|number| at(low + width * f64::from(number) / 1000.0, component));
                let seen = values.map(Interval::point).reduce(Interval::hull).unwrap();
                let close = bounds.wider(1e-12);
                assert!(close.contains(seen), "{component}: {bounds:?} {seen:?}");
                let drift = 2.0 * path.velocity[component].abs() * width + 1e-4;
                assert!(
                    bounds.width() <= seen.width() + drift,
                    "{component}: {bounds:?} {seen:?}"
                );
            }
        }
    }
}
