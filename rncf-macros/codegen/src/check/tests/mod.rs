mod along;
mod bushings;
mod density;
mod distributed;
mod elements;
mod first;
mod forces;
mod free;
mod influence;
mod joints;
mod meaning;
mod moving_sections;
mod mutated;
mod parts;
mod precedence;
mod repeat;
mod right;
mod section_forces;
mod section_joints;
mod sections;
mod start;
mod tied;
mod truncated;
mod world;
mod wrong;

use crate::check::check;
use crate::elements::Library;
use crate::errors::{Errors, Mistake};
use crate::model::Model;
use crate::parse::parse;

/// Everything that the language has, in one model.
const SPIN_UP: &str = r#"
/// Spin-up manoeuvre of a flexible beam (Ren & Yang 2021, section 4.1.1).
pub model SpinUp {
    /// Steady angular velocity.
    param omega_s = 4 rad/s;
    param elements: count = 6;
    param T_s = 15 s;
    const g = 9.81 m/s^2;
    material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; poisson = 0.3; damping = 1e-5 s; }
    section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
    motion theta(t) = if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
                      else { omega_s * (t - T_s/2) };
    frame hub = rotating(axis = z, angle = theta(t));
    body beam in hub {
        planar xy;
        line from [0, 0, 0] m to [8, 0, 0] m;
        mesh elements * cable(tube, aluminium);
    }
    joint root = clamp(beam.start, hub);
    load weight = gravity([0, -g, 0]);
    load pull = force(beam.end, [0, 10, 0] N, in = hub);
    load twist = moment(beam.end, [0, 0, 3] N*m);
    /// Elongation of the tip
    output u = beam.end.x - 8 m;
    output tip = beam.end;
    output vy = beam.at(4 m).velocity.y;
    output s = beam.end.slope.x;
    output m_root = root.moment.z;
    output f_root = root.force;
    run { t_end = 20 s; every = 0.05 s; }
}
"#;

/// Parses and checks a text.
fn run(text: &str) -> (Option<Model>, Vec<Mistake>) {
    let mut errors = Errors::new();
    let tree = parse(text.parse().expect("tokens"), &mut errors);
    let tree = tree.map(|tree| crate::unfold::unfold(tree, &mut errors));
    let model = tree.and_then(|tree| check(&tree, &Library::standard(), &mut errors));
    (model, errors.finish())
}

/// A model without mistakes.
fn model(text: &str) -> Model {
    let (model, mistakes) = run(text);
    let messages: Vec<_> = mistakes
        .iter()
        .map(|mistake| (mistake.area.source_text(), &mistake.message))
        .collect();
    assert!(messages.is_empty(), "{messages:?}");
    model.expect("a model")
}
