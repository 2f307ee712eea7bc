//! Whole scenes of the models: mass, stiffness, damping and constraint Jacobians against central
//! differences of residual and constraints along right increments, in both formulations.

use rncf::prelude::*;
use rncf_models::*;
use rncf_tests::tangents::compare_tangents;

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

/// Their loads per length have no form in absolute coordinates.
#[test]
fn sails() {
    compare_tangents(&few::<Esail>(), Formulation::Rncf, Joints::Eliminated);
    compare_tangents(&few::<EsailSlack>(), Formulation::Rncf, Joints::Eliminated);
    compare_tangents(&few::<EsailTilted>(), Formulation::Rncf, Joints::Eliminated);
}
