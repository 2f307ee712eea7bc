//! Archives of arrays, as `numpy.savez` and `numpy.savez_compressed` write them.

use super::archive::{Member, members};
use super::array::Array;
use super::{FULL_NODE, File, FiniteElements, Inertia, Invariants, Matrices, Modes, Sparse, TRANSLATIONS};

/// Numbers above this are no whole ones any more.
const LARGEST_ID: f64 = 9.0e15;

/// The arrays of a file.
struct Arrays<'a> {
    path: &'a str,
    members: Vec<Member<'a>>,
}

impl Arrays<'_> {
    fn has(&self, name: &str) -> bool {
        self.members.iter().any(|member| bare(&member.name) == name)
    }

    fn find(&self, name: &str) -> Result<Option<Array>, String> {
        let Some(member) = self.members.iter().find(|member| bare(&member.name) == name) else {
            return Ok(None);
        };
        let array = member.unpacked().and_then(|bytes| Array::read(&bytes));
        array.map(Some).map_err(|what| self.wrong(name, &what))
    }

    fn wrong(&self, name: &str, what: &str) -> String {
        format!("`{}`: the array `{name}` {what}", self.path)
    }

    fn need(&self, name: &str, why: &str) -> Result<Array, String> {
        self.find(name)?.ok_or_else(|| {
            let names: Vec<&str> = self.members.iter().map(|member| bare(&member.name)).collect();
            let there = match names.is_empty() {
                true => "it has none".to_string(),
                false => format!("it has `{}`", names.join("`, `")),
            };
            format!("`{}` has no array `{name}` ({why}): {there}", self.path)
        })
    }

    /// An array of a shape.
    fn shaped(&self, name: &str, why: &str, shape: &[usize]) -> Result<Vec<f64>, String> {
        let array = self.need(name, why)?;
        let own: Vec<usize> = array.shape.iter().copied().filter(|size| *size != 1).collect();
        let wanted: Vec<usize> = shape.iter().copied().filter(|size| *size != 1).collect();
        if own != wanted {
            let sizes = shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
            return Err(self.wrong(
                name,
                &format!("has {}, and {sizes} belong there: {why}", array.describe()),
            ));
        }
        Ok(array.values)
    }

    /// A whole array of numbers that count or number something.
    fn whole(&self, name: &str, array: &Array) -> Result<Vec<usize>, String> {
        let whole = |&value: &f64| {
            (value >= 0.0 && value.fract() == 0.0 && value <= LARGEST_ID)
                .then_some(value as usize)
                .ok_or_else(|| self.wrong(name, &format!("has {value}, which is no whole number from 0 on")))
        };
        array.values.iter().map(whole).collect()
    }

    /// A square matrix: whole, or in the parts of scipy's compressed rows or columns behind its name.
    fn matrix(&self, name: &str, why: &str) -> Result<Sparse, String> {
        let part = |word: &str| {
            let names = ["_", "."].map(|sign| format!("{name}{sign}{word}"));
            names.into_iter().find(|name| self.has(name))
        };
        let Some(data) = part("data").filter(|_| !self.has(name)) else {
            let array = self.need(name, why)?;
            let [rows, columns] = array.shape[..] else {
                return Err(self.wrong(
                    name,
                    &format!("has {}, and a square matrix belongs there", array.describe()),
                ));
            };
            if rows != columns {
                return Err(self.wrong(name, &format!("is {}, and no square matrix", array.describe())));
            }
            return Ok(Sparse::dense(rows, &array.values));
        };
        let named =
            |word: &str| part(word).ok_or_else(|| self.wrong(&data, &format!("needs `{name}_{word}` beside it")));
        let values = self.need(&data, why)?.values;
        let [indices, starts, shape] = ["indices", "indptr", "shape"].map(|word| {
            let own = named(word)?;
            let array = self.need(&own, why)?;
            self.whole(&own, &array)
        });
        let (indices, starts, shape) = (indices?, starts?, shape?);
        let [size, other] = shape[..] else {
            return Err(self.wrong(name, "has a shape of not two sizes"));
        };
        let is_sound = size == other
            && starts.len().checked_sub(1) == Some(size)
            && starts.windows(2).all(|pair| pair[0] <= pair[1])
            && starts
                .last()
                .is_some_and(|&end| end == values.len() && end == indices.len())
            && indices.iter().all(|&index| index < size);
        if !is_sound {
            return Err(self.wrong(
                name,
                "is no square matrix in compressed rows: `data`, `indices`, `indptr` and `shape` do not fit together",
            ));
        }
        let of_row = |row: usize| (starts[row]..starts[row + 1]).map(move |at| (row, at));
        let entries = (0..size)
            .flat_map(of_row)
            .map(|(row, at)| (row, indices[at], values[at]));
        Ok(Sparse::new(size, entries))
    }
}

fn bare(name: &str) -> &str {
    name.strip_suffix(".npy").unwrap_or(name)
}

/// Reads a body.
pub fn read(file: &File) -> Result<FiniteElements, String> {
    let path = file.path;
    let arrays = Arrays {
        path,
        members: members(file.bytes).map_err(|what| format!("`{path}` {what}"))?,
    };
    let positions = arrays.need("nodes", "the positions of the nodes, n x 3")?;
    let [count, 3] = positions.shape[..] else {
        let what = format!(
            "has {}, and n x 3 belong there: the positions of the nodes",
            positions.describe()
        );
        return Err(arrays.wrong("nodes", &what));
    };
    let nodes: Vec<[f64; 3]> = positions
        .values
        .chunks_exact(3)
        .map(|node| [node[0], node[1], node[2]])
        .collect();
    let ids = match arrays.find("node_ids")? {
        Some(array) if array.values.len() == count => {
            let all = arrays.whole("node_ids", &array)?;
            all.into_iter().map(|id| id as u64).collect()
        }
        Some(array) => {
            let what = format!("has {} for {count} nodes", array.describe());
            return Err(arrays.wrong("node_ids", &what));
        }
        None => (1..=count as u64).collect(),
    };
    if arrays.has("M_modal") {
        return modal(&arrays, ids, nodes);
    }
    let mass = arrays.matrix("M", "the mass matrix")?;
    let stiffness = arrays.matrix("K", "the stiffness matrix")?;
    let size = mass.size();
    if stiffness.size() != size {
        let what = format!("has {} rows, and `M` has {size}", stiffness.size());
        return Err(arrays.wrong("K", &what));
    }
    let Some(per_node) = [TRANSLATIONS, FULL_NODE]
        .into_iter()
        .find(|per_node| per_node * count == size)
    else {
        let what = format!(
            "has {size} rows, and {count} nodes with 3 or 6 degrees of freedom (ux, uy, uz, then rx, ry, rz) have {} or {}",
            3 * count,
            6 * count
        );
        return Err(arrays.wrong("M", &what));
    };
    let modes = match arrays.find("modes")? {
        Some(array) => {
            let [rows, columns] = array.shape[..] else {
                return Err(arrays.wrong(
                    "modes",
                    &format!("has {}, and a matrix belongs there", array.describe()),
                ));
            };
            if rows != size || columns == 0 {
                let what = format!(
                    "is {}, and {size} rows with a column for each mode belong there",
                    array.describe()
                );
                return Err(arrays.wrong("modes", &what));
            }
            Some(Modes {
                count: columns,
                values: array.values,
            })
        }
        None => None,
    };
    Ok(FiniteElements {
        ids,
        nodes,
        per_node,
        matrices: Matrices::Full { mass, stiffness },
        modes,
    })
}

/// A body that is known by its modes.
fn modal(arrays: &Arrays, ids: Vec<u64>, nodes: Vec<[f64; 3]>) -> Result<FiniteElements, String> {
    let shapes = arrays.need("modes", "the displacements of the nodes in the modes, 6 n x k")?;
    let [rows, k] = shapes.shape[..] else {
        return Err(arrays.wrong(
            "modes",
            &format!("has {}, and a matrix belongs there", shapes.describe()),
        ));
    };
    let Some(per_node) = [TRANSLATIONS, FULL_NODE]
        .into_iter()
        .find(|per_node| per_node * nodes.len() == rows)
    else {
        let what = format!(
            "is {}, and {} nodes have 3 or 6 rows each",
            shapes.describe(),
            nodes.len()
        );
        return Err(arrays.wrong("modes", &what));
    };
    let why = "a body that is known by its modes needs it";
    let array = |name: &str, shape: &[usize]| arrays.shaped(name, why, shape);
    let damping = match arrays.has("C_modal") {
        true => Some(array("C_modal", &[k, k])?),
        false => None,
    };
    let axes = match arrays.has("axes") {
        true => Some(array("axes", &[nodes.len(), k, 9])?),
        false => None,
    };
    let mut inertia = [0.0; 9];
    inertia.copy_from_slice(&array("inertia", &[3, 3])?);
    let moment = array("moment", &[3])?;
    let invariants = Invariants {
        mass: array("mass", &[1])?[0],
        moment: [moment[0], moment[1], moment[2]],
        inertia,
        phibar: array("phibar", &[k, 3])?,
        gamma: array("gamma", &[k, 3])?,
        eta: array("eta", &[k, k, 3])?,
        first: array("Gamma", &[k, 3, 3])?,
        second: array("Upsilon", &[k, k, 3, 3])?,
        axes,
    };
    Ok(FiniteElements {
        ids,
        nodes,
        per_node,
        matrices: Matrices::Modal {
            mass: array("M_modal", &[k, k])?,
            stiffness: array("K_modal", &[k, k])?,
            damping,
            inertia: Inertia::Invariants(Box::new(invariants)),
        },
        modes: Some(Modes {
            count: k,
            values: shapes.values,
        }),
    })
}
