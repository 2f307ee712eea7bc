//! Numbering: which components of the nodal vectors are unknowns. Conditions that are linear in
//! vectors are eliminated, `q = qbar(t) + E x` (THEORY 6): a component depends on at most two unknowns.

use crate::space::Vector;

/// What is unknown of a nodal vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VectorKind {
    /// All components.
    Free,
    /// The norm along a constant unit vector (components in the body's order).
    Directed(Vector),
    /// An axis of a section that does not turn, `u e + s f` with constant unit vectors `[e, f]` (components in the
    /// body's order): its own norm u and the section's shear s, which is that of the vector `shear`: the section's y
    /// axis, which may be this one, or precedes it. With `u f + s e` for the other axis the section strains and shears in
    /// its plane as it likes and does not turn.
    InPlane {
        /// `[e, f]`.
        axes: [Vector; 2],
        /// Vector that s belongs to.
        shear: usize,
    },
    /// The components that are not held; held ones keep their undeformed value.
    Held([bool; 3]),
    /// Nothing: the vector is a given function of time.
    Prescribed,
}

/// Component, unknown and factor.
type Odd = (usize, usize, f64);

/// The unknowns that a component depends on, each with its factor.
type Dependence = [Option<(usize, f64)>; 2];

/// Numbering of all nodal vectors.
#[derive(Clone, Debug)]
pub struct Layout {
    kinds: Vec<VectorKind>,
    /// First component of every vector in the full arrays, and their length at the end.
    offsets: Vec<usize>,
    map: Vec<Dependence>,
    /// The same, as blocks to copy: first component, first unknown, number; and components with a factor.
    blocks: Vec<[usize; 3]>,
    odd: Vec<Odd>,
    /// For every vector the one whose value is that of all vectors of its node: itself, where it is not shared.
    leaders: Vec<usize>,
    /// Unknowns that two vectors depend on: shears of sections.
    shears: Vec<usize>,
    /// Vector and component of every unknown of vectors.
    origins: Vec<(usize, usize)>,
    unknowns: usize,
}

impl Layout {
    /// Numbers vectors of the given dimensions in order, then `border` more components that are
    /// unknowns themselves: those of free frames. Vectors with one leader (an index of a vector that leads itself) are one and
    /// have the unknowns of the first of them: they must be [`VectorKind::Free`] and of one dimension.
    pub fn new(dimensions: &[usize], kinds: Vec<VectorKind>, leaders: Vec<usize>, border: usize) -> Self {
        let mut offsets = vec![0];
        let mut map: Vec<Dependence> = Vec::new();
        let mut shears = Vec::new();
        // Unknown of the shear of every vector that has one.
        let mut shear_of = vec![0; kinds.len()];
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
            let count = match *kind {
                VectorKind::Free => dimension,
                VectorKind::Directed(_) => 1,
                VectorKind::InPlane { shear, .. } if shear == vector => {
                    shear_of[vector] = unknowns + 1;
                    shears.push(unknowns + 1);
                    2
                }
                VectorKind::InPlane { .. } => 1,
                VectorKind::Held(held) => free_components(&held, dimension),
                VectorKind::Prescribed => 0,
            };
            let own = |component: usize| match *kind {
                VectorKind::Free => [Some((unknowns + component, 1.0)), None],
                VectorKind::Directed(direction) => [Some((unknowns, direction[component])), None],
                VectorKind::InPlane { axes: [e, f], shear } => {
                    let both = [(unknowns, e[component]), (shear_of[shear], f[component])];
                    match both.map(|(unknown, factor)| (factor != 0.0).then_some((unknown, factor))) {
                        [None, only] => [only, None],
                        both => both,
                    }
                }
                VectorKind::Held(held) if held[component] => [None; 2],
                VectorKind::Held(held) => [Some((unknowns + free_components(&held, component), 1.0)), None],
                VectorKind::Prescribed => [None; 2],
            };
            map.extend((0..dimension).map(own));
            match *kind {
                VectorKind::Free | VectorKind::Held(_) => {
                    let free = (0..dimension).filter(|&component| own(component)[0].is_some());
                    origins.extend(free.map(|component| (vector, component)));
                }
                _ => origins.extend((0..count).map(|place| (vector, place))),
            }
            unknowns += count;
            offsets.push(map.len());
        }
        map.extend((unknowns..unknowns + border).map(|unknown| [Some((unknown, 1.0)), None]));
        let (blocks, odd) = in_blocks(&map);
        Self {
            kinds,
            offsets,
            map,
            blocks,
            odd,
            leaders,
            shears,
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

    /// The unknowns that a component depends on, each with its factor: none, one or two.
    #[inline]
    pub fn unknowns_at(&self, component: usize) -> impl Iterator<Item = (usize, f64)> + use<> {
        self.map[component].into_iter().flatten()
    }

    /// What components depend on, for tables with one entry for each: the first unknown of each component, then the
    /// second one of those that have two; and the places of these, counted from 0.
    pub fn dependences(
        &self,
        components: impl Iterator<Item = usize> + Clone,
    ) -> (Vec<Option<(usize, f64)>>, Vec<usize>) {
        let seconds = || components.clone().map(|component| self.map[component][1]);
        let doubled = seconds().enumerate().filter(|(_, second)| second.is_some());
        let doubled = doubled.map(|(place, _)| place).collect();
        let firsts = components.clone().map(|component| self.map[component][0]);
        let all = firsts.chain(seconds().filter(Option::is_some));
        (all.collect(), doubled)
    }

    /// `full = E x` on components that depend on unknowns; the others stay.
    pub fn expand(&self, x: &[f64], full: &mut [f64]) {
        for &[component, unknown, count] in &self.blocks {
            full[component..component + count].copy_from_slice(&x[unknown..unknown + count]);
        }
        for &(component, ..) in &self.odd {
            full[component] = 0.0;
        }
        for &(component, unknown, factor) in &self.odd {
            full[component] += factor * x[unknown];
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
                for (unknown, factor) in self.unknowns_at(component) {
                    x[unknown] += factor * full[component];
                }
            }
        }
        // Their columns of E have the square 2.
        self.shears.iter().for_each(|&shear| x[shear] *= 0.5);
    }

    /// The vector and component of every unknown that belongs to one; component 0 stands for the norm of a directed
    /// one or one in a plane, 1 for its shear, and the first vector for those that are one.
    pub fn origins(&self) -> &[(usize, usize)] {
        &self.origins
    }
}

/// Components that follow each other as their unknowns do, and those with a factor.
fn in_blocks(map: &[Dependence]) -> (Vec<[usize; 3]>, Vec<Odd>) {
    let (mut blocks, mut odd): (Vec<[usize; 3]>, Vec<_>) = (Vec::new(), Vec::new());
    for (component, entries) in map.iter().enumerate() {
        if entries[1].is_some() {
            let both = entries.iter().flatten();
            odd.extend(both.map(|&(unknown, factor)| (component, unknown, factor)));
            continue;
        }
        match (entries[0], blocks.last_mut()) {
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
