//! Files: bodies from finite-element programs, and tables. The macro reads a file to check it at the word, the runtime to
//! build with it: one text for both, which knows neither.

mod archive;
mod array;
mod fem;
pub mod hash;
mod market;
mod npz;
pub mod rows;
mod sparse;
pub mod spline;

pub use archive::checksum;
pub use sparse::Sparse;

use std::io::ErrorKind;
use std::path::Path;

/// Degrees of freedom of a node with translations alone, and with rotations.
pub const TRANSLATIONS: usize = 3;
/// See [`TRANSLATIONS`].
pub const FULL_NODE: usize = 6;
/// Relative difference of two entries that count as equal in a symmetric matrix.
const SYMMETRIC: f64 = 1e-8;

/// All bytes of a file; `start` says where paths begin.
///
/// # Errors
/// Why it cannot be read and what to do, as the end of a sentence.
pub fn bytes(path: &Path, start: &str) -> Result<Vec<u8>, String> {
    std::fs::read(path).map_err(|error| {
        let cure = match error.kind() {
            ErrorKind::NotFound => format!("a path begins {start}"),
            ErrorKind::IsADirectory => "give the path of a file in it".into(),
            ErrorKind::PermissionDenied => "give the user of this program the right to read it".into(),
            _ => return error.to_string(),
        };
        format!("{error}; {cure}")
    })
}

/// A file and what is in it.
#[derive(Clone, Copy, Debug)]
pub struct File<'a> {
    /// As the declaration names it.
    pub path: &'a str,
    /// All of it.
    pub bytes: &'a [u8],
}

/// What a file says of a body, in the units of the file. Degrees of freedom stand node by node: ux, uy, uz, and where nodes
/// have rotations rx, ry, rz.
#[derive(Clone, Debug, PartialEq)]
pub struct FiniteElements {
    /// Numbers of the nodes.
    pub ids: Vec<u64>,
    /// Their positions.
    pub nodes: Vec<[f64; 3]>,
    /// Degrees of freedom of a node: 3 or 6.
    pub per_node: usize,
    /// What is known of inertia and elasticity.
    pub matrices: Matrices,
    /// Ready-made modes, a column each: rows are the degrees of freedom, `modes[row * count + mode]`.
    pub modes: Option<Modes>,
}

/// Columns of displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// Number of columns.
    pub count: usize,
    /// Rows first.
    pub values: Vec<f64>,
}

/// Matrices of the whole body, or of its modes.
#[derive(Clone, Debug, PartialEq)]
pub enum Matrices {
    /// Of all degrees of freedom.
    Full {
        /// Mass.
        mass: Sparse,
        /// Stiffness.
        stiffness: Sparse,
    },
    /// Of the ready-made modes, rows first.
    Modal {
        /// Mass.
        mass: Vec<f64>,
        /// Stiffness.
        stiffness: Vec<f64>,
        /// Damping, where there is one.
        damping: Option<Vec<f64>>,
        /// What inertia follows from.
        inertia: Inertia,
    },
}

/// Inertia of a body that is known by its modes.
#[derive(Clone, Debug, PartialEq)]
pub enum Inertia {
    /// Masses lumped at the nodes: of translations, and the moments about the three axes through the node.
    Lumped(Vec<[f64; 6]>),
    /// The invariants of the modes.
    Invariants(Box<Invariants>),
}

/// Invariants of inertia (docs/theory.md, 3.2), about the origin; matrices rows first, of two modes with i before j.
#[derive(Clone, Debug, PartialEq)]
pub struct Invariants {
    /// m
    pub mass: f64,
    /// m r_c
    pub moment: [f64; 3],
    /// J0
    pub inertia: [f64; 9],
    /// phibar_i, 3 numbers a mode.
    pub phibar: Vec<f64>,
    /// gamma_i, 3 numbers a mode.
    pub gamma: Vec<f64>,
    /// eta_ij, 3 numbers a pair.
    pub eta: Vec<f64>,
    /// Gamma_i, 9 numbers a mode.
    pub first: Vec<f64>,
    /// Ups_ij, 9 numbers a pair.
    pub second: Vec<f64>,
    /// Rates of the axes of the nodes in the modes, where they are more than rotations: 9 numbers (d e_x, d e_y, d e_z) a node
    /// and mode.
    pub axes: Option<Vec<f64>>,
}

impl FiniteElements {
    /// Reads files.
    ///
    /// # Errors
    /// What is wrong, with file and array.
    pub fn read(files: &[File]) -> Result<Self, String> {
        let kind = |file: &File| file.path.rsplit('.').next().unwrap_or("").to_ascii_lowercase();
        let kinds: Vec<String> = files.iter().map(kind).collect();
        let kinds: Vec<&str> = kinds.iter().map(String::as_str).collect();
        let body = match (&kinds[..], files) {
            (["npz"], [file]) => npz::read(file),
            (["fem"], [file]) => fem::read(file),
            (["mtx", "mtx", "csv"], [mass, stiffness, nodes]) => market::read(mass, stiffness, nodes),
            _ => {
                let names: Vec<&str> = files.iter().map(|file| file.path).collect();
                Err(format!(
                    "`{}`: what is read are one `.npz`, one `.fem`, or the mass matrix, the stiffness matrix and the nodes, `\"M.mtx\", \"K.mtx\", \"nodes.csv\"`",
                    names.join("`, `")
                ))
            }
        }?;
        let path = files.first().map_or("", |file| file.path);
        body.check(path)?;
        Ok(body)
    }

    /// Number of degrees of freedom.
    pub fn size(&self) -> usize {
        self.nodes.len() * self.per_node
    }

    /// Place of a node among the nodes.
    pub fn find(&self, id: u64) -> Option<usize> {
        self.ids.iter().position(|own| *own == id)
    }

    /// What all formats must fulfil.
    fn check(&self, path: &str) -> Result<(), String> {
        if self.nodes.is_empty() {
            return Err(format!("`{path}` has no nodes"));
        }
        let is_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        if let Some(node) = self.nodes.iter().position(|node| !is_finite(node)) {
            return Err(format!(
                "`{path}`: the position of node {} is not finite",
                self.ids[node]
            ));
        }
        let mut sorted = self.ids.clone();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(format!("`{path}`: two nodes have the number {}", pair[0]));
        }
        if let Some(modes) = &self.modes
            && !is_finite(&modes.values)
        {
            return Err(format!("`{path}`: `modes` has a value that is not finite"));
        }
        match &self.matrices {
            Matrices::Full { mass, stiffness } => {
                for (name, matrix) in [("M", mass), ("K", stiffness)] {
                    matrix.check(&format!("`{path}`: `{name}`"), SYMMETRIC)?;
                }
                Ok(())
            }
            Matrices::Modal {
                mass,
                stiffness,
                damping,
                ..
            } => {
                let named = [
                    ("M_modal", Some(mass)),
                    ("K_modal", Some(stiffness)),
                    ("C_modal", damping.as_ref()),
                ];
                for (name, matrix) in named.into_iter().filter_map(|(name, matrix)| Some((name, matrix?))) {
                    let count = self.modes.as_ref().map_or(0, |modes| modes.count);
                    Sparse::dense(count, matrix).check(&format!("`{path}`: `{name}`"), SYMMETRIC)?;
                }
                Ok(())
            }
        }
    }
}

#[cfg(test)]
mod tests;
