//! Loads per length as pictures show them: an arrow in the middle of an element.

use crate::scene::MeshScene;
use crate::scene::pieces::push::Law;
use crate::space::{Vector, three};

/// A load per length on one element.
#[derive(Clone, Copy)]
pub(crate) struct Line<'s> {
    pub name: &'s str,
    from: Source,
    pub body: usize,
    pub element: usize,
}

/// Where a load per length comes from.
#[derive(Clone, Copy)]
enum Source {
    /// The density with this index.
    Density(usize),
    /// Of the distributed loads that with this index, at points of the element.
    Points(usize),
}

/// Most arrows of a load per length; of more elements every second, third, .. has one.
const MOST_ARROWS: usize = 48;

impl MeshScene {
    /// Loads per length, element by element, as many of each as a picture shows.
    pub(crate) fn lines(&self) -> Vec<Line<'_>> {
        let densities = self.distributed.all.iter().enumerate().flat_map(|(index, density)| {
            let line = move |element| Line {
                name: density.spec.name,
                from: Source::Density(index),
                body: density.spec.body,
                element,
            };
            (0..self.bodies[density.spec.body].spec.count).map(line)
        });
        let points = self.links.spread.iter().flat_map(|spread| {
            let mut lines: Vec<(usize, Line<'_>)> = Vec::new();
            for force in &self.links.forces[spread.forces.clone()] {
                if let Law::Distributed { load, .. } = force.law
                    && lines.iter().all(|&(other, _)| other != load)
                {
                    let line = Line {
                        name: force.name,
                        from: Source::Points(load),
                        body: spread.body,
                        element: spread.element,
                    };
                    lines.push((load, line));
                }
            }
            lines.into_iter().map(|(_, line)| line)
        });
        let all: Vec<Line<'_>> = densities.chain(points).collect();
        let mut names: Vec<&str> = all.iter().map(|line| line.name).collect();
        names.sort_unstable();
        names.dedup();
        let of_name = |name| {
            let own: Vec<Line<'_>> = all.iter().filter(|line| line.name == name).copied().collect();
            let every = own.len().div_ceil(MOST_ARROWS).max(1);
            own.into_iter().step_by(every)
        };
        names.into_iter().flat_map(of_name).collect()
    }

    /// A load per length at the loaded state, N/m, inertial axes; `values` are those of all densities.
    pub(crate) fn per_length(&self, line: Line<'_>, t: f64, values: &[Vec<f64>]) -> Vector {
        let body = &self.bodies[line.body];
        let [from, to] = [0.0, 1.0].map(|xi| body.spec.arclength(line.element, xi));
        let total: Vector = match line.from {
            Source::Density(index) => {
                let force = self.density_on(index, line.element, &values[index]);
                let vectors = force.chunks_exact(body.spec.dimension()).zip(body.spec.nodal);
                let on_positions = vectors.filter(|(_, nodal)| nodal.is_position());
                let mut sum = Vector::zeros();
                for (vector, _) in on_positions {
                    for (&axis, value) in body.spec.axes.iter().zip(vector) {
                        sum[axis] += value;
                    }
                }
                self.buffers.frames[body.frame].direction_to_inertial(sum)
            }
            Source::Points(load) => {
                let spread = self.spread_over(line.body, line.element);
                let pushes = spread.flat_map(|spread| spread.forces.clone());
                let own = pushes.filter(
                    |&index| matches!(self.links.forces[index].law, Law::Distributed { load: of, .. } if of == load),
                );
                own.map(|index| {
                    let forces = self.pushed(index, t);
                    let markers = self.links.forces[index].markers.iter().enumerate();
                    let points = markers.filter(|&(_, &marker)| self.links.markers[marker].is_point());
                    points.map(|(at, _)| three(&forces, 3 * at)).sum::<Vector>()
                })
                .sum()
            }
        };
        total / (to - from)
    }
}
