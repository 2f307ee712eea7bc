//! Axes that are stretched as no material is: a load is far too large, or a stiffness far too small. The law of the
//! material goes on, and a run alone does not tell. And sections that a stretch has made smaller.

use crate::emitted::Interpolant;
use crate::model::Warning;
use crate::scene::MeshScene;
use crate::scene::bodies::place::weighted;
use crate::space::Vector;

/// Stretch that no material bears: natural rubber breaks at 8 or 9.
pub(super) const MOST: f64 = 10.0;
/// Part by which a section shrinks from which on it is told that stresses do not see it, and the stretch up to which no section shrinks so much.
const SHRUNK: f64 = 0.02;
pub(super) const UNSHRUNK: f64 = 1.01;
/// Middle and ends of an element.
const PLACES: [f64; 3] = [0.0, 0.5, 1.0];

impl MeshScene {
    /// Those of some bodies whose axes are stretched too far at the loaded state, or so far that their sections have shrunk: stresses are forces
    /// over undeformed ones.
    pub(crate) fn overstretched(&self, bodies: &[usize]) -> Vec<Warning> {
        let found = bodies.iter().filter_map(|&body| {
            let (stretch, x) = self.most_stretched(body);
            let label = self.bodies[body].spec.label();
            if stretch > MOST {
                return Some(Warning {
                    text: format!(
                        "body `{label}`: its axis is stretched to {stretch:.0} times its length at x = {x:.4} m, as no material is: look for a load that is far too large, or an `area` or `young` that is far too small"
                    ),
                    weight: stretch,
                });
            }
            let smallest = (stretch > UNSHRUNK).then(|| self.smallest_section(body))??;
            let part = 1.0 / smallest - 1.0;
            (part > SHRUNK).then(|| Warning {
                text: format!(
                    "body `{label}`: its section is smaller than the undeformed one, over which stresses are told: those in the material (Cauchy's) are larger by up to {:.0} %",
                    100.0 * part
                ),
                weight: part,
            })
        });
        found.collect()
    }

    /// The largest stretch of a body's axis, and the arclength (m) where it is.
    fn most_stretched(&self, body: usize) -> (f64, f64) {
        let (spec, connectivity) = (&self.bodies[body].spec, &self.bodies[body].connectivity);
        let mut slope = vec![0.0; spec.nodal.len()];
        let mut most = (0.0, 0.0);
        for xi in PLACES {
            for element in 0..spec.count {
                if element == 0 || !spec.stations.is_empty() {
                    self.parts
                        .shapes(body, element, Interpolant::Position, 1, xi, &mut slope);
                }
                let components = connectivity.element(element);
                let stretch = Vector::from(weighted(&self.buffers.q, components, spec.dimension(), &slope)).norm();
                if stretch > most.0 {
                    most = (stretch, spec.arclength(element, xi));
                }
            }
        }
        most
    }

    /// The smallest area of a section along a body, as a part of the undeformed one, in a plane with the same strain across it; `None` of a
    /// body without sections.
    fn smallest_section(&self, body: usize) -> Option<f64> {
        let (spec, connectivity) = (&self.bodies[body].spec, &self.bodies[body].connectivity);
        let mut shape = vec![0.0; spec.nodal.len()];
        let mut smallest = f64::INFINITY;
        for element in 0..spec.count {
            for xi in PLACES {
                let components = connectivity.element(element);
                let mut axis = |of: Interpolant| {
                    spec.interpolates(of).then(|| {
                        self.parts.shapes(body, element, of, 0, xi, &mut shape);
                        Vector::from(weighted(&self.buffers.q, components, spec.dimension(), &shape))
                    })
                };
                let y = axis(Interpolant::SectionY)?;
                let area = match axis(Interpolant::SectionZ) {
                    Some(z) => y.cross(&z).norm(),
                    None => y.norm_squared(),
                };
                smallest = smallest.min(area);
            }
        }
        Some(smallest)
    }
}
