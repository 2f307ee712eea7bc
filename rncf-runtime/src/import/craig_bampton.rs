//! All motions of the interfaces of an imported body, and normal modes with the interfaces held (Craig and Bampton).

use super::files::Sparse;
use super::freedoms::{Columns, Freedoms, loose, massless};
use super::lowest::{Lowest, factored, lowest, orthonormal};

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Modes of the body whose interfaces move as they like, with so many normal modes in between.
pub(super) fn craig_bampton(
    freedoms: &Freedoms,
    stiffness: &Sparse,
    mass: &Sparse,
    rigid: &[Vec<f64>],
    count: usize,
) -> Result<Lowest, String> {
    let size = freedoms.count;
    let moved: Vec<usize> = freedoms.interfaces.iter().flatten().flatten().copied().collect();
    let inside: Vec<usize> = (0..size).filter(|unknown| !moved.contains(unknown)).collect();
    if count > inside.len() {
        return Err(format!(
            "is to have {count} normal modes but has only {} freedoms between its interfaces: ask for fewer",
            inside.len()
        ));
    }
    let held = || {
        "with its interfaces held it can still move without stiffness: its matrices are not those of one connected body"
            .to_string()
    };
    let mut basis: Columns = Vec::new();
    if inside.is_empty() {
        basis.extend(moved.iter().map(|&unknown| unit(size, unknown)));
    } else {
        let mut factors = factored(stiffness, &inside).ok_or_else(held)?;
        for &unknown in &moved {
            let image = stiffness.times(&unit(size, unknown));
            let mut load: Vec<f64> = inside.iter().map(|&at| -image[at]).collect();
            factors.solve(&mut load);
            let mut vector = unit(size, unknown);
            inside.iter().zip(load).for_each(|(&at, value)| vector[at] = value);
            basis.push(vector);
        }
        let part = |matrix: &Sparse| {
            let mut place = vec![None; size];
            inside.iter().enumerate().for_each(|(at, &full)| place[full] = Some(at));
            let entries = inside.iter().enumerate().flat_map(|(at, &full)| {
                let place = &place;
                let own = matrix.rows[full].iter();
                own.filter_map(move |&(column, value)| Some((at, place[column]?, value)))
            });
            Sparse::new(inside.len(), entries.collect::<Vec<_>>())
        };
        let normal = lowest(&part(stiffness), &part(mass), &[], count).ok_or_else(held)?;
        for mode in normal.vectors {
            let mut vector = vec![0.0; size];
            inside.iter().zip(mode).for_each(|(&at, value)| vector[at] = value);
            basis.push(vector);
        }
    }
    let width = basis.len();
    let projected = |matrix: &Sparse| {
        let images: Columns = basis.iter().map(|vector| matrix.times(vector)).collect();
        let entries =
            (0..width * width).map(|at| (at / width, at % width, dot(&basis[at / width], &images[at % width])));
        Sparse::new(width, entries)
    };
    let (k, m) = (projected(stiffness), projected(mass));
    let small: Columns = rigid
        .iter()
        .map(|motion| {
            let own = moved.iter().map(|&unknown| motion[unknown]);
            own.chain((moved.len()..width).map(|_| 0.0)).collect()
        })
        .collect();
    let small = orthonormal(&m, small).ok_or_else(massless)?;
    let count = width - small.len();
    let found = lowest(&k, &m, &small, count).ok_or_else(|| loose(!rigid.is_empty()))?;
    let whole = |combination: &Vec<f64>| {
        let mut vector = vec![0.0; size];
        for (factor, own) in combination.iter().zip(&basis) {
            vector
                .iter_mut()
                .zip(own)
                .for_each(|(sum, value)| *sum += factor * value);
        }
        vector
    };
    Ok(Lowest {
        vectors: found.vectors.iter().map(whole).collect(),
        frequencies: found.frequencies,
    })
}

fn unit(size: usize, at: usize) -> Vec<f64> {
    let mut vector = vec![0.0; size];
    vector[at] = 1.0;
    vector
}
