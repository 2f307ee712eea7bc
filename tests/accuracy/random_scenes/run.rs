//! Runs of a scene, and how far two runs are apart.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, Stop};

use super::tree::Matrix;
use super::write::{Copy, Nature, Observed, Quantity};

/// Builds the scene of a compiled text from the values of its params.
pub type Maker = fn(&[f64], Formulation, Joints) -> Result<Box<dyn Scene>, String>;

/// The maker of a model.
pub fn maker<M: Model>(values: &[f64], formulation: Formulation, joints: Joints) -> Result<Box<dyn Scene>, String> {
    let mut model = M::default();
    for (index, value) in values.iter().enumerate() {
        model.set(index, *value);
    }
    model.build(formulation, joints).map_err(|error| error.to_string())
}

/// Axis of each column of each output: `None` for numbers.
pub type Columns = Vec<Vec<Option<usize>>>;

/// The columns of a model.
pub fn columns<M: Model>() -> Columns {
    let axis = |name: &&str| ["x", "y", "z"].iter().position(|axis| axis == name);
    M::outputs()
        .iter()
        .map(|output| {
            if output.components.is_empty() {
                vec![None]
            } else {
                output.components.iter().map(axis).collect()
            }
        })
        .collect()
}

/// A row of a model by output, each a vector or a number in the first component.
pub fn by_output(columns: &Columns, row: &[f64]) -> Vec<[f64; 3]> {
    let mut at = 0;
    columns
        .iter()
        .map(|axes| {
            let mut value = [0.0; 3];
            for axis in axes {
                value[axis.unwrap_or(0)] = row[at];
                at += 1;
            }
            value
        })
        .collect()
}

/// One way to run a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    pub formulation: Formulation,
    pub joints: Joints,
    pub method: Method,
    pub rtol: f64,
}

/// What came out: outputs at even times, each a vector or a number in the first component.
#[derive(Clone, Debug, Default)]
pub struct History {
    /// By time, then by output.
    pub rows: Vec<Vec<[f64; 3]>>,
    /// How long it took, s.
    pub span: f64,
    /// By output with a rate: its change over the run less the integral of the rate.
    pub drift: Vec<(usize, f64)>,
    /// Largest change of the energy over the largest kinetic scale, where it is kept.
    pub energy: Option<(f64, f64)>,
    pub steps: u64,
    pub failures: u64,
    pub notes: Vec<String>,
}

/// Nodes and weights of Radau's quadrature of order 5 on [0, 1].
fn radau() -> [(f64, f64); 3] {
    let root = 6.0f64.sqrt();
    [
        ((4.0 - root) / 10.0, (16.0 - root) / 36.0),
        ((4.0 + root) / 10.0, (16.0 + root) / 36.0),
        (1.0, 1.0 / 9.0),
    ]
}

/// Runs a scene; at most `most` steps.
///
/// # Errors
/// What the program says, or that it took too many steps.
pub fn run(
    scene: &mut dyn Scene,
    way: Way,
    t_end: f64,
    rows: usize,
    most: u64,
    (observed, columns): (&[Observed], &Columns),
) -> Result<History, String> {
    let read = |scene: &mut dyn Scene, state: &State| -> Vec<[f64; 3]> {
        let mut flat = vec![0.0; scene.output_columns()];
        scene.outputs(state, &mut flat);
        by_output(columns, &flat)
    };
    let rates: Vec<(usize, usize)> = observed
        .iter()
        .enumerate()
        .filter_map(|(index, output)| {
            let rate = output.rate.as_ref()?;
            Some((index, observed.iter().position(|other| other.name == *rate)?))
        })
        .collect();
    let start = scene.rest(0.0);
    let options = Options {
        rtol: way.rtol,
        ..Options::default()
    };
    // The integrator borrows one scene; outputs are read from another of the same model through states.
    let mut history = History {
        span: t_end,
        ..History::default()
    };
    let (mut energies, mut kinetic) = (Vec::new(), 0.0f64);
    let mut states = Vec::new();
    let mut stages: Vec<(f64, State)> = Vec::new();
    let mut ends: Vec<State> = Vec::new();
    {
        let mut integrator =
            Integrator::new(&mut *scene, start, t_end, way.method, options).map_err(|error| error.to_string())?;
        states.push(integrator.state().clone());
        ends.push(integrator.state().clone());
        let mut next = 1;
        while next < rows {
            let stop = integrator.step().map_err(|error| error.to_string())?;
            let (before, now) = (integrator.previous_time(), integrator.state().clone());
            if integrator.statistics().steps + integrator.statistics().rejected_steps > most {
                return Err(format!("more than {most} steps, now at {:.3e} s", now.t));
            }
            if now.t > before {
                for (node, weight) in radau() {
                    let mut state = now.clone();
                    if node < 1.0 {
                        integrator.interpolate(before + node * (now.t - before), &mut state);
                    }
                    stages.push((weight * (now.t - before), state));
                }
            }
            while next < rows {
                let t = t_end * next as f64 / (rows - 1) as f64;
                if t > now.t * (1.0 + 1e-12) {
                    break;
                }
                let mut state = now.clone();
                if (t - now.t).abs() > 1e-12 * t_end {
                    integrator.interpolate(t, &mut state);
                }
                states.push(state);
                next += 1;
            }
            if stop == Stop::End {
                break;
            }
        }
        ends.push(integrator.state().clone());
        let statistics = integrator.statistics();
        history.steps = statistics.steps;
        history.failures = statistics.rejected_by_newton;
    }
    let mut integral = vec![[0.0; 3]; rates.len()];
    // The last stages may overlap with nothing: each step has its own three.
    for (weight, state) in &stages {
        let row = read(&mut *scene, state);
        for (sum, (_, rate)) in integral.iter_mut().zip(&rates) {
            for k in 0..3 {
                sum[k] += weight * row[*rate][k];
            }
        }
    }
    let (first, last) = (read(&mut *scene, &ends[0]), read(&mut *scene, &ends[1]));
    for (sum, (position, _)) in integral.iter().zip(&rates) {
        let off = (0..3)
            .map(|k| (last[*position][k] - first[*position][k] - sum[k]).abs())
            .fold(0.0, f64::max);
        history.drift.push((*position, off));
    }
    for state in &states {
        history.rows.push(read(&mut *scene, state));
        if let Some(energy) = scene.energy(state) {
            energies.push(energy);
        }
        kinetic = kinetic.max(kinetic_energy(scene, state));
    }
    if let (Some(first), true) = (energies.first().copied(), energies.len() == states.len()) {
        let most = energies.iter().map(|energy| (energy - first).abs()).fold(0.0, f64::max);
        history.energy = Some((most, kinetic));
    }
    history.notes = scene
        .warnings(&ends[1])
        .into_iter()
        .map(|warning| warning.text)
        .collect();
    Ok(history)
}

/// A scale of energies: `v M v / 2` of the unknowns.
fn kinetic_energy(scene: &mut dyn Scene, state: &State) -> f64 {
    let mut values = vec![0.0; scene.pattern().entries()];
    scene.mass(state, &mut values);
    let mut momentum = vec![0.0; scene.unknowns()];
    scene.pattern().multiply_add(1.0, &values, &state.v, &mut momentum);
    let sum: f64 = momentum.iter().zip(&state.v).map(|(p, v)| 0.5 * p * v).sum();
    sum.abs()
}

/// Forces below this, N, are round-off: bodies weigh newtons.
const LEAST_FORCE: f64 = 1e-2;

/// How far two histories are apart in one kind of quantity, relative to what is largest of it.
#[derive(Clone, Debug)]
pub struct Apart {
    pub quantity: Quantity,
    pub relative: f64,
    pub size: f64,
    pub of: String,
    pub row: usize,
}

/// What is large in a quantity: the floor of its scale.
pub fn scales(observed: &[Observed], history: &History) -> Vec<(Quantity, f64)> {
    let mut scales: Vec<(Quantity, f64)> = Vec::new();
    for (index, output) in observed.iter().enumerate() {
        let most = history
            .rows
            .iter()
            .map(|row| row[index].iter().map(|x| x * x).sum::<f64>().sqrt())
            .fold(0.0, f64::max);
        match scales.iter_mut().find(|(quantity, _)| *quantity == output.quantity) {
            Some((_, size)) => *size = size.max(most),
            None => scales.push((output.quantity, most)),
        }
    }
    let of = |wanted| {
        scales
            .iter()
            .find(|(quantity, _)| *quantity == wanted)
            .map_or(0.0, |(_, size)| *size)
    };
    let (length, force) = (of(Quantity::Position), of(Quantity::Force));
    for (quantity, size) in &mut scales {
        match quantity {
            Quantity::Moment => *size = size.max(0.05 * force.max(LEAST_FORCE) * length),
            Quantity::Velocity | Quantity::Spin => *size = size.max(0.05 * length),
            Quantity::Force => *size = size.max(LEAST_FORCE),
            Quantity::Momentum => *size = size.max(0.05 * force.max(LEAST_FORCE) * history.span),
            Quantity::AngularMomentum => *size = size.max(0.05 * force.max(LEAST_FORCE) * length * history.span),
            _ => {}
        }
    }
    scales
}

/// The histories of a scene and of a copy of it, by quantity.
pub fn compare(observed: &[Observed], reference: &History, other: &History, copy: &Copy, odd: f64) -> Vec<Apart> {
    let mut list: Vec<Apart> = Vec::new();
    for (quantity, size) in scales(observed, reference) {
        let mut worst = Apart {
            quantity,
            relative: 0.0,
            size,
            of: String::new(),
            row: 0,
        };
        for (index, output) in observed
            .iter()
            .enumerate()
            .filter(|(_, output)| output.quantity == quantity)
        {
            for (number, (a, b)) in reference.rows.iter().zip(&other.rows).enumerate() {
                let expected = carried(output.nature, a[index], &copy.matrix, copy.parity, odd);
                let off = (0..3).map(|k| (expected[k] - b[index][k]).abs()).fold(0.0, f64::max);
                let relative = if off == 0.0 { 0.0 } else { off / size };
                if relative > worst.relative || relative.is_nan() {
                    worst.relative = relative;
                    worst.of = output.of.clone();
                    worst.row = number;
                }
            }
        }
        list.push(worst);
    }
    list
}

/// A value as the copy should show it.
pub fn carried(nature: Nature, value: [f64; 3], matrix: &Matrix, parity: f64, odd: f64) -> [f64; 3] {
    let turn = |factor: f64| std::array::from_fn(|i| factor * (0..3).map(|j| matrix[i][j] * value[j]).sum::<f64>());
    match nature {
        Nature::Polar => turn(1.0),
        Nature::Axial => turn(parity),
        Nature::Even => value,
        Nature::Odd => value.map(|x| odd * x),
    }
}
