//! Loads per length of four elements side by side: what they do to nodal vectors comes from the emitted kernels,
//! what they do to the frame follows from it, `F = c_a Q^a`, `M = q_a x Q^a`, `dM = q_a x dQ^a + dq_a x Q^a`.

use crate::emitted::lanes::{Kernel, Lanes as Instructions, Real, run};
use crate::emitted::{LANES, MAX_SIZE};
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::numbering::units::Lanes;
use crate::scene::pieces::density::{Batches, ROWS};

impl MeshScene {
    /// Evaluates a unit into `result`, with derivatives where there is room for them; `values` are those of all
    /// densities, those of one next to each other.
    pub(crate) fn evaluate_density(&self, of: &Batches, unit: usize, values: &[Vec<f64>], result: &mut [Lanes]) {
        let (n, k) = (of.units.size, of.values);
        let lanes = of.units.all(unit);
        let elements = lanes.map(|(density, element)| (self.density_body(density), element));
        let (own_values, rest) = result.split_at_mut(k);
        for (lane, &(density, _)) in lanes.iter().enumerate() {
            for (to, from) in own_values.iter_mut().zip(&values[density]) {
                to[lane] = *from;
            }
        }
        let (q, rest) = rest.split_at_mut(n);
        let body = &self.bodies[elements[0].0];
        if self.axes_of(body).is_some() {
            for (lane, &(body, element)) in elements.iter().enumerate() {
                let own = self.in_body_axes(&self.bodies[body], element);
                q.iter_mut().zip(own).for_each(|(to, from)| to[lane] = from);
            }
        } else {
            of.units.gather(unit, &self.buffers.q, q);
        }
        rest.fill([0.0; LANES]);
        let (force, rest) = rest.split_at_mut(n);
        let (rows, rest) = rest.split_at_mut(ROWS);
        let (values, q, density) = (&*own_values, &*q, lanes[0].0);
        self.parts.density_force4(density, &elements, values, q, force);
        let carried = self.frames.free_of[body.frame].map(|_| Carried::new(body));
        let (mut by_q, mut by_values, mut of_derivatives) = (&mut [][..], &mut [][..], &mut [][..]);
        if !rest.is_empty() {
            let rest = rest.split_at_mut(n * n);
            by_q = rest.0;
            (by_values, of_derivatives) = rest.1.split_at_mut(n * k);
            self.parts
                .density_tangent4(density, &elements, values, q, by_q, by_values);
        }
        if let Some(carried) = carried {
            let from = Source {
                carried,
                q,
                force,
                by_q,
                by_values,
            };
            from.fill(rows, of_derivatives);
        }
    }

    fn density_body(&self, density: usize) -> usize {
        self.distributed.all[density].spec.body
    }
}

/// What is known of an element's vectors.
#[derive(Clone, Copy)]
struct Carried {
    axes: &'static [usize],
    /// Which vectors are positions.
    positions: [bool; MAX_SIZE],
}

impl Carried {
    fn new(body: &MeshBody) -> Self {
        let mut positions = [false; MAX_SIZE];
        for (position, nodal) in positions.iter_mut().zip(body.spec.nodal) {
            *position = nodal.is_position();
        }
        Self {
            axes: body.spec.axes,
            positions,
        }
    }

    /// Components of vector `a` of `d` in three axes.
    #[inline(always)]
    fn vector<R: Real>(&self, zero: R, d: usize, a: usize, component: impl Fn(usize) -> R) -> [R; 3] {
        if d == 3 {
            return [component(3 * a), component(3 * a + 1), component(3 * a + 2)];
        }
        let mut vector = [zero; 3];
        for (c, &axis) in self.axes.iter().enumerate() {
            vector[axis] = component(d * a + c);
        }
        vector
    }

    /// Force and moment of generalised forces on vectors of `d` components, `n` in all.
    #[inline(always)]
    fn rows<R: Real>(
        &self,
        zero: R,
        (n, d): (usize, usize),
        q: impl Fn(usize) -> R,
        force: impl Fn(usize) -> R,
    ) -> [R; ROWS] {
        let mut rows = [zero; ROWS];
        for a in 0..n / d {
            let at = self.vector(zero, d, a, &q);
            let f = self.vector(zero, d, a, &force);
            if self.positions[a] {
                for i in 0..3 {
                    rows[i] = rows[i] + f[i];
                }
            }
            rows[3] = rows[3] + (at[1] * f[2] - at[2] * f[1]);
            rows[4] = rows[4] + (at[2] * f[0] - at[0] * f[2]);
            rows[5] = rows[5] + (at[0] * f[1] - at[1] * f[0]);
        }
        rows
    }
}

/// What force and moment on the frame follow from.
#[derive(Clone, Copy)]
struct Source<'a> {
    carried: Carried,
    q: &'a [Lanes],
    force: &'a [Lanes],
    by_q: &'a [Lanes],
    by_values: &'a [Lanes],
}

impl Source<'_> {
    fn fill(self, rows: &mut [Lanes], of_derivatives: &mut [Lanes]) {
        let all = Fill {
            from: self,
            rows: &mut *rows,
            of_derivatives: &mut *of_derivatives,
        };
        if !run(all) {
            for lane in 0..LANES {
                let own = |values: &Lanes| values[lane];
                self.each(0.0, own, |i, value| rows[i][lane] += value);
                self.each_derivative(0.0, own, |i, value| of_derivatives[i][lane] += value);
            }
        }
    }

    #[inline(always)]
    fn each<R: Real>(&self, zero: R, load: impl Fn(&Lanes) -> R + Copy, put: impl FnMut(usize, R)) {
        match (self.q.len(), self.carried.axes.len()) {
            // Sizes of the library's elements are constants of the code.
            (12, 3) => self.each_sized((12, 3), zero, load, put),
            sizes => self.each_sized(sizes, zero, load, put),
        }
    }

    #[inline(always)]
    fn each_sized<R: Real>(
        &self,
        (n, d): (usize, usize),
        zero: R,
        load: impl Fn(&Lanes) -> R + Copy,
        mut put: impl FnMut(usize, R),
    ) {
        let (q, force) = (&self.q[..n], &self.force[..n]);
        let rows = self.carried.rows(zero, (n, d), |i| load(&q[i]), |i| load(&force[i]));
        rows.into_iter().enumerate().for_each(|(i, value)| put(i, value));
    }

    #[inline(always)]
    fn each_derivative<R: Real>(&self, zero: R, load: impl Fn(&Lanes) -> R + Copy, put: impl FnMut(usize, R)) {
        if self.by_q.is_empty() {
            return;
        }
        match (self.q.len(), self.carried.axes.len()) {
            (12, 3) => self.each_derivative_sized((12, 3), zero, load, put),
            sizes => self.each_derivative_sized(sizes, zero, load, put),
        }
    }

    #[inline(always)]
    fn each_derivative_sized<R: Real>(
        &self,
        (n, d): (usize, usize),
        zero: R,
        load: impl Fn(&Lanes) -> R + Copy,
        mut put: impl FnMut(usize, R),
    ) {
        let (q, force, by_q) = (&self.q[..n], &self.force[..n], &self.by_q[..n * n]);
        let q = |i: usize| load(&q[i]);
        for column in 0..n {
            let by_q = |i: usize| load(&by_q[i * n + column]);
            let mut rows = self.carried.rows(zero, (n, d), q, by_q);
            let f = self.carried.vector(zero, d, column / d, |i| load(&force[i]));
            match self.carried.axes[column % d] {
                0 => (rows[4], rows[5]) = (rows[4] - f[2], rows[5] + f[1]),
                1 => (rows[3], rows[5]) = (rows[3] + f[2], rows[5] - f[0]),
                _ => (rows[3], rows[4]) = (rows[3] - f[1], rows[4] + f[0]),
            }
            for (row, value) in rows.into_iter().enumerate() {
                put(row * n + column, value);
            }
        }
        let k = self.by_values.len() / n;
        for column in 0..k {
            let by_values = |i: usize| load(&self.by_values[i * k + column]);
            let rows = self.carried.rows(zero, (n, d), q, by_values);
            for (row, value) in rows.into_iter().enumerate() {
                put(ROWS * n + row * k + column, value);
            }
        }
    }
}

struct Fill<'a, 'b> {
    from: Source<'a>,
    rows: &'b mut [Lanes],
    of_derivatives: &'b mut [Lanes],
}

impl Kernel for Fill<'_, '_> {
    #[inline(always)]
    fn run<L: Instructions>(self, lanes: L) {
        let Self {
            from,
            rows,
            of_derivatives,
        } = self;
        let zero = lanes.load([0.0; LANES]);
        let load = |values: &Lanes| lanes.load(*values);
        from.each(zero, load, |i, value| add::<L::Real>(&mut rows[i], value));
        from.each_derivative(zero, load, |i, value| add::<L::Real>(&mut of_derivatives[i], value));
    }
}

#[inline(always)]
fn add<R: Real>(sum: &mut R::Cell, value: R) {
    *sum += value;
}
