//! In how many directions the stiffness at an equilibrium is negative: where that changes along a way, bodies buckle, or a
//! critical speed is passed.

use crate::equilibrium::{Continued, Kind, Negative, Uniform};
use crate::modes::{self, Stiffness};
use crate::{Scene, SolveError, State};

/// Most unknowns for which the negative directions of the stiffness are counted with full matrices, which is
/// quicker than to look for its values.
const LARGEST: usize = 800;
/// The same at rest, where they are asked for at every step of what has many equal values.
const LARGEST_AT_REST: usize = 2000;
/// Values of the stiffness that are looked at.
const NEXT_TO_ZERO: usize = 4;

/// How many directions of the stiffness are negative.
#[derive(Clone, Debug)]
pub(in crate::app) struct Measured {
    pub negative: usize,
    /// The values next to zero, ascending, with all negative ones; none where they are not known.
    pub values: Vec<f64>,
    /// Whether forces that come from no energy act: which directions are negative then depends on the mass, and only where the stiffness is
    /// singular does not.
    pub circulates: bool,
}

impl Measured {
    /// Their number alone.
    fn counted(negative: usize) -> Self {
        Self {
            negative,
            values: Vec::new(),
            circulates: false,
        }
    }

    fn of(values: Vec<f64>) -> Self {
        let negative = values.iter().filter(|&&value| value < 0.0).count();
        Self {
            values,
            ..Self::counted(negative)
        }
    }
}

/// Of an equilibrium at rest; `None` of a relative one, which [`turning`] asks.
pub(in crate::app) fn at_rest(
    scene: &mut dyn Scene,
    at: &Uniform,
    found: &Continued,
) -> Result<Option<Measured>, SolveError> {
    match found.negative {
        _ if at.kind == Kind::Steady => Ok(None),
        Negative::Counted(negative) => Ok(Some(Measured::counted(negative))),
        Negative::Even | Negative::Odd => {
            let circulates = modes::is_circulatory(scene, at, &found.state);
            // Without circulatory forces the signature tells as much, and does not mind many equal values, as of the bars of a truss.
            if !circulates && found.state.x.len() <= LARGEST_AT_REST {
                let negative = modes::unstable_directions(scene, at, &found.state)?;
                return Ok(Some(Measured::counted(negative)));
            }
            whole(scene, at, &found.state, circulates).map(Some)
        }
    }
}

/// Of the whole stiffness, where circulatory forces act, which `circulates` says, or there are many unknowns.
pub(in crate::app) fn whole(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    circulates: bool,
) -> Result<Measured, SolveError> {
    let values = modes::stiffness_values(scene, at, state, NEXT_TO_ZERO, Stiffness::Whole)?;
    Ok(Measured {
        circulates,
        ..Measured::of(values)
    })
}

/// Of the symmetric part of the co-rotating stiffness; whether with its values, which otherwise are known only where they tell the number.
pub(in crate::app) fn turning(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    with_values: bool,
) -> Result<Measured, SolveError> {
    let is_large = state.x.len() > LARGEST;
    let mut values = Vec::new();
    if is_large || with_values {
        let of = Stiffness::Symmetric(scene.spin_in(at));
        values = modes::stiffness_values(scene, at, state, NEXT_TO_ZERO, of)?;
    }
    if is_large {
        return Ok(Measured::of(values));
    }
    let negative = modes::unstable_directions(scene, at, state)?;
    Ok(Measured {
        values,
        ..Measured::counted(negative)
    })
}
