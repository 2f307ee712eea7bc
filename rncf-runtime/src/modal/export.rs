//! Bodies in modes as arrays, which a file takes elsewhere: nodes, modes, and the invariants of inertia.

use super::body::ModalBody;
use super::expansion::Elastic;
use super::scene::ModalScene;
use crate::emitted::{BodySpec, Interpolant};
use crate::model::ExportedBody;
use crate::space::{Matrix, Vector, rows};

/// Of every node its position, its displacement and the rates of its axes, of the undeformed body and of each mode.
struct NodeVectors {
    position: Vector,
    /// The slope, and the section's axes where there are.
    axes: [Option<Vector>; 3],
}

fn nodes(spec: &BodySpec, vectors: &[Vector]) -> Vec<NodeVectors> {
    let count = spec.count + 1;
    let find = |node: usize, of: Interpolant, order: usize| {
        let is_it = |vector: &usize| {
            let place = vector % spec.stride;
            let own = vector / spec.stride == node && place < spec.vectors_per_node;
            let (_, local) = spec.locate(*vector);
            own && (spec.nodal[local].of, spec.nodal[local].order) == (of, order)
        };
        (0..spec.meshed_vectors()).find(is_it).map(|vector| vectors[vector])
    };
    let node = |node: usize| NodeVectors {
        position: find(node, Interpolant::Position, 0).unwrap_or_default(),
        axes: [
            find(node, Interpolant::Position, 1),
            find(node, Interpolant::SectionY, 0),
            find(node, Interpolant::SectionZ, 0),
        ],
    };
    (0..count).map(node).collect()
}

/// The rotation of a node: of a section the polar one of its axes, which the slope does not turn, for it shears; of a centre line
/// that of its slope.
fn rotation(axes: &[Option<Vector>; 3], rates: &[Option<Vector>; 3]) -> Vector {
    let pairs = axes.iter().zip(rates).map(|(axis, rate)| Some(((*axis)?, (*rate)?)));
    let [slope, section @ ..] = &pairs.collect::<Vec<_>>()[..] else {
        return Vector::zeros();
    };
    let section: Vec<(Vector, Vector)> = section.iter().flatten().copied().collect();
    let turning = |pairs: &[(Vector, Vector)]| {
        pairs
            .iter()
            .fold(Vector::zeros(), |sum, pair| sum + pair.0.cross(&pair.1))
    };
    match section[..] {
        [] => turning(&slope.iter().copied().collect::<Vec<_>>()),
        [(y, _), (z, _)] => {
            // Both axes see the turning about their normal.
            let (sum, normal) = (turning(&section), y.cross(&z));
            sum - 0.5 * normal.dot(&sum) * normal
        }
        _ => turning(&section),
    }
}

impl ModalScene {
    /// Bodies in modes, with arrays as `import` reads them.
    pub(super) fn exported_bodies(&self) -> Vec<ExportedBody> {
        let bodies = self.bodies.iter().zip(&self.modes);
        let ours = bodies.filter(|(_, modes)| modes.elsewhere.is_none() && modes.modes() > 0);
        ours.map(|(&body, modes)| exported(&self.scene.bodies[body].spec, modes))
            .collect()
    }
}

fn exported(spec: &BodySpec, body: &ModalBody) -> ExportedBody {
    let k = body.modes();
    // From the order of the body's axes to that of its frame; planar sums lie in the first two and about the third.
    let places: [usize; 3] = match *spec.axes {
        [first, second] => [first, second, 3 - first - second],
        _ => [0, 1, 2],
    };
    let turned = |vector: Vector| -> Vector {
        let mut own = Vector::zeros();
        places
            .iter()
            .zip(&vector)
            .for_each(|(&place, value)| own[place] = *value);
        own
    };
    let vectors = |values: &mut dyn Iterator<Item = f64>| -> Vec<Vector> {
        body.nodal.vectors(values).into_iter().map(turned).collect()
    };
    let rest = nodes(spec, &vectors(&mut body.nodal.shape.iter().copied()));
    let modes: Vec<Vec<NodeVectors>> = (0..k)
        .map(|mode| nodes(spec, &vectors(&mut body.modes.iter().skip(mode).step_by(k).copied())))
        .collect();
    let count = rest.len();
    let (mut shapes, mut axes) = (vec![0.0; 6 * count * k], vec![0.0; 9 * count * k]);
    for (mode, own) in modes.iter().enumerate() {
        for (node, (own, rest)) in own.iter().zip(&rest).enumerate() {
            let turn = rotation(&rest.axes, &own.axes);
            for component in 0..3 {
                shapes[(6 * node + component) * k + mode] = own.position[component];
                shapes[(6 * node + 3 + component) * k + mode] = turn[component];
            }
            for axis in 0..3 {
                let mut unit = Vector::zeros();
                unit[axis] = 1.0;
                // Axes of the frame, as those of the body carry them.
                let known = rest
                    .axes
                    .iter()
                    .zip(&own.axes)
                    .filter_map(|(at, rate)| Some((at.as_ref()?, rate.as_ref()?)));
                let known: Vec<(&Vector, &Vector)> = known.collect();
                let rate = match known.len() {
                    3 => known
                        .iter()
                        .fold(Vector::zeros(), |sum, (at, rate)| sum + (**at).dot(&unit) * **rate),
                    _ => turn.cross(&unit),
                };
                axes[(node * k + mode) * 9 + 3 * axis..][..3].copy_from_slice(rate.as_slice());
            }
        }
    }
    let (mut stiffness, mut damping) = (vec![0.0; k * k], vec![0.0; k * k]);
    for (mode, frequency) in body.frequencies.iter().enumerate() {
        stiffness[mode * (k + 1)] = frequency * frequency;
    }
    if let Elastic::Expanded { damping: Some(own), .. } = &body.elastic {
        damping.copy_from_slice(&own.constant);
    }
    let inertia = &body.invariants;
    let concat = |values: &[Vector]| -> Vec<f64> { values.iter().flatten().copied().collect() };
    let list = |values: &[Vector]| concat(&values.iter().copied().map(turned).collect::<Vec<_>>());
    let matrix = |matrix: &Matrix| -> Vec<f64> {
        let mut own = Matrix::zeros();
        for i in 0..3 {
            for j in 0..3 {
                own[(places[i], places[j])] = matrix[(i, j)];
            }
        }
        rows(&own).concat()
    };
    let matrices = |values: &[Matrix]| -> Vec<f64> { values.iter().flat_map(matrix).collect() };
    let positions: Vec<Vector> = rest.iter().map(|node| node.position).collect();
    let arrays = [
        ("nodes", vec![count, 3], concat(&positions)),
        ("node_ids", vec![count], (1..=count).map(|id| id as f64).collect()),
        ("modes", vec![6 * count, k], shapes),
        ("axes", vec![count, k, 9], axes),
        ("M_modal", vec![k, k], body.invariants.inner().to_vec()),
        ("K_modal", vec![k, k], stiffness),
        ("C_modal", vec![k, k], damping),
        ("mass", vec![1], vec![inertia.mass]),
        ("moment", vec![3], list(&[inertia.moment])),
        ("inertia", vec![3, 3], matrix(&inertia.inertia)),
        ("phibar", vec![k, 3], list(&inertia.phibar)),
        ("gamma", vec![k, 3], list(&inertia.gamma)),
        ("eta", vec![k, k, 3], list(&inertia.eta)),
        ("Gamma", vec![k, 3, 3], matrices(&inertia.first)),
        ("Upsilon", vec![k, k, 3, 3], matrices(&inertia.second)),
    ];
    ExportedBody {
        name: body.nodal.name.clone(),
        arrays: arrays.into(),
    }
}
