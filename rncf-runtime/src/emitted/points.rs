//! Elements with many nodal vectors: the emitted kernels know one integration point as a function of
//! fields, and what is here carries nodal vectors to the fields of a point, and forces and tangents on
//! fields back to nodal vectors.
//!
//! Vectors are grouped by what they interpolate, so that a vector feeds only the fields of its group. In a
//! group there are up to `S` *relative* vectors: positions are differences from the base over the element's
//! length (strains keep their digits far from the frame's origin), all others are taken as they are.
//!
//! ```text
//! x_f  = sum_s N_fs q_s            fields at a point, N: derivatives of the shape functions on the unit element
//! Q_s  = sum_points,f w N_fs g_f
//! K_st = sum_points,fg (w N_fs N_gt) B_fg
//! ```
//!
//! The products `w N_fs N_gt` are constants, worked out at compile time: a tangent is a product of two small
//! matrices for each pair of groups (a *tile*).

/// The nodal vectors of an element: `V` vectors with `D` components in `G` groups of up to `S` relative ones.
#[derive(Clone, Copy, Debug)]
pub struct Vectors<const V: usize, const D: usize, const G: usize, const S: usize> {
    /// The vector that positions are relative to.
    pub base: usize,
    /// Nodal vector of every relative one; `V` where a group has fewer.
    pub nodal: [[usize; S]; G],
    /// Whether a relative vector is a position.
    pub positions: [[bool; S]; G],
}

/// Relative vectors by group.
pub type Relative<const D: usize, const G: usize, const S: usize> = [[[f64; D]; S]; G];

/// `[r * D + c][s * S + t]`: entries of the blocks of relative vectors s and t of a pair of groups.
pub type Tile<const DD: usize, const SS: usize> = [[f64; SS]; DD];

impl<const V: usize, const D: usize, const G: usize, const S: usize> Vectors<V, D, G, S> {
    /// Relative vectors from nodal ones (`V * D` numbers) and the element's length, m.
    #[inline]
    pub fn relative(&self, length: f64, q: &[f64]) -> Relative<D, G, S> {
        let inverse = 1.0 / length;
        let mut relative = [[[0.0; D]; S]; G];
        for g in 0..G {
            for s in 0..S {
                let at = self.nodal[g][s] * D;
                if at == V * D {
                    continue;
                }
                for c in 0..D {
                    relative[g][s][c] = if self.positions[g][s] {
                        inverse * (q[at + c] - q[self.base * D + c])
                    } else {
                        q[at + c]
                    };
                }
            }
        }
        relative
    }

    /// Adds forces on relative vectors to those on nodal ones.
    #[inline]
    pub fn add_force(&self, length: f64, sums: &Relative<D, G, S>, force: &mut [f64]) {
        let inverse = 1.0 / length;
        for g in 0..G {
            for s in 0..S {
                let at = self.nodal[g][s] * D;
                if at == V * D {
                    continue;
                }
                for c in 0..D {
                    if self.positions[g][s] {
                        let value = inverse * sums[g][s][c];
                        force[at + c] += value;
                        force[self.base * D + c] -= value;
                    } else {
                        force[at + c] += sums[g][s][c];
                    }
                }
            }
        }
    }

    /// Adds a symmetric tangent: tiles of the pairs of groups `(0,0), (0,1), .., (1,1), ..`.
    #[inline]
    pub fn add_symmetric<const DD: usize, const SS: usize>(
        &self,
        length: f64,
        tiles: &[Tile<DD, SS>],
        matrix: &mut [f64],
    ) {
        let mut tiles = tiles.iter();
        for g in 0..G {
            for h in g..G {
                if let Some(tile) = tiles.next() {
                    self.add_tile((g, h), length, tile, g != h, matrix);
                }
            }
        }
    }

    /// Adds any tangent: tiles of all pairs of groups, rows first.
    #[inline]
    pub fn add_general<const DD: usize, const SS: usize>(
        &self,
        length: f64,
        tiles: &[Tile<DD, SS>],
        matrix: &mut [f64],
    ) {
        for (index, tile) in tiles.iter().enumerate() {
            self.add_tile((index / G, index % G), length, tile, false, matrix);
        }
    }

    #[inline]
    fn add_tile<const DD: usize, const SS: usize>(
        &self,
        (g, h): (usize, usize),
        length: f64,
        tile: &Tile<DD, SS>,
        mirrored: bool,
        matrix: &mut [f64],
    ) {
        let inverse = 1.0 / length;
        for s in 0..S {
            for t in 0..S {
                let (i, j) = (self.nodal[g][s], self.nodal[h][t]);
                if i == V || j == V {
                    continue;
                }
                let (row, column) = (self.positions[g][s], self.positions[h][t]);
                let scale = if row { inverse } else { 1.0 } * if column { inverse } else { 1.0 };
                let block: [[f64; D]; D] =
                    std::array::from_fn(|r| std::array::from_fn(|c| scale * tile[r * D + c][s * S + t]));
                Self::add_block(i, j, 1.0, &block, mirrored, matrix);
                if row {
                    Self::add_block(self.base, j, -1.0, &block, mirrored, matrix);
                }
                if column {
                    Self::add_block(i, self.base, -1.0, &block, mirrored, matrix);
                }
                if row && column {
                    Self::add_block(self.base, self.base, 1.0, &block, mirrored, matrix);
                }
            }
        }
    }

    #[inline(always)]
    fn add_block(i: usize, j: usize, sign: f64, block: &[[f64; D]; D], mirrored: bool, matrix: &mut [f64]) {
        for r in 0..D {
            let at = (i * D + r) * V * D + j * D;
            let line: &mut [f64] = &mut matrix[at..at + D];
            for c in 0..D {
                line[c] += sign * block[r][c];
            }
        }
        if mirrored {
            for c in 0..D {
                let at = (j * D + c) * V * D + i * D;
                let line: &mut [f64] = &mut matrix[at..at + D];
                for r in 0..D {
                    line[r] += sign * block[r][c];
                }
            }
        }
    }
}

/// An integration rule with `P` points for terms that depend on `F` fields.
#[derive(Clone, Copy, Debug)]
pub struct Rule<const P: usize, const F: usize, const S: usize> {
    /// Group of every field.
    pub groups: [usize; F],
    /// Weights on the unit element.
    pub weights: [f64; P],
    /// For each point and field the derivatives of the relative vectors' shape functions, unit element.
    pub shapes: [[[f64; S]; F]; P],
}

/// Which blocks `B_fg` of a tangent on fields a rule's kernel writes, and what they are multiplied with.
#[derive(Clone, Copy, Debug)]
pub struct Blocks<const P: usize, const SS: usize, const B: usize> {
    products: [[[f64; SS]; B]; P],
    /// Blocks `from..to` of a tile: `(tile, from, to)`.
    tiles: &'static [(usize, usize, usize)],
}

impl<const P: usize, const F: usize, const S: usize> Rule<P, F, S> {
    /// The blocks of fields `pairs`, ordered by tile.
    pub const fn blocks<const SS: usize, const B: usize>(
        &self,
        pairs: &[(usize, usize); B],
        tiles: &'static [(usize, usize, usize)],
    ) -> Blocks<P, SS, B> {
        assert!(
            SS == S * S,
            "a block couples every vector of one group with every one of another"
        );
        let mut products = [[[0.0; SS]; B]; P];
        let mut p = 0;
        while p < P {
            let mut k = 0;
            while k < B {
                let (f, g) = pairs[k];
                let mut st = 0;
                while st < SS {
                    products[p][k][st] = self.weights[p] * self.shapes[p][f][st / S] * self.shapes[p][g][st % S];
                    st += 1;
                }
                k += 1;
            }
            p += 1;
        }
        Blocks { products, tiles }
    }

    /// Fields at a point.
    #[inline(always)]
    pub fn fields<const D: usize, const G: usize>(&self, point: usize, vectors: &Relative<D, G, S>) -> [[f64; D]; F] {
        let mut fields = [[0.0; D]; F];
        for f in 0..F {
            let group = &vectors[self.groups[f]];
            for s in 0..S {
                for c in 0..D {
                    fields[f][c] += self.shapes[point][f][s] * group[s][c];
                }
            }
        }
        fields
    }

    /// Sum over the points of the weight times a density, `density(point, fields)`.
    #[inline]
    pub fn integral<const D: usize, const G: usize>(
        &self,
        vectors: &Relative<D, G, S>,
        mut density: impl FnMut(usize, &[[f64; D]; F]) -> f64,
    ) -> f64 {
        let mut sum = 0.0;
        for p in 0..P {
            sum += self.weights[p] * density(p, &self.fields(p, vectors));
        }
        sum
    }

    /// Adds the forces on relative vectors; `point(point, fields, rates, forces)` writes those on fields.
    #[inline]
    pub fn force<const D: usize, const G: usize>(
        &self,
        vectors: &Relative<D, G, S>,
        rates: &Relative<D, G, S>,
        mut point: impl FnMut(usize, &[[f64; D]; F], &[[f64; D]; F], &mut [[f64; D]; F]),
        sums: &mut Relative<D, G, S>,
    ) {
        for p in 0..P {
            let mut forces = [[0.0; D]; F];
            point(p, &self.fields(p, vectors), &self.fields(p, rates), &mut forces);
            for f in 0..F {
                let group = &mut sums[self.groups[f]];
                for s in 0..S {
                    let factor = self.weights[p] * self.shapes[p][f][s];
                    for c in 0..D {
                        group[s][c] += factor * forces[f][c];
                    }
                }
            }
        }
    }

    /// Adds an undamped tangent to its tiles; `point(point, fields, blocks)` writes that on fields.
    #[inline]
    pub fn tangent<const D: usize, const DD: usize, const G: usize, const SS: usize, const B: usize>(
        &self,
        vectors: &Relative<D, G, S>,
        stiffness: (&Blocks<P, SS, B>, &mut [Tile<DD, SS>]),
        mut point: impl FnMut(usize, &[[f64; D]; F], &mut [[f64; DD]; B]),
    ) {
        let mut blocks = [[[0.0; DD]; B]; P];
        for p in 0..P {
            point(p, &self.fields(p, vectors), &mut blocks[p]);
        }
        stiffness.0.add(&blocks, stiffness.1);
    }

    /// Adds the derivative of a force between two states to its tiles; `point(point, start, end, blocks)` writes that on
    /// fields.
    #[inline]
    pub fn tangent_between<const D: usize, const DD: usize, const G: usize, const SS: usize, const B: usize>(
        &self,
        start: &Relative<D, G, S>,
        end: &Relative<D, G, S>,
        stiffness: (&Blocks<P, SS, B>, &mut [Tile<DD, SS>]),
        mut point: impl FnMut(usize, &[[f64; D]; F], &[[f64; D]; F], &mut [[f64; DD]; B]),
    ) {
        let mut blocks = [[[0.0; DD]; B]; P];
        for p in 0..P {
            point(p, &self.fields(p, start), &self.fields(p, end), &mut blocks[p]);
        }
        stiffness.0.add(&blocks, stiffness.1);
    }

    /// Adds a damped tangent to the tiles of the stiffness and of the damping matrix;
    /// `point(point, fields, rates, stiffness, damping)` writes the blocks on fields.
    #[inline]
    pub fn damped_tangent<
        const D: usize,
        const DD: usize,
        const G: usize,
        const SS: usize,
        const B: usize,
        const C: usize,
    >(
        &self,
        (vectors, rates): (&Relative<D, G, S>, &Relative<D, G, S>),
        stiffness: (&Blocks<P, SS, B>, &mut [Tile<DD, SS>]),
        damping: (&Blocks<P, SS, C>, &mut [Tile<DD, SS>]),
        mut point: impl FnMut(usize, &[[f64; D]; F], &[[f64; D]; F], &mut [[f64; DD]; B], &mut [[f64; DD]; C]),
    ) {
        let (mut blocks, mut viscous) = ([[[0.0; DD]; B]; P], [[[0.0; DD]; C]; P]);
        for p in 0..P {
            let (fields, rates) = (self.fields(p, vectors), self.fields(p, rates));
            point(p, &fields, &rates, &mut blocks[p], &mut viscous[p]);
        }
        stiffness.0.add(&blocks, stiffness.1);
        damping.0.add(&viscous, damping.1);
    }
}

impl<const P: usize, const SS: usize, const B: usize> Blocks<P, SS, B> {
    /// Adds the blocks of all points, times shape functions, to their tiles.
    #[inline]
    fn add<const DD: usize>(&self, blocks: &[[[f64; DD]; B]; P], tiles: &mut [Tile<DD, SS>]) {
        for &(tile, from, to) in self.tiles {
            for rc in 0..DD {
                let mut sum = tiles[tile][rc];
                for p in 0..P {
                    for (block, products) in blocks[p][from..to].iter().zip(&self.products[p][from..to]) {
                        let block = block[rc];
                        for st in 0..SS {
                            sum[st] += block * products[st];
                        }
                    }
                }
                tiles[tile][rc] = sum;
            }
        }
    }
}

/// Particles of a circle or tube of an outer radius (m): y, z (m) and weight (m^2). Two rings of six points, the
/// inner one turned by half a step; exact to degree 5 in the coordinates for a full circle, whose thickness is
/// its radius. The area, the second and the fourth polar moments are exact for every tube.
pub fn round_particles(radius: f64, thickness: f64) -> [[f64; 3]; 12] {
    let inner = ((radius - thickness) / radius).powi(2);
    let area = std::f64::consts::PI * radius * radius * (1.0 - inner);
    std::array::from_fn(|at| {
        let ring = at / 6;
        // Two Gauss points in the square of the distance from the axis.
        let place = 0.5 + [-0.5, 0.5][ring] / 3.0_f64.sqrt();
        let distance = radius * (inner + (1.0 - inner) * place).sqrt();
        let angle = ((at % 6) as f64 + 0.5 * (1 - ring) as f64) * std::f64::consts::FRAC_PI_3;
        [distance * angle.cos(), distance * angle.sin(), area / 12.0]
    })
}

/// Particles of a rectangle with sizes along y and z (m): y, z (m) and weight (m^2), 3 x 3 Gauss points.
pub fn rectangle_particles(sizes: [f64; 2]) -> [[f64; 3]; 9] {
    let place = [-(0.6_f64.sqrt()), 0.0, 0.6_f64.sqrt()];
    let weight = [5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0];
    std::array::from_fn(|at| {
        let (i, j) = (at / 3, at % 3);
        let share = weight[i] * weight[j];
        [
            0.5 * sizes[0] * place[i],
            0.5 * sizes[1] * place[j],
            share * sizes[0] * sizes[1],
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::{rectangle_particles, round_particles};

    fn moment(particles: &[[f64; 3]], y: i32, z: i32) -> f64 {
        particles.iter().map(|p| p[2] * p[0].powi(y) * p[1].powi(z)).sum()
    }

    #[track_caller]
    fn assert_moments(particles: &[[f64; 3]], wanted: &[(i32, i32, f64)], size: f64) {
        for &(y, z, wanted) in wanted {
            let (found, scale) = (moment(particles, y, z), size.powi(2 + y + z));
            assert!(
                (found - wanted).abs() < 1e-14 * scale,
                "{y} {z}: {found} instead of {wanted}"
            );
        }
        for (y, z) in [(1, 0), (0, 1), (1, 1), (3, 0), (1, 2), (2, 1), (3, 1), (5, 0), (2, 3)] {
            let (found, scale) = (moment(particles, y, z), size.powi(2 + y + z));
            assert!(found.abs() < 1e-14 * scale, "{y} {z}: {found} instead of 0");
        }
    }

    #[test]
    fn sections_have_the_moments_of_their_shapes() {
        let pi = std::f64::consts::PI;
        let r: f64 = 0.3;
        let (i, four) = (0.25 * pi * r.powi(4), pi * r.powi(6) / 8.0);
        let circle = [
            (0, 0, pi * r * r),
            (2, 0, i),
            (0, 2, i),
            (4, 0, four),
            (0, 4, four),
            (2, 2, four / 3.0),
        ];
        assert_moments(&round_particles(r, r), &circle, r);
        let (inner, i) = (0.2_f64, 0.25 * pi * (r.powi(4) - 0.2_f64.powi(4)));
        let area = pi * (r * r - inner * inner);
        assert_moments(&round_particles(r, r - inner), &[(0, 0, area), (2, 0, i), (0, 2, i)], r);
        let (b, h) = (0.3_f64, 0.2_f64);
        let wanted = [
            (0, 0, b * h),
            (2, 0, b.powi(3) * h / 12.0),
            (0, 2, b * h.powi(3) / 12.0),
            (4, 0, b.powi(5) * h / 80.0),
            (2, 2, b.powi(3) * h.powi(3) / 144.0),
        ];
        assert_moments(&rectangle_particles([b, h]), &wanted, b);
    }
}
