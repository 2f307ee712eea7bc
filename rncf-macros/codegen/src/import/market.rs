//! Matrices as Matrix Market has them, and the nodes as a table of commas.

use super::{FULL_NODE, File, FiniteElements, Matrices, Sparse, TRANSLATIONS};

/// First word of a file.
const BANNER: &str = "%%matrixmarket";

/// A matrix of a file.
fn matrix(file: &File) -> Result<Sparse, String> {
    let text = std::str::from_utf8(file.bytes).map_err(|_| format!("`{}` is no text", file.path))?;
    let mut lines = text.lines().enumerate().map(|(at, line)| (at + 1, line.trim()));
    let header = lines.next().map_or("", |(_, line)| line).to_ascii_lowercase();
    let words: Vec<&str> = header.split_whitespace().collect();
    let wrong = |line: usize, what: &str| format!("line {line} of `{}` {what}", file.path);
    let [BANNER, "matrix", format @ ("coordinate" | "array"), field, symmetry] = words[..] else {
        let what = "is no header `%%MatrixMarket matrix coordinate real symmetric` (or `array`, `general`)";
        return Err(wrong(1, what));
    };
    if !["real", "double", "integer"].contains(&field) {
        return Err(wrong(
            1,
            &format!("says `{field}`, and matrices of real numbers are read"),
        ));
    }
    let is_symmetric = match symmetry {
        "general" => false,
        "symmetric" => true,
        other => {
            return Err(wrong(
                1,
                &format!("says `{other}`, and `general` and `symmetric` are read"),
            ));
        }
    };
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('%'));
    let (at, sizes) = lines
        .next()
        .ok_or_else(|| wrong(1, "is all of it: the sizes are missing"))?;
    let sizes: Option<Vec<usize>> = sizes.split_whitespace().map(|size| size.parse().ok()).collect();
    let (size, count) = match (sizes.as_deref(), format) {
        (Some(&[rows, columns, entries]), "coordinate") if rows == columns => (rows, Some(entries)),
        (Some(&[rows, columns]), "array") if rows == columns => (rows, None),
        _ => return Err(wrong(at, "does not have the sizes of a square matrix")),
    };
    // What a header promises is not reserved before it has come.
    if size > file.bytes.len() {
        return Err(wrong(at, "says more rows than the file has entries"));
    }
    let (mut entries, mut found) = (Vec::new(), 0);
    // An array stands column by column, a symmetric one from the diagonal down.
    let (mut row, mut column) = (0, 0);
    for (at, line) in lines {
        let mut words = line.split_whitespace();
        let mut number = || words.next().map(|word| word.to_ascii_lowercase().replace('d', "e"));
        let (i, j, value) = match count {
            Some(_) => {
                let mut index = || {
                    number()?
                        .parse::<usize>()
                        .ok()?
                        .checked_sub(1)
                        .filter(|index| *index < size)
                };
                let (i, j) = (index(), index());
                (i, j, number())
            }
            None => {
                let place = (Some(row), Some(column).filter(|column| *column < size));
                row += 1;
                if row == size {
                    column += 1;
                    row = if is_symmetric { column } else { 0 };
                }
                (place.0, place.1, number())
            }
        };
        let (Some(i), Some(j), Some(value)) = (i, j, value.and_then(|value| value.parse::<f64>().ok())) else {
            return Err(wrong(
                at,
                &format!("(`{line}`) has no entry of a matrix of {size} rows"),
            ));
        };
        found += 1;
        entries.push((i, j, value));
        if is_symmetric && i != j {
            entries.push((j, i, value));
        }
    }
    let wanted = count.unwrap_or(if is_symmetric {
        size * (size + 1) / 2
    } else {
        size * size
    });
    if found != wanted {
        return Err(format!(
            "`{}` has {found} entries, and its header says {wanted}: was it cut off?",
            file.path
        ));
    }
    Ok(Sparse::new(size, entries))
}

/// Numbers and positions of nodes, a line each: `id, x, y, z`. A first line of words is their names.
#[allow(clippy::type_complexity)] // two lists, read at once
fn nodes(file: &File) -> Result<(Vec<u64>, Vec<[f64; 3]>), String> {
    let text = std::str::from_utf8(file.bytes).map_err(|_| format!("`{}` is no text", file.path))?;
    let (mut ids, mut places) = (Vec::new(), Vec::new());
    let lines = text.trim_start_matches('\u{feff}').lines().enumerate();
    for (at, line) in lines.map(|(at, line)| (at + 1, line.trim())) {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        if ids.is_empty() && cells[0].parse::<f64>().is_err() {
            let names: Vec<String> = cells.iter().map(|cell| cell.to_ascii_lowercase()).collect();
            if names
                .iter()
                .skip(1)
                .map(|name| name.chars().next())
                .ne(['x', 'y', 'z'].map(Some))
            {
                return Err(format!(
                    "line {at} of `{}` names the columns `{line}`, and `id, x, y, z` belong there",
                    file.path
                ));
            }
            continue;
        }
        let numbers: Option<Vec<f64>> = cells.iter().skip(1).map(|cell| cell.parse().ok()).collect();
        match (cells[0].parse(), numbers.as_deref()) {
            (Ok(id), Some(&[x, y, z])) => {
                ids.push(id);
                places.push([x, y, z]);
            }
            _ => {
                return Err(format!(
                    "line {at} of `{}` (`{line}`) is no node: `id, x, y, z` belong there",
                    file.path
                ));
            }
        }
    }
    Ok((ids, places))
}

/// Reads a body from mass, stiffness and nodes, in this order.
pub fn read(mass: &File, stiffness: &File, table: &File) -> Result<FiniteElements, String> {
    let (ids, nodes) = nodes(table)?;
    let (m, k) = (matrix(mass)?, matrix(stiffness)?);
    if m.size() != k.size() {
        return Err(format!(
            "`{}` has {} rows, and `{}` has {}",
            stiffness.path,
            k.size(),
            mass.path,
            m.size()
        ));
    }
    let per_node = [TRANSLATIONS, FULL_NODE]
        .into_iter()
        .find(|per_node| per_node * nodes.len() == m.size());
    let per_node = per_node.ok_or_else(|| {
        format!(
            "`{}` has {} rows, and the {} nodes of `{}` with 3 or 6 degrees of freedom (ux, uy, uz, then rx, ry, rz) have {} or {}",
            mass.path,
            m.size(),
            nodes.len(),
            table.path,
            3 * nodes.len(),
            6 * nodes.len()
        )
    })?;
    Ok(FiniteElements {
        ids,
        nodes,
        per_node,
        matrices: Matrices::Full { mass: m, stiffness: k },
        modes: None,
    })
}
