//! Numbering: which components of the nodal vectors are unknowns. Conditions that are linear in a
//! vector are eliminated, `q = qbar(t) + E x` (THEORY 6): every component depends on at most one
//! unknown.

/// What is unknown of a nodal vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VectorKind {
    /// All components.
    Free,
    /// The norm along a constant unit vector (components in the body's order).
    Directed([f64; 3]),
    /// The components that are not held; held ones keep their undeformed value.
    Held([bool; 3]),
    /// Nothing: the vector is a given function of time.
    Prescribed,
}

/// Component, unknown and factor.
type Odd = (usize, usize, f64);

/// Numbering of all nodal vectors.
#[derive(Clone, Debug)]
pub struct Layout {
    kinds: Vec<VectorKind>,
    /// First component of every vector in the full arrays, and their length at the end.
    offsets: Vec<usize>,
    /// For every component: the unknown it depends on and the factor.
    map: Vec<Option<(usize, f64)>>,
    /// The same, as blocks to copy: first component, first unknown, number; and components with a factor.
    blocks: Vec<[usize; 3]>,
    odd: Vec<Odd>,
    /// For every vector the one whose value is that of all vectors of its node: itself, where it is not shared.
    leaders: Vec<usize>,
    /// Vector and component of every unknown of vectors.
    origins: Vec<(usize, usize)>,
    unknowns: usize,
}

impl Layout {
    /// Numbers vectors of the given dimensions in order, then `border` more components that are
    /// unknowns themselves: those of free frames.
    pub fn new(dimensions: &[usize], kinds: Vec<VectorKind>, border: usize) -> Self {
        let alone = (0..kinds.len()).collect();
        Self::shared(dimensions, kinds, alone, border)
    }

    /// The same where vectors are one: those with one leader (an index of a vector that leads itself) have the
    /// unknowns of the first of them. Vectors that are one must be [`VectorKind::Free`] and of one dimension.
    pub fn shared(dimensions: &[usize], kinds: Vec<VectorKind>, leaders: Vec<usize>, border: usize) -> Self {
        let mut offsets = vec![0];
        let mut map: Vec<Option<(usize, f64)>> = Vec::new();
        let mut origins = Vec::new();
        let mut unknowns = 0;
        // The first vector of those with a leader.
        let mut numbered: Vec<Option<usize>> = vec![None; kinds.len()];
        for (vector, (&dimension, kind)) in dimensions.iter().zip(&kinds).enumerate() {
            if let Some(first) = numbered[leaders[vector]] {
                let first: usize = offsets[first];
                map.extend_from_within(first..first + dimension);
                offsets.push(map.len());
                continue;
            }
            numbered[leaders[vector]] = Some(vector);
            for component in 0..dimension {
                let entry = match kind {
                    VectorKind::Free => Some((unknowns + component, 1.0)),
                    VectorKind::Directed(direction) => Some((unknowns, direction[component])),
                    VectorKind::Held(held) if held[component] => None,
                    VectorKind::Held(held) => Some((unknowns + free_components(held, component), 1.0)),
                    VectorKind::Prescribed => None,
                };
                if let Some((unknown, _)) = entry
                    && unknown == origins.len()
                {
                    origins.push((vector, component));
                }
                map.push(entry);
            }
            unknowns = origins.len();
            offsets.push(map.len());
        }
        map.extend((unknowns..unknowns + border).map(|unknown| Some((unknown, 1.0))));
        let (blocks, odd) = in_blocks(&map);
        Self {
            kinds,
            offsets,
            map,
            blocks,
            odd,
            leaders,
            origins,
            unknowns: unknowns + border,
        }
    }

    /// Number of unknowns, those of free frames at the end.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// Number of unknowns of free frames.
    pub fn border(&self) -> usize {
        self.map.len() - self.vector_components()
    }

    /// Number of components of all vectors: those of free frames follow.
    pub fn vector_components(&self) -> usize {
        self.offsets[self.offsets.len() - 1]
    }

    /// Number of components of all vectors and free frames.
    pub fn components(&self) -> usize {
        self.map.len()
    }

    /// First component of a vector in the full arrays.
    pub fn offset(&self, vector: usize) -> usize {
        self.offsets[vector]
    }

    /// Kind of a vector.
    pub fn kind(&self, vector: usize) -> VectorKind {
        self.kinds[vector]
    }

    /// The unknown that a component depends on, and the factor.
    pub fn unknown(&self, component: usize) -> Option<(usize, f64)> {
        self.map[component]
    }

    /// `full = E x` on components that depend on an unknown; the others stay.
    pub fn expand(&self, x: &[f64], full: &mut [f64]) {
        for &[component, unknown, count] in &self.blocks {
            full[component..component + count].copy_from_slice(&x[unknown..unknown + count]);
        }
        for &(component, unknown, factor) in &self.odd {
            full[component] = factor * x[unknown];
        }
    }

    /// `x = E^T full`: forces on unknowns.
    pub fn project(&self, full: &[f64], x: &mut [f64]) {
        x.fill(0.0);
        for &[component, unknown, count] in &self.blocks {
            let sums = x[unknown..unknown + count].iter_mut();
            sums.zip(&full[component..component + count])
                .for_each(|(sum, value)| *sum += value);
        }
        for &(component, unknown, factor) in &self.odd {
            x[unknown] += factor * full[component];
        }
    }

    /// The unknowns of vectors (their components alone) that satisfy the conditions; of those that are one the
    /// leader's value is taken. Unknowns of free frames are zero.
    pub fn unknowns_of(&self, full: &[f64], x: &mut [f64]) {
        x.fill(0.0);
        for (vector, &leader) in self.leaders.iter().enumerate() {
            if leader != vector {
                continue;
            }
            for component in self.offsets[vector]..self.offsets[vector + 1] {
                if let Some((unknown, factor)) = self.map[component] {
                    x[unknown] += factor * full[component];
                }
            }
        }
    }

    /// The vector and component of every unknown that belongs to one; component 0 stands for the norm of a directed
    /// one, and the first vector for those that are one.
    pub fn origins(&self) -> &[(usize, usize)] {
        &self.origins
    }
}

/// Components that follow each other as their unknowns do, and those with a factor.
fn in_blocks(map: &[Option<(usize, f64)>]) -> (Vec<[usize; 3]>, Vec<Odd>) {
    let (mut blocks, mut odd): (Vec<[usize; 3]>, Vec<_>) = (Vec::new(), Vec::new());
    for (component, entry) in map.iter().enumerate() {
        match (*entry, blocks.last_mut()) {
            (None, _) => {}
            (Some((unknown, factor)), _) if factor != 1.0 => odd.push((component, unknown, factor)),
            (Some((unknown, _)), Some([first, start, count]))
                if *first + *count == component && *start + *count == unknown =>
            {
                *count += 1;
            }
            (Some((unknown, _)), _) => blocks.push([component, unknown, 1]),
        }
    }
    (blocks, odd)
}

/// How many of the first `count` components are not held.
fn free_components(held: &[bool; 3], count: usize) -> usize {
    held[..count].iter().filter(|&&held| !held).count()
}
