//! T3 of THEORY 10: lengths of metres, strains of 1e-3 and motions of hundreds of metres at 1.5e11 m from the origin.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, State, StepSize, Stop};

/// One astronomical unit, m.
const R: f64 = 1.495978707e11;
/// Length of an element, m, and its Green strain.
const LENGTH: f64 = 625.0;
const STRAIN: f64 = 1.2e-3;

rncf::model! {
    /// Two wires that spin about a core in their plane; they start about as stretched as they spin, and never go slack.
    pub model Spinning {
        /// Distance of the core from the origin.
        param distance = 0 m;
        /// Velocity of the core across.
        param speed = 0 m/s;
        /// Angular velocity.
        param spin = 0.5 deg/s;
        /// Elements of a wire.
        param elements: count = 8;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
        section wire { area = 0.00453646 mm^2; second_moment = 1.6e-6 mm^4; }
        frame sail = free(origin = [distance, 0, 0], velocity = [0, speed, 0], angular_velocity = [0, 0, spin]);
        fixture core on sail { mass = 100 kg; }
        body one in sail {
            spatial;
            line from [0, 0, 0] m to [10000, 0, 0] m;
            mesh elements * tether(wire, aluminium);
            initial position [1.0011 * x, 0, 0];
        }
        body two in sail {
            spatial;
            line from [0, 0, 0] m to [0, 10000, 0] m;
            mesh elements * tether(wire, aluminium);
            initial position [0, 1.0013 * x, 0];
        }
        joint one_hub = clamp(one.start, sail);
        joint two_hub = clamp(two.start, sail);
        fixture one_unit on one.end { mass = 0.4 kg; }
        fixture two_unit on two.end { mass = 0.5 kg; }
        /// Ends of the wires in the frame, a tension at a root, the core's way along the line of sight.
        output one_end = one.end.in(sail);
        output two_end = two.end.in(sail);
        output tension = one.start.axial_force;
        output away = sail.position.x - distance;
        run { t_end = 200 s; every = 10 s; }
    }
}

/// Shape functions of the position's derivative by arc length at xi: those of positions and slopes.
fn slopes(xi: f64) -> [f64; 4] {
    let position = 6.0 * xi * (1.0 - xi) / LENGTH;
    let (first, last) = (1.0 + xi * (3.0 * xi - 4.0), xi * (3.0 * xi - 2.0));
    [-position, first, position, last]
}

/// Nodal vectors of a straight, stretched element whose start is `from` the core, the core at `origin`.
fn element(origin: [f64; 3], from: f64, direction: [f64; 3]) -> [[f64; 3]; 4] {
    let stretch = (1.0 + 2.0 * STRAIN).sqrt();
    let at = |x: f64| -> [f64; 3] { std::array::from_fn(|i| origin[i] + stretch * x * direction[i]) };
    let slope = direction.map(|d| stretch * d);
    [at(from), slope, at(from + LENGTH), slope]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Strain from products of the nodal vectors, as a constant tensor of an element gives it.
fn by_products(q: &[[f64; 3]; 4], xi: f64) -> f64 {
    let n = slopes(xi);
    let mut square = 0.0;
    for a in 0..4 {
        for b in 0..4 {
            square += n[a] * n[b] * dot(q[a], q[b]);
        }
    }
    0.5 * (square - 1.0)
}

/// Strain from differences of the nodal vectors.
fn by_differences(q: &[[f64; 3]; 4], xi: f64) -> f64 {
    let n = slopes(xi);
    let slope: [f64; 3] = std::array::from_fn(|i| n[2] * (q[2][i] - q[0][i]) + n[1] * q[1][i] + n[3] * q[3][i]);
    0.5 * (dot(slope, slope) - 1.0)
}

#[test]
fn strains_survive_in_a_frame_nearby_alone() {
    let mut worst = [[0.0_f64; 2]; 2];
    for k in 0..100 {
        let (sin, cos) = (0.0628 * f64::from(k)).sin_cos();
        let direction = [0.8 * cos, sin, 0.6 * cos];
        for (place, origin) in [[R, 0.3 * R, 1e6], [0.0; 3]].into_iter().enumerate() {
            let q = element(origin, 15.0 * LENGTH, direction);
            for xi in [0.1, 0.35, 0.5, 0.8] {
                for (way, strain) in [by_products(&q, xi), by_differences(&q, xi)].into_iter().enumerate() {
                    worst[place][way] = worst[place][way].max((strain - STRAIN).abs());
                }
            }
        }
    }
    let [absolute, referenced] = worst;
    println!(
        "strain off: absolute by products {:.1e}, by differences {:.1e}",
        absolute[0], absolute[1]
    );
    println!(
        "in a frame: by products {:.1e}, by differences {:.1e}",
        referenced[0], referenced[1]
    );
    assert!(absolute[0] > 1.0, "products of absolute positions are useless");
    assert!((1e-9..1e-6).contains(&absolute[1]));
    assert!((1e-15..1e-11).contains(&referenced[0]));
    assert!(referenced[1] < 1e-14);
}

/// Outputs of the spinning wires at the end of a run, and the unknowns there.
fn flight(
    model: &Spinning,
    formulation: Formulation,
    method: Method,
    end: f64,
    h: f64,
) -> Result<(Vec<f64>, State), String> {
    let mut scene = model
        .build(formulation, Joints::Eliminated)
        .map_err(|error| error.to_string())?;
    let start = scene.rest(0.0);
    let options = Options {
        rtol: 1e-10,
        step: StepSize::Fixed(h),
        ..Options::default()
    };
    let mut integrator =
        Integrator::new(scene.as_mut(), start, end, method, options).map_err(|error| error.to_string())?;
    while integrator.step().map_err(|error| error.to_string())? != Stop::End {}
    println!("{method:?}: {:?}", integrator.statistics());
    let state = integrator.state().clone();
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(&state, &mut row);
    Ok((row, state))
}

const METHODS: [Method; 2] = [Method::GeneralizedAlpha { rho_inf: 0.8 }, Method::Radau];

fn far_away() -> Spinning {
    Spinning {
        distance: R,
        speed: 29_785.0,
        ..Spinning::default()
    }
}

#[test]
fn wires_spin_at_one_astronomical_unit_as_at_the_origin() {
    for method in METHODS {
        let [near, far] = [Spinning::default(), far_away()]
            .map(|model| flight(&model, Formulation::Rncf, method, 200.0, 1.0).unwrap());
        // Ends relative to the length, tension relative to itself.
        let mut worst = 0.0_f64;
        for (column, (near, far)) in near.0.iter().zip(&far.0).enumerate().take(7) {
            let size = if column < 6 { 1e4 } else { near.abs() };
            worst = worst.max((near - far).abs() / size);
        }
        let unknowns = near.1.x.iter().zip(&far.1.x);
        let moved = unknowns.fold(0.0_f64, |most, (near, far)| most.max((near - far).abs()));
        let (away, absolute) = (near.0[7], far.0[7]);
        println!(
            "{method:?}: outputs differ by {worst:.1e}, unknowns by {moved:.1e} m; core moved {away} m, {absolute} m"
        );
        assert!(near.0[6] > 1e-3, "the wire is in tension");
        // Places in a frame are told by way of space, with the last bit of the distance.
        assert!(worst < 1e-8 && moved < 1e-9);
        // Absolute positions have the round-off of their size.
        assert!(away.abs() > 0.1 && (away - absolute).abs() < 1e-4);
    }
}

#[test]
fn absolute_coordinates_lose_the_wires_there() {
    let method = METHODS[0];
    let near = flight(&Spinning::default(), Formulation::Ancf, method, 2.0, 0.01).unwrap();
    let tension = near.0[6];
    assert!(tension > 0.0);
    match flight(&far_away(), Formulation::Ancf, method, 2.0, 0.01) {
        Ok(far) => {
            let off = (far.0[6] - tension).abs() / tension;
            println!("tension {tension:.3e} N, off by {off:.1e} of it");
            assert!(off > 1e-3, "{off:e}");
        }
        Err(text) => println!("refused: {text}"),
    }
}
