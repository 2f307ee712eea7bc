//! An imported body before it is reduced: nodes, matrices and interfaces in SI.

use super::files::{self, FULL_NODE, File, FiniteElements, Matrices, Modes, Sparse};
use crate::space::Vector;

/// Distance below which the nodes of an interface lie on a line, relative to their extent.
const ON_A_LINE: f64 = 1e-6;

/// What a declaration says of a body from elsewhere.
#[derive(Clone, Debug)]
pub struct ImportedSpec {
    /// Name of the body.
    pub body: &'static str,
    /// Paths as declared, and what is in the files.
    pub files: &'static [(&'static str, &'static [u8])],
    /// Units of the files: of length (m), mass (kg) and time (s).
    pub units: [f64; 3],
    /// Names of the interfaces, and the numbers of the nodes of each.
    pub interfaces: &'static [(&'static str, &'static [u64])],
    /// Whether all motions of the interfaces are kept beside the modes.
    pub keeps_interfaces: bool,
    /// Part of critical damping in every mode, and damping proportional to stiffness, s.
    pub damping: [f64; 2],
}

/// A place where a body meets others.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Interface {
    /// Name in the declaration.
    pub name: &'static str,
    /// Its nodes; several move as one rigid body.
    pub nodes: Vec<usize>,
    /// The middle of its nodes, m.
    pub place: Vector,
}

/// A body from files.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Name of the body.
    pub(super) name: &'static str,
    /// In SI, body axes.
    pub(super) elements: FiniteElements,
    pub(super) interfaces: Vec<Interface>,
    pub(super) keeps_interfaces: bool,
    /// See [`ImportedSpec::damping`].
    pub(super) damping: [f64; 2],
}

impl Imported {
    /// Reads the files.
    ///
    /// # Errors
    /// What is wrong with them, by the name of the body.
    pub fn read(spec: &ImportedSpec) -> Result<Self, String> {
        let wrong = |what: String| format!("body `{}`: {what}", spec.body);
        let files: Vec<File> = spec.files.iter().map(|&(path, bytes)| File { path, bytes }).collect();
        let mut elements = FiniteElements::read(&files).map_err(wrong)?;
        let [length, mass, time] = spec.units;
        to_si(&mut elements, [length, mass, time]);
        let mut interfaces: Vec<Interface> = Vec::new();
        for &(name, ids) in spec.interfaces {
            let found = ids
                .iter()
                .map(|&id| elements.find(id).ok_or(id))
                .collect::<Result<Vec<_>, _>>();
            let nodes = found.map_err(|id| wrong(format!("interface `{name}`: there is no node {id}")))?;
            let sum = nodes
                .iter()
                .map(|&node| Vector::from(elements.nodes[node]))
                .sum::<Vector>();
            let interface = Interface {
                name,
                place: (1.0 / nodes.len() as f64) * sum,
                nodes,
            };
            for other in &interfaces {
                if let Some(node) = interface.nodes.iter().find(|node| other.nodes.contains(node)) {
                    return Err(wrong(format!(
                        "interfaces `{}` and `{name}` have the node {} in common: an interface moves as one rigid body, so that both would be one",
                        other.name, elements.ids[*node]
                    )));
                }
            }
            interfaces.push(interface);
        }
        let body = Self {
            name: spec.body,
            elements,
            interfaces,
            keeps_interfaces: spec.keeps_interfaces,
            damping: spec.damping,
        };
        for interface in &body.interfaces {
            if interface.nodes.len() > 1 && !body.has_rotation(interface) {
                return Err(wrong(format!(
                    "interface `{}`: its nodes lie on a line, about which they say no rotation: take one node, or a further one beside the line",
                    interface.name
                )));
            }
        }
        if body.extent().is_nan() || body.extent() <= 0.0 {
            return Err(wrong("all its nodes are at one place".into()));
        }
        Ok(body)
    }

    /// Diagonal of the box about all nodes, m.
    pub fn extent(&self) -> f64 {
        let span = |axis: usize| {
            let places = self.elements.nodes.iter().map(|node| node[axis]);
            let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
            high - low
        };
        Vector::from([0, 1, 2].map(span)).norm()
    }

    /// Number of interfaces.
    pub fn interfaces(&self) -> usize {
        self.interfaces.len()
    }

    /// Name of an interface.
    pub fn interface_name(&self, interface: usize) -> &'static str {
        self.interfaces[interface].name
    }

    /// Where an interface is, m.
    pub fn place(&self, interface: usize) -> Vector {
        self.interfaces[interface].place
    }

    /// Whether an interface knows how it turns.
    pub fn turns(&self, interface: usize) -> bool {
        self.has_rotation(&self.interfaces[interface])
    }

    /// Most modal coordinates that a description by this number of modes has.
    pub fn most_modes(&self, modes: usize) -> usize {
        let further = if self.keeps_interfaces {
            FULL_NODE * self.interfaces.len()
        } else {
            0
        };
        let ready = self.elements.modes.as_ref().map(|modes| modes.count);
        ready.unwrap_or(modes + further)
    }

    fn has_rotation(&self, interface: &Interface) -> bool {
        if self.elements.per_node == FULL_NODE || self.axes().is_some() {
            return true;
        }
        let arms: Vec<Vector> = interface
            .nodes
            .iter()
            .map(|&node| Vector::from(self.elements.nodes[node]) - interface.place)
            .collect();
        let longest = arms.iter().copied().max_by(|a, b| a.norm().total_cmp(&b.norm()));
        let Some(longest) = longest.filter(|arm| arm.norm() > 0.0) else {
            return false;
        };
        let size = longest.norm();
        arms.iter()
            .any(|&arm| longest.cross(&arm).norm() > ON_A_LINE * size * size)
    }

    /// Rates of the axes of the nodes in the modes, where the file has them.
    pub(super) fn axes(&self) -> Option<&[f64]> {
        match &self.elements.matrices {
            Matrices::Modal {
                inertia: files::Inertia::Invariants(invariants),
                ..
            } => invariants.axes.as_deref(),
            _ => None,
        }
    }
}

/// From units of length (m), mass (kg) and time (s) to SI.
fn to_si(elements: &mut FiniteElements, [length, mass, time]: [f64; 3]) {
    if [length, mass, time] == [1.0; 3] {
        return;
    }
    let per_node = elements.per_node;
    for node in &mut elements.nodes {
        *node = node.map(|component| length * component);
    }
    // A unit rotation displaces by a length of the file.
    let arm = |freedom: usize| if freedom % per_node < 3 { 1.0 } else { length };
    let scaled = |matrix: &mut Sparse, factor: f64| {
        for (row, entries) in matrix.rows.iter_mut().enumerate() {
            entries
                .iter_mut()
                .for_each(|(column, value)| *value *= factor * arm(row) * arm(*column));
        }
    };
    if let Some(Modes { count, values }) = &mut elements.modes {
        for (place, value) in values.iter_mut().enumerate() {
            if (place / *count) % per_node < 3 {
                *value *= length;
            }
        }
    }
    let energy = mass * length * length;
    let times = |values: &mut [f64], factor: f64| values.iter_mut().for_each(|value| *value *= factor);
    match &mut elements.matrices {
        Matrices::Full { mass: m, stiffness } => {
            scaled(m, mass);
            scaled(stiffness, mass / (time * time));
        }
        Matrices::Modal {
            mass: m,
            stiffness,
            damping,
            inertia,
        } => {
            times(m, energy);
            times(stiffness, energy / (time * time));
            damping.iter_mut().for_each(|damping| times(damping, energy / time));
            match inertia {
                files::Inertia::Lumped(all) => {
                    for lumped in all {
                        times(&mut lumped[..3], mass);
                        times(&mut lumped[3..], energy);
                    }
                }
                files::Inertia::Invariants(own) => {
                    own.mass *= mass;
                    times(&mut own.moment, mass * length);
                    times(&mut own.phibar, mass * length);
                    times(&mut own.inertia, energy);
                    for values in [&mut own.gamma, &mut own.eta, &mut own.first, &mut own.second] {
                        times(values, energy);
                    }
                }
            }
        }
    }
}
