//! Whole scenes of the models: mass, stiffness, damping and constraint Jacobians against central
//! differences of residual and constraints along right increments, in both formulations.

use rncf::prelude::*;
use rncf_models::*;
use rncf_reference::tangents::{compare_tangents, compare_tangents_near};

/// Scenes with a given number of elements have two of them: every kind of pair of nodes is there.
fn small<M: Model>() -> M {
    let mut model = M::default();
    let place = M::params().iter().position(|param| param.name == "elements");
    model.set(place.expect("a number of elements"), 2.0);
    model
}

/// A few tethers of two elements each.
fn few<M: Model>() -> M {
    let mut model = small::<M>();
    let place = M::params().iter().position(|param| param.name == "tethers");
    model.set(place.expect("a number of tethers"), 3.0);
    model
}

macro_rules! scenes {
    ($model_of:path; $($test:ident: $model:ident;)*) => {$(
        #[test]
        fn $test() {
            let model: $model = $model_of();
            compare_tangents(&model, Formulation::Rncf, Joints::Eliminated);
            compare_tangents(&model, Formulation::Ancf, Joints::Eliminated);
        }
    )*};
}

scenes! {
    Default::default;
    spin_up: SpinUp;
    spin_up_spatial: SpinUpSpatial;
    heavy_top: HeavyTop;
    four_bar: FourBar;
    bricard: Bricard;
    flyball_governor: FlyballGovernor;
    slider_crank: SliderCrank;
    andrews_squeezer: AndrewsSqueezer;
    free_flight: FreeFlight;
}

scenes! {
    small;
    motor: Motor;
    pinned_pipe: PinnedPipe;
    curved_upwind: CurvedUpwind;
    curved_downwind: CurvedDownwind;
    curved_out_of_plane: CurvedOutOfPlane;
    rotating_cantilever: RotatingCantilever;
    princeton_beam: PrincetonBeam;
    bend_45: Bend45;
    elastica: Elastica;
    roll_up: RollUp;
    right_angle_frame: RightAngleFrame;
    lateral_buckling: LateralBuckling;
}

rncf::model! {
    /// What varies along an axis: a full section with a damping for each strain on a bent axis, a cone, a rope of two parts.
    pub model Along {
        param speed = 2 rad/s;
        table rows { x = [0, 1, 1, 3] m; EI = [3, 2, 1.5, 1] kN*m^2; area = [3, 2, 2, 1] cm^2; turn = [0, 10, 10, 20] deg; }
        table points { x = [0, 1, 2, 3] m; y = [0, 0, 0.1, 0.3] m; z = [0, 0.1, 0.1, 0] m; }
        material _steel { density = 7850 kg/m^3; young = 2 GPa; poisson = 0.3; damping = 1 ms; }
        section layup {
            K11 = 1 MN; K22 = 0.4 MN; K33 = 0.3 MN; K44 = 1 kN*m^2; K55 = 2 kN*m^2; K66 = 3 [kN*m^2] + 10 [N*m] * x;
            K15 = 2 kN*m; K16 = -3 kN*m; K24 = 1 kN*m; K45 = 0.3 kN*m^2; K46 = -0.2 kN*m^2; K56 = 0.1 kN*m^2;
            mass = 3 kg/m; mass_y = 20 mm; mass_z = -10 mm; inertia_y = 0.01 kg*m; inertia_z = 0.02 kg*m; inertia_yz = 0.005 kg*m;
            damping1 = 1 ms; damping2 = 0.5 ms; damping4 = 2 ms; damping5 = 3 ms; damping6 = 1.5 ms;
        }
        section thick { EA = 1 MN; GAy = 0.4 MN; GAz = 0.4 MN; GJ = 1 kN*m^2; EIy = rows.EI; EIz = rows.EI; mass = 3 kg/m; inertia_y = 0.01 kg*m; inertia_z = 0.01 kg*m; }
        section cone = circle(radius = 20 mm * (1 - x / 6 [m]));
        section rope { area = rows.area; second_moment = 10 cm^4; }
        frame hub = rotating(axis = z, angle = speed * t);
        body blade in hub { spatial; curve through points; twist 10 [deg/m] * x; mesh 2 * beam(layup); }
        body spar in hub { spatial; line from [0, 1, 0] m to [3, 1, 0] m; twist rows.turn; mesh at rows * beam(thick); }
        body mast in hub { spatial; line from [0, 2, 0] m to [3, 2, 0] m; twist rows.turn; mesh 2 * beam(cone, _steel); }
        body stay in hub { spatial; line from [0, 3, 0] m to [3, 3, 0] m; mesh at rows * cable(rope, _steel); }
        joint a = clamp(blade.start, hub);
        joint b = clamp(spar.start, hub);
        joint c = clamp(mast.start, hub);
        joint d = clamp(stay.start, hub);
        output tips = blade.end.position;
        output others = [spar.end.z, mast.end.z, stay.end.z];
    }
}

#[test]
fn what_varies_along_an_axis() {
    compare_tangents(&Along::default(), Formulation::Rncf, Joints::Eliminated);
    compare_tangents(&Along::default(), Formulation::Ancf, Joints::Multipliers);
}

/// Elements between stations are a few thousandths of the blade long. Hundreds of unknowns: one formulation each.
#[test]
fn blades() {
    compare_tangents_near(&Nrel5mwBlade::default(), Formulation::Rncf, Joints::Eliminated, 0.01);
    compare_tangents_near(&Iea15mwBlade::default(), Formulation::Ancf, Joints::Eliminated, 0.01);
}

/// Their loads per length have no form in absolute coordinates.
#[test]
fn sails() {
    compare_tangents(&few::<Esail>(), Formulation::Rncf, Joints::Eliminated);
    compare_tangents(&few::<EsailSlack>(), Formulation::Rncf, Joints::Eliminated);
    compare_tangents(&few::<EsailTilted>(), Formulation::Rncf, Joints::Eliminated);
}
