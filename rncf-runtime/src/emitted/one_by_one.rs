//! Up to four elements, one after the other: for kernels that are not written for lanes, and where there are fewer.

use super::body_spec::MAX_SIZE;
use super::lanes::LANES;
use super::parts::Parts;

/// One lane of an element's components.
fn lane_of(all: &[[f64; LANES]], lane: usize) -> [f64; MAX_SIZE] {
    let mut own = [0.0; MAX_SIZE];
    for (value, lanes) in own.iter_mut().zip(all) {
        *value = lanes[lane];
    }
    own
}

/// [`Parts::elastic_force4`] by [`Parts::elastic_force`].
pub fn elastic_force_one_by_one<P: Parts + ?Sized>(
    parts: &P,
    elements: &[(usize, usize)],
    q: &[[f64; LANES]],
    v: &[[f64; LANES]],
    force: &mut [[f64; LANES]],
) {
    let size = q.len();
    let mut own = [0.0; MAX_SIZE];
    for (lane, &(body, element)) in elements.iter().enumerate() {
        let [q, v] = [q, v].map(|all| lane_of(all, lane));
        own[..size].fill(0.0);
        parts.elastic_force(body, element, &q[..size], &v[..size], &mut own[..size]);
        for (sum, value) in force.iter_mut().zip(&own) {
            sum[lane] += value;
        }
    }
}

/// [`Parts::elastic_tangent4`] by [`Parts::elastic_tangent`].
pub fn elastic_tangent_one_by_one<P: Parts + ?Sized>(
    parts: &P,
    elements: &[(usize, usize)],
    q: &[[f64; LANES]],
    v: &[[f64; LANES]],
    stiffness: &mut [[f64; LANES]],
    damping: &mut [[f64; LANES]],
) {
    let size = q.len();
    let mut own = [0.0; 2 * MAX_SIZE * MAX_SIZE];
    for (lane, &(body, element)) in elements.iter().enumerate() {
        let [q, v] = [q, v].map(|all| lane_of(all, lane));
        own[..2 * size * size].fill(0.0);
        let (k, c) = own[..2 * size * size].split_at_mut(size * size);
        parts.elastic_tangent(body, element, &q[..size], &v[..size], k, c);
        for (sums, values) in [(&mut *stiffness, k), (&mut *damping, c)] {
            for (sum, value) in sums.iter_mut().zip(values) {
                sum[lane] += *value;
            }
        }
    }
}

/// One of four elements' numbers.
pub fn lane<const N: usize>(all: &[[f64; LANES]], lane: usize) -> [f64; N] {
    std::array::from_fn(|place| all[place][lane])
}

/// Adds the numbers of one of four elements.
pub fn add_lane(all: &mut [[f64; LANES]], lane: usize, own: &[f64]) {
    for (sum, value) in all.iter_mut().zip(own) {
        sum[lane] += value;
    }
}
