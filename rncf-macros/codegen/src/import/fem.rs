//! Modes as the text files of MBDyn's element `modal` have them (its input manual, "FEM File Format"): groups of records behind
//! lines `** RECORD GROUP n`, other lines that begin with `**` are remarks.

use super::{FULL_NODE, File, FiniteElements, Inertia, Matrices, Modes};

/// Groups of records: of the header, the nodes' numbers, their coordinates x, y, z, mode shapes, mass, stiffness, lumped masses,
/// and damping.
const HEADER: usize = 1;
const NUMBERS: usize = 2;
const PLACES: [usize; 3] = [5, 6, 7];
const SHAPES: usize = 8;
const MASS: usize = 9;
const STIFFNESS: usize = 10;
const LUMPED: usize = 11;
const DAMPING: usize = 13;
/// Most groups that there are.
const GROUPS: usize = 24;

/// Words of a group, each with its line.
type Words<'a> = Vec<(usize, &'a str)>;

struct Groups<'a> {
    path: &'a str,
    groups: Vec<Words<'a>>,
}

impl Groups<'_> {
    /// All numbers of a group, of which there are `count`.
    fn numbers(&self, group: usize, what: &str, count: usize) -> Result<Vec<f64>, String> {
        let words = &self.groups[group];
        if words.len() != count {
            return Err(format!(
                "`{}`: record group {group} ({what}) has {} numbers, and {count} belong there",
                self.path,
                words.len()
            ));
        }
        let number = |&(line, word): &(usize, &str)| {
            let number = word.to_ascii_lowercase().replace('d', "e").parse::<f64>();
            number.map_err(|_| format!("line {line} of `{}`: `{word}` is no number ({what})", self.path))
        };
        words.iter().map(number).collect()
    }

    /// A number that counts or numbers something.
    fn whole(&self, (line, word): (usize, &str), what: &str) -> Result<u64, String> {
        word.parse()
            .map_err(|_| format!("line {line} of `{}`: `{word}` is no whole number ({what})", self.path))
    }
}

/// Reads a body.
pub fn read(file: &File) -> Result<FiniteElements, String> {
    let path = file.path;
    let text = std::str::from_utf8(file.bytes).map_err(|_| format!("`{path}` is no text"))?;
    let mut all = Groups {
        path,
        groups: vec![Vec::new(); GROUPS + 1],
    };
    let mut current: Option<usize> = None;
    for (at, line) in text.lines().enumerate() {
        if let Some(remark) = line.trim_start().strip_prefix("**") {
            let remark = remark.trim_start().to_ascii_uppercase();
            if let Some(rest) = remark.strip_prefix("RECORD GROUP") {
                let digits: String = rest.trim_start().chars().take_while(char::is_ascii_digit).collect();
                current = digits.parse().ok().filter(|group| *group <= GROUPS);
                if current.is_none() {
                    return Err(format!("line {} of `{path}` names no record group from 1 on", at + 1));
                }
            }
            continue;
        }
        if let Some(group) = current {
            let words: &mut Words = &mut all.groups[group];
            words.extend(line.split_whitespace().map(|word| (at + 1, word)));
        }
    }
    let header = &all.groups[HEADER];
    let [_, nodes, modes @ ..] = &header[..] else {
        return Err(format!(
            "`{path}` has no header (`** RECORD GROUP 1` with REV, the number of nodes, and those of normal, attachment, constraint and rejected modes)"
        ));
    };
    let nodes = all.whole(*nodes, "the number of nodes")? as usize;
    let counts: Result<Vec<u64>, String> = modes.iter().map(|word| all.whole(*word, "a number of modes")).collect();
    let k = match counts?[..] {
        [normal, attached, constraint, rejected] => normal
            .checked_add(attached)
            .and_then(|sum| sum.checked_add(constraint))
            .and_then(|sum| sum.checked_sub(rejected)),
        _ => None,
    };
    let Some(k) = k
        .map(|k| k as usize)
        .filter(|k| *k > 0 && k.saturating_mul(nodes) <= file.bytes.len())
    else {
        return Err(format!(
            "`{path}`: the header does not have the numbers of nodes and of normal, attachment, constraint and rejected modes"
        ));
    };
    let labels = &all.groups[NUMBERS];
    if labels.len() != nodes {
        return Err(format!(
            "`{path}`: record group {NUMBERS} has {} nodes, and the header says {nodes}",
            labels.len()
        ));
    }
    let ids: Result<Vec<u64>, String> = labels
        .iter()
        .map(|word| all.whole(*word, "the number of a node"))
        .collect();
    let [x, y, z] = PLACES.map(|group| all.numbers(group, "coordinates of the nodes", nodes));
    let (x, y, z) = (x?, y?, z?);
    // Mode by mode and node by node.
    let shapes = all.numbers(SHAPES, "mode shapes, six numbers a node", FULL_NODE * nodes * k)?;
    let size = FULL_NODE * nodes;
    let values = (0..size * k).map(|at| shapes[(at % k) * size + at / k]).collect();
    // Column by column; both are symmetric.
    let mass = all.numbers(MASS, "the modal mass matrix", k * k)?;
    let stiffness = all.numbers(STIFFNESS, "the modal stiffness matrix", k * k)?;
    let lumped = all.numbers(
        LUMPED,
        "the diagonal of the lumped mass matrix, six numbers a node",
        size,
    )?;
    let damping = match all.groups[DAMPING].is_empty() {
        true => None,
        false => Some(all.numbers(DAMPING, "the modal damping matrix", k * k)?),
    };
    let masses = lumped
        .chunks_exact(FULL_NODE)
        .map(|own| std::array::from_fn(|at| own[at]))
        .collect();
    Ok(FiniteElements {
        ids: ids?,
        nodes: (0..nodes).map(|node| [x[node], y[node], z[node]]).collect(),
        per_node: FULL_NODE,
        matrices: Matrices::Modal {
            mass,
            stiffness,
            damping,
            inertia: Inertia::Lumped(masses),
        },
        modes: Some(Modes { count: k, values }),
    })
}
