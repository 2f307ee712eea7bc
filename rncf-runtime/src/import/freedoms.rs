//! Unknowns of an imported body: what is left of its degrees of freedom where interfaces are rigid and held; rigid motions.

use super::body::Imported;
use super::files::{FULL_NODE, Sparse};
use crate::space::Vector;

/// Displacements of all nodes.
pub(super) type Columns = Vec<Vec<f64>>;

/// Unknowns of a body with rigid interfaces, some of which are held.
pub(super) struct Freedoms {
    pub count: usize,
    /// Unknowns and factors that every degree of freedom depends on.
    map: Vec<Vec<(usize, f64)>>,
    /// The unknowns of every interface: displacement, rotation.
    pub interfaces: Vec<[Option<usize>; FULL_NODE]>,
}

impl Freedoms {
    pub fn new(body: &Imported, held: &[[bool; FULL_NODE]], stiffness: &Sparse, mass: &Sparse) -> Self {
        let (per_node, size) = (body.elements.per_node, body.elements.size());
        let mut freedoms = Self {
            count: 0,
            map: vec![Vec::new(); size],
            interfaces: Vec::new(),
        };
        let mut rigid = vec![false; size];
        for (interface, held) in body.interfaces.iter().zip(held) {
            let own: [Option<usize>; FULL_NODE] = std::array::from_fn(|component| {
                let [node] = interface.nodes[..] else {
                    return freedoms.next(!held[component]);
                };
                let row = node * per_node + component;
                let is_there = component < per_node && !(stiffness.rows[row].is_empty() && mass.rows[row].is_empty());
                freedoms.next(is_there && !held[component])
            });
            for &node in &interface.nodes {
                let arm = Vector::from(body.elements.nodes[node]) - interface.place;
                for component in 0..per_node {
                    let row = node * per_node + component;
                    rigid[row] = true;
                    let axis = component % 3;
                    let mut add = |of: usize, factor: f64| {
                        if let Some(unknown) = own[of].filter(|_| factor != 0.0) {
                            freedoms.map[row].push((unknown, factor));
                        }
                    };
                    add(component, 1.0);
                    if component < 3 && interface.nodes.len() > 1 {
                        for turned in 0..3 {
                            let mut unit = Vector::zeros();
                            unit[turned] = 1.0;
                            add(3 + turned, unit.cross(&arm)[axis]);
                        }
                    }
                }
            }
            freedoms.interfaces.push(own);
        }
        for row in 0..size {
            let is_there = !(stiffness.rows[row].is_empty() && mass.rows[row].is_empty());
            if let Some(unknown) = freedoms.next(is_there && !rigid[row]) {
                freedoms.map[row].push((unknown, 1.0));
            }
        }
        freedoms
    }

    fn next(&mut self, is_one: bool) -> Option<usize> {
        let own = self.count;
        self.count += usize::from(is_one);
        is_one.then_some(own)
    }

    pub fn reduced(&self, matrix: &Sparse) -> Sparse {
        let entries = matrix.rows.iter().enumerate().flat_map(|(row, entries)| {
            entries.iter().flat_map(move |&(column, value)| {
                let columns = &self.map[column];
                let rows = self.map[row].iter();
                rows.flat_map(move |&(i, f)| columns.iter().map(move |&(j, g)| (i, j, f * g * value)))
            })
        });
        Sparse::new(self.count, entries)
    }

    pub fn expanded(&self, y: &[f64]) -> Vec<f64> {
        let value = |entries: &Vec<(usize, f64)>| entries.iter().map(|&(unknown, factor)| factor * y[unknown]).sum();
        self.map.iter().map(value).collect()
    }

    /// A rigid motion about the origin: `u = shift + turn x r`.
    pub fn rigid(&self, body: &Imported, motion: [Vector; 2]) -> Vec<f64> {
        let mut y = vec![0.0; self.count];
        for (row, value) in rigid_motion(body, motion).into_iter().enumerate() {
            if let [(unknown, 1.0)] = self.map[row][..] {
                y[unknown] = value;
            }
        }
        for (interface, own) in body.interfaces.iter().zip(&self.interfaces) {
            let at = motion[0] + motion[1].cross(&interface.place);
            for (component, unknown) in own.iter().enumerate() {
                if let Some(unknown) = unknown {
                    y[*unknown] = if component < 3 {
                        at[component]
                    } else {
                        motion[1][component - 3]
                    };
                }
            }
        }
        y
    }
}

/// Rigid motions: shift and turn.
pub(super) fn rigid_motions() -> [[Vector; 2]; FULL_NODE] {
    std::array::from_fn(|which| {
        let mut motion = [Vector::zeros(); 2];
        motion[which / 3][which % 3] = 1.0;
        motion
    })
}

/// Displacements of all nodes in a rigid motion about the origin.
pub(super) fn rigid_motion(body: &Imported, [shift, turn]: [Vector; 2]) -> Vec<f64> {
    let per_node = body.elements.per_node;
    let nodes = body.elements.nodes.iter();
    let all = nodes.flat_map(|&node| {
        let moved = shift + turn.cross(&Vector::from(node));
        let both: [[f64; 3]; 2] = [moved.into(), turn.into()];
        both.into_iter().flatten().take(per_node)
    });
    all.collect()
}

pub(super) fn massless() -> String {
    "a rigid motion of it has no mass: its mass matrix `M` is not that of a body".into()
}

pub(super) fn loose(is_free: bool) -> String {
    match is_free {
        true => "it has a motion without stiffness beside the six rigid ones, or a negative mass: its matrices are not those of one connected body".into(),
        false => "it can move in its frame without stiffness, and modes cannot describe that: clamp one of its interfaces in its frame, or let no joint hold it there and tie it to other bodies".into(),
    }
}
