//! The quadratic pencil of small motions with constraints (THEORY 8.2):
//! `(K + s C + s^2 M) x + C_x^T lambda = 0, C_x x = 0`.

use pulp::Arch;

use crate::linalg::{Lu, Pattern, Scalar, Vectorised, c64, dispatch, norm, normalise, power_of_two, reduce};
use crate::system::Tangent;

/// Round-off of the energy of a motion without stiffness, in units of that of its terms.
const ROUNDED: f64 = 8.0;
/// Round-off of a diagonal entry of the stiffness over one of the mass, relative to the largest such quotient: what
/// has cancelled in the row of a frame that turns with its bodies tells no frequency.
const CANCELLED: f64 = 64.0 * f64::EPSILON;
/// Of a quotient that is negative: what nothing couples grows with its root, which is no shift.
const BESIDE: f64 = 0.7;

/// Part of a motion beside those that are known to have no stiffness, below which it is one of them.
const KNOWN: f64 = 1e-4;

/// Matrices of small motions with constraints, in unknowns and multipliers relative to their sizes; energies in J, or in the largest of the stiffness where that
/// is less.
///
/// Sizes are rounded to powers of two, so that scaling does not round: the frequencies of what is soft
/// beside something very stiff depend on the last digits of the stiffness.
#[derive(Clone, Debug)]
pub struct Pencil {
    pattern: Pattern,
    mass: Vec<f64>,
    damping: Vec<f64>,
    stiffness: Vec<f64>,
    constraint_pattern: Pattern,
    jacobian: Vec<f64>,
    scales: Vec<f64>,
    /// Pattern of `[[K, C_x^T], [C_x, 0]]`, and the places in it of the parts.
    whole: Pattern,
    block: Vec<usize>,
    border: Vec<[usize; 2]>,
    /// Orthonormal motions that are known to have no stiffness.
    still: Vec<Vec<f64>>,
    /// Whether an unknown has damping alone, as a state has.
    is_inert: Vec<bool>,
    /// What cancels in each row of the stiffness where the system turns: the centrifugal forces of all that moves with it.
    centrifugal: Vec<f64>,
}

/// `K x + C_x^T lambda`, `C x` and `M x`, and `C_x x`, each summed with twice the digits.
pub(super) struct Products {
    pub stiffness: Vec<c64>,
    pub damping: Vec<c64>,
    pub mass: Vec<c64>,
    pub constraints: Vec<c64>,
}

impl Pencil {
    /// The pencil of mass, damping and stiffness on `pattern` (n x n) and of `C_x^T` on
    /// `constraint_pattern` (n x m), for equations and unknowns of the given sizes.
    ///
    /// # Panics
    /// If the shapes do not fit: a defect of the caller.
    pub fn new(
        pattern: &Pattern,
        tangent: &Tangent,
        constraint_pattern: &Pattern,
        jacobian: &[f64],
        [equations, sizes]: [&[f64]; 2],
    ) -> Self {
        let (n, m) = (pattern.columns(), constraint_pattern.columns());
        assert_eq!((pattern.rows(), constraint_pattern.rows(), sizes.len()), (n, n, n), "n");
        let [row_scales, scales] =
            [equations, sizes].map(|sizes| sizes.iter().map(|&size| power_of_two(size)).collect::<Vec<f64>>());
        let places: Vec<(usize, usize)> = pattern.places().collect();
        let energies = tangent.stiffness.iter().zip(&places);
        let energies = energies.map(|(value, &(row, column))| (value * row_scales[row] * scales[column]).abs());
        // Beside constraints, which are relative to themselves, the stiffness of a small machine in J is nothing.
        let unit = match energies.fold(0.0, f64::max) {
            largest if largest > 0.0 && largest < 1.0 => 1.0 / power_of_two(largest),
            _ => 1.0,
        };
        let scaled = |values: &[f64]| {
            let parts = values.iter().zip(&places);
            parts
                .map(|(value, &(row, column))| unit * (value * row_scales[row] * scales[column]))
                .collect()
        };
        let border: Vec<(usize, usize)> = constraint_pattern.places().collect();
        let mut rows: Vec<f64> = jacobian
            .iter()
            .zip(&border)
            .map(|(value, &(row, _))| value * scales[row])
            .collect();
        let mut largest = vec![0.0f64; m];
        for (value, &(_, constraint)) in rows.iter().zip(&border) {
            largest[constraint] = largest[constraint].max(value.abs());
        }
        for (value, &(_, constraint)) in rows.iter_mut().zip(&border) {
            *value /= power_of_two(largest[constraint]);
        }
        let both = border.iter().flat_map(|&(row, j)| [(row, n + j), (n + j, row)]);
        let whole = Pattern::new(n + m, n + m, places.iter().copied().chain(both));
        let place = |row, column| whole.find(row, column).expect("the whole pattern holds its parts");
        let own = |values: &[f64], index: usize| pattern.find(index, index).map_or(0.0, |entry| values[entry]);
        let is_inert = |index| own(&tangent.mass, index) == 0.0 && own(&tangent.damping, index) != 0.0;
        Self {
            is_inert: (0..n).map(is_inert).collect(),
            mass: scaled(&tangent.mass),
            damping: scaled(&tangent.damping),
            stiffness: scaled(&tangent.stiffness),
            jacobian: rows,
            block: places.iter().map(|&(row, column)| place(row, column)).collect(),
            border: border
                .iter()
                .map(|&(row, j)| [place(row, n + j), place(n + j, row)])
                .collect(),
            pattern: pattern.clone(),
            constraint_pattern: constraint_pattern.clone(),
            scales,
            whole,
            still: Vec::new(),
            centrifugal: vec![0.0; n],
        }
    }

    /// The same of a system that turns, rad/s.
    pub(super) fn turning(mut self, speed: f64) -> Self {
        let mut heaviest = vec![0.0f64; self.unknowns()];
        let diagonal: Vec<f64> = (0..self.unknowns())
            .map(|index| {
                self.pattern
                    .find(index, index)
                    .map_or(0.0, |entry| self.mass[entry].abs())
            })
            .collect();
        for (row, column) in self.pattern.places() {
            heaviest[row] = heaviest[row].max(diagonal[column]);
        }
        self.centrifugal = heaviest.into_iter().map(|mass| speed * speed * mass).collect();
        self
    }

    /// Round-off of the stiffness along each unknown, of what turns.
    pub(super) fn cancelled(&self) -> impl Iterator<Item = f64> + '_ {
        self.centrifugal.iter().map(|force| ROUNDED * f64::EPSILON * force)
    }

    /// The same with directions of the unknowns that are known to have no stiffness.
    pub(super) fn without_stiffness_along(mut self, directions: Vec<Vec<f64>>) -> Self {
        self.still = orthonormal(directions, &self.scales);
        self
    }

    /// Number of unknowns n.
    pub fn unknowns(&self) -> usize {
        self.pattern.columns()
    }

    /// Number of constraints m.
    pub fn constraints(&self) -> usize {
        self.constraint_pattern.columns()
    }

    /// Whether all entries are numbers.
    pub(super) fn is_finite(&self) -> bool {
        let all = [&self.mass, &self.damping, &self.stiffness, &self.jacobian];
        all.into_iter().flatten().all(|value| value.is_finite())
    }

    /// Sizes of the unknowns as the pencil takes them: powers of two.
    pub(super) fn scales(&self) -> &[f64] {
        &self.scales
    }

    /// An analysed factorization of the whole matrix.
    pub(super) fn lu<T: Scalar>(&self) -> Lu<T> {
        Lu::new(&self.whole)
    }

    /// Values of `[[K + s C + s^2 M, C_x^T], [C_x, 0]]`.
    pub(super) fn at<T: Scalar>(&self, s: T) -> Vec<T> {
        let mut values = vec![T::default(); self.whole.entries()];
        for (entry, &place) in self.block.iter().enumerate() {
            let dynamic = s.times(self.damping[entry]) + (s * s).times(self.mass[entry]);
            values[place] = T::real(self.stiffness[entry]) + dynamic;
        }
        for (&value, &[upper, lower]) in self.jacobian.iter().zip(&self.border) {
            values[upper] = T::real(value);
            values[lower] = T::real(value);
        }
        values
    }

    /// The same without C, but for what has nothing else.
    pub(super) fn without_damping(&self, s: c64) -> Vec<c64> {
        let mut values = self.at(s);
        for ((row, _), (&damping, &place)) in self.pattern.places().zip(self.damping.iter().zip(&self.block)) {
            if !self.is_inert[row] {
                values[place] -= s * damping;
            }
        }
        values
    }

    /// `M x`, and `C x` of what has nothing else.
    pub(super) fn inertia(&self, x: &[c64]) -> Vec<c64> {
        let Products { mass, damping, .. } = self.products(x, &[]);
        let both = self.is_inert.iter().zip(mass.into_iter().zip(damping));
        both.map(|(&is_inert, (mass, damping))| if is_inert { damping } else { mass })
            .collect()
    }

    /// What `right` has beside the product of the whole matrix of these `values` and `x`, each row summed with twice the digits.
    pub(super) fn rest(&self, values: &[f64], x: &[f64], right: &[f64]) -> Vec<f64> {
        let x: Vec<c64> = x.iter().map(|&value| c64::new(value, 0.0)).collect();
        let mut sums = Sums::new(x.len());
        sums.add(&self.whole, values, &x);
        let rows = right.iter().zip(&sums.re);
        rows.map(|(right, sum)| (right - sum[0]) - sum[1]).collect()
    }

    /// `(K + s C + s^2 M) x + C_x^T lambda` and `C_x x` at the s next to `s` that fits the vector,
    /// `x^H (K + s C + s^2 M) x = 0`, and that s.
    pub(super) fn residual(&self, s: c64, x: &[c64], lambda: &[c64]) -> (Vec<c64>, c64) {
        let products = self.products(x, lambda);
        let along = |image: &[c64]| x.iter().zip(image).map(|(x, image)| x.conj() * image).sum::<c64>();
        let parts = [&products.mass, &products.damping, &products.stiffness].map(|image| along(image));
        let root = nearest_root(parts, s);
        (products.residual(root), root)
    }

    /// The same at `s` itself.
    pub(super) fn residual_at(&self, s: c64, x: &[c64], lambda: &[c64]) -> (Vec<c64>, c64) {
        (self.products(x, lambda).residual(s), s)
    }

    /// `out += alpha M x`
    pub(super) fn add_mass(&self, alpha: f64, x: &[f64], out: &mut [f64]) {
        self.pattern.multiply_add(alpha, &self.mass, x, out);
    }

    /// `out += C x`
    pub(super) fn add_damping(&self, x: &[f64], out: &mut [f64]) {
        self.pattern.multiply_add(1.0, &self.damping, x, out);
    }

    /// Full M, C and K, rows first.
    pub(super) fn dense(&self) -> [Vec<f64>; 3] {
        let n = self.unknowns();
        [&self.mass, &self.damping, &self.stiffness].map(|values| {
            let mut full = vec![0.0; n * n];
            for ((row, column), value) in self.pattern.places().zip(values) {
                full[row * n + column] = *value;
            }
            full
        })
    }

    /// Columns of `C_x^T`.
    pub(super) fn constraint_rows(&self) -> Vec<Vec<f64>> {
        let mut rows = vec![vec![0.0; self.unknowns()]; self.constraints()];
        for ((row, constraint), value) in self.constraint_pattern.places().zip(&self.jacobian) {
            rows[constraint][row] = *value;
        }
        rows
    }

    /// Lowest quotient of diagonal entries of stiffness and mass, as a frequency: not below the lowest
    /// one of a stiff system by orders, to begin with. Quotients that are round-off beside the largest one do not
    /// count: at a shift that low the inverse sees nothing but what does not move at all.
    pub(super) fn guess(&self) -> f64 {
        let diagonal =
            |values: &[f64], index: usize| self.pattern.find(index, index).map_or(0.0, |entry| values[entry]);
        let quotient = |index: usize| {
            let [signed, c, m] = [&self.stiffness, &self.damping, &self.mass].map(|values| diagonal(values, index));
            let (k, c, m) = (signed.abs(), c.abs(), m.abs());
            let frequency = if k > 0.0 { (k / m).sqrt() } else { c / m };
            let frequency = if signed < 0.0 { BESIDE * frequency } else { frequency };
            (frequency > 0.0 && frequency.is_finite()).then_some(frequency)
        };
        let quotients: Vec<f64> = (0..self.unknowns()).filter_map(quotient).collect();
        let least = CANCELLED.sqrt() * quotients.iter().copied().fold(0.0, f64::max);
        let told = quotients.into_iter().filter(|&frequency| frequency > least);
        let lowest = told.fold(f64::INFINITY, f64::min);
        if lowest.is_finite() { lowest } else { 1.0 }
    }

    /// Whether `x^H K x` is what motions slower than `lowest` have, or the round-off of the entries of K: beside a
    /// stiff part that alone is the energy of a motion without stiffness.
    pub(super) fn is_still(&self, x: &[c64], lowest: f64) -> bool {
        if !self.still.is_empty() && self.beside_known(x.to_vec()).is_none() {
            return true;
        }
        let products = self.products(x, &[]);
        let along = |image: &[c64]| x.iter().zip(image).map(|(x, image)| x.conj() * image).sum::<c64>();
        let inertia = lowest * lowest * along(&products.mass).norm();
        let cancelled: f64 = x
            .iter()
            .zip(self.cancelled())
            .map(|(x, size)| x.norm_sqr() * size)
            .sum();
        along(&products.stiffness).norm() <= inertia + cancelled + ROUNDED * f64::EPSILON * self.terms(x)
    }

    /// The motions that are known to have no stiffness.
    pub(super) fn known_still(&self) -> impl Iterator<Item = Vec<c64>> {
        let complex = |value: &f64| c64::new(*value, 0.0);
        self.still
            .iter()
            .map(move |motion| motion.iter().map(complex).collect())
    }

    /// What a motion is beside those that are known to have no stiffness; `None` where it is made of them.
    pub(super) fn beside_known(&self, x: Vec<c64>) -> Option<Vec<c64>> {
        let mut re: Vec<f64> = x.iter().map(|value| value.re).collect();
        let mut im: Vec<f64> = x.iter().map(|value| value.im).collect();
        let whole = norm(&re).hypot(norm(&im));
        let rest = reduce(&mut re, &self.still).hypot(reduce(&mut im, &self.still));
        (rest > KNOWN * whole).then(|| re.into_iter().zip(im).map(|(re, im)| c64::new(re, im)).collect())
    }

    /// `|x|^T |K| |x|`
    fn terms(&self, x: &[c64]) -> f64 {
        let sizes: Vec<f64> = x.iter().map(|value| value.norm()).collect();
        let parts = self.pattern.places().zip(&self.stiffness);
        parts
            .map(|((row, column), value)| sizes[row] * value.abs() * sizes[column])
            .sum()
    }

    /// All products with a vector and multipliers (none: zeros).
    pub(super) fn products(&self, x: &[c64], lambda: &[c64]) -> Products {
        let n = self.unknowns();
        let mut stiffness = Sums::new(n);
        stiffness.add(&self.pattern, &self.stiffness, x);
        if !lambda.is_empty() {
            stiffness.add(&self.constraint_pattern, &self.jacobian, lambda);
        }
        let of = |values: &[f64]| {
            let mut sums = Sums::new(n);
            sums.add(&self.pattern, values, x);
            sums.rounded()
        };
        let mut constraints = vec![c64::default(); self.constraints()];
        for ((row, constraint), &value) in self.constraint_pattern.places().zip(&self.jacobian) {
            constraints[constraint] += x[row].times(value);
        }
        Products {
            stiffness: stiffness.rounded(),
            damping: of(&self.damping),
            mass: of(&self.mass),
            constraints,
        }
    }

    /// Largest residual of `(K + s C + s^2 M) x + C_x^T lambda`, row by row relative to its terms with all
    /// unknowns as large as the largest of `x`.
    pub(super) fn backward_error(&self, s: c64, residual: &[c64], x: &[c64], lambda: &[c64]) -> f64 {
        let speed = s.norm();
        let largest = x.iter().map(|value| value.norm()).fold(0.0, f64::max);
        let mut terms = vec![0.0; self.unknowns()];
        for (entry, (row, _)) in self.pattern.places().enumerate() {
            let dynamic = speed * (self.damping[entry].abs() + speed * self.mass[entry].abs());
            terms[row] += largest * (self.stiffness[entry].abs() + dynamic);
        }
        for ((row, constraint), value) in self.constraint_pattern.places().zip(&self.jacobian) {
            terms[row] += value.abs() * lambda[constraint].norm();
        }
        let relative = residual.iter().zip(&terms).map(|(rest, term)| rest.norm() / term);
        relative.filter(|error| !error.is_nan()).fold(0.0, f64::max)
    }
}

/// What directions span, in unknowns relative to sizes.
pub(super) fn orthonormal(directions: Vec<Vec<f64>>, sizes: &[f64]) -> Vec<Vec<f64>> {
    let mut found: Vec<Vec<f64>> = Vec::new();
    for mut direction in directions {
        direction.iter_mut().zip(sizes).for_each(|(value, size)| *value /= size);
        normalise(&mut direction);
        if reduce(&mut direction, &found) > KNOWN {
            normalise(&mut direction);
            found.push(direction);
        }
    }
    found
}

impl Products {
    fn residual(&self, s: c64) -> Vec<c64> {
        let dynamic = |i: usize| self.stiffness[i] + s * (self.damping[i] + s * self.mass[i]);
        let rows = (0..self.stiffness.len()).map(dynamic);
        rows.chain(self.constraints.iter().copied()).collect()
    }
}

/// The root next to `s` of `m s^2 + c s + k`; `s` where there is none.
fn nearest_root([m, c, k]: [c64; 3], s: c64) -> c64 {
    let root = (c * c - 4.0 * m * k).sqrt();
    let sum = if (c.conj() * root).re >= 0.0 {
        c + root
    } else {
        c - root
    };
    let half = -0.5 * sum;
    let candidates = [half / m, k / half];
    let finite = candidates.into_iter().filter(|root| root.is_finite());
    finite
        .min_by(|a, b| (a - s).norm().total_cmp(&(b - s).norm()))
        .unwrap_or(s)
}

/// Sums of products in twice the working precision: value and rest, real and imaginary parts.
struct Sums {
    re: Vec<[f64; 2]>,
    im: Vec<[f64; 2]>,
}

impl Sums {
    fn new(count: usize) -> Self {
        Self {
            re: vec![[0.0; 2]; count],
            im: vec![[0.0; 2]; count],
        }
    }

    /// Adds `A x`.
    fn add(&mut self, pattern: &Pattern, values: &[f64], x: &[c64]) {
        dispatch(Arch::new(), Added(self, pattern, values, x));
    }

    fn rounded(self) -> Vec<c64> {
        let parts = self.re.into_iter().zip(self.im);
        parts.map(|(re, im)| c64::new(re[0] + re[1], im[0] + im[1])).collect()
    }
}

struct Added<'a>(&'a mut Sums, &'a Pattern, &'a [f64], &'a [c64]);

impl Vectorised for Added<'_> {
    type Output = ();

    /// Where products and sums can be fused, the errors of products cost one instruction instead of a call: the same bits.
    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(sums, pattern, values, x) = self;
        for column in 0..pattern.columns() {
            let x = x[column];
            for entry in pattern.starts()[column]..pattern.starts()[column + 1] {
                let (row, value) = (pattern.indices()[entry], values[entry]);
                if value != 0.0 {
                    accumulate(&mut sums.re[row], value, x.re);
                    accumulate(&mut sums.im[row], value, x.im);
                }
            }
        }
    }
}

/// `sum += a b` with the rounding errors of product and sum kept.
#[inline(always)]
fn accumulate(sum: &mut [f64; 2], a: f64, b: f64) {
    let product = a * b;
    let rest = a.mul_add(b, -product);
    let total = sum[0] + product;
    let back = total - sum[0];
    let lost = (sum[0] - (total - back)) + (product - back);
    *sum = [total, sum[1] + (lost + rest)];
}
