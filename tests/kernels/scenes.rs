//! Whole scenes of the models: mass, stiffness, damping and constraint Jacobians against central
//! differences of residual and constraints along right increments, in both formulations.

use rncf::prelude::*;
use rncf_models::*;
use rncf_tests::tangents::compare_tangents;

macro_rules! scenes {
    ($($test:ident: $model:ident;)*) => {$(
        #[test]
        fn $test() {
            compare_tangents(&$model::default(), Formulation::Rncf, Joints::Eliminated);
            compare_tangents(&$model::default(), Formulation::Ancf, Joints::Eliminated);
        }
    )*};
}

scenes! {
    spin_up: SpinUp;
    heavy_top: HeavyTop;
    four_bar: FourBar;
    bricard: Bricard;
    flyball_governor: FlyballGovernor;
    slider_crank: SliderCrank;
    andrews_squeezer: AndrewsSqueezer;
    free_flight: FreeFlight;
}
