//! Every compiled tangent against complex steps through the expression graph of its residual, in a
//! form of the energy that need not be the compiled one.

use std::collections::HashMap;

use rncf_codegen::elements::Library;
use rncf_codegen::lower::elastic::kernel;
use rncf_codegen::lower::form::{Form, Quantity};
use rncf_codegen::lower::{Kernel, Variant};
use rncf_codegen::model::{ElementId, Evaluation, Quadrature};
use rncf_codegen::symbolic::{Id, Node};

use crate::complex::Complex;

/// Largest relative error that counts as exact.
const LIMIT: f64 = 1e-10;
const STEP: f64 = 1e-200;

/// Deterministic numbers in [-1, 1].
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Derivatives of a kernel's outputs with respect to symbols, one column a symbol.
pub fn jacobian(kernel: &Kernel, inputs: &HashMap<String, f64>, with: &[String]) -> Vec<Vec<f64>> {
    let graph = &kernel.graph;
    let roots: Vec<Id> = kernel.outputs.iter().map(|&(_, id)| id).collect();
    let symbols: Vec<Id> = graph
        .reachable(&roots)
        .into_iter()
        .filter(|&id| matches!(graph.node(id), Node::Symbol(_)))
        .collect();
    let column = |name: &String| {
        let values = symbols.iter().map(|&id| {
            let text = graph.symbol_text(id);
            let re = *inputs.get(text).unwrap_or_else(|| panic!("no value for {text}"));
            (
                id,
                Complex {
                    re,
                    im: if text == name { STEP } else { 0.0 },
                },
            )
        });
        graph
            .evaluate(&roots, &values.collect())
            .iter()
            .map(|value| value.im / STEP)
            .collect()
    };
    with.iter().map(column).collect()
}

pub fn assert_close(what: &str, compiled: &[f64], columns: &[Vec<f64>]) {
    let size = columns.len();
    let scale = columns.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(scale > 0.0, "{what}: the reference is zero");
    for (column, reference) in columns.iter().enumerate() {
        for (row, &value) in reference.iter().enumerate() {
            let error = (compiled[row * size + column] - value).abs() / scale;
            assert!(
                error <= LIMIT,
                "{what}: entry ({row}, {column}) is {} instead of {value}",
                compiled[row * size + column]
            );
        }
    }
}

/// A random state of an element: nodal vectors near a unit line, rates, and the reference shape.
struct Sample {
    inputs: HashMap<String, f64>,
    q: Vec<f64>,
    v: Vec<f64>,
}

fn sample(variant: &Variant, row: &[(&str, f64)], random: &mut Random) -> Sample {
    let library = Library::standard();
    let mut inputs: HashMap<String, f64> = row.iter().map(|&(name, value)| (name.to_string(), value)).collect();
    let length = inputs["length"];
    let mut states = Vec::new();
    for prefix in ["", "v_"] {
        let mut state = Vec::new();
        for (index, names) in variant.component_names(&library, prefix).into_iter().enumerate() {
            for (component, name) in names.into_iter().enumerate() {
                let straight = match (prefix, index, component) {
                    ("", 2, 0) => length,
                    ("", 1 | 3, 0) => 1.0,
                    _ => 0.0,
                };
                let value = straight + 0.3 * random.next();
                inputs.insert(name, value);
                state.push(value);
            }
        }
        states.push(state);
    }
    let v = states.pop().unwrap();
    Sample {
        inputs,
        q: states.pop().unwrap(),
        v,
    }
}

fn variant(dimension: usize, exact: usize, quadrature: Quadrature, damped: bool, curved: bool) -> Variant {
    let evaluation = Evaluation::Automatic;
    Variant {
        element: ElementId(0),
        dimension,
        options: vec![exact],
        quadrature,
        evaluation,
        damped,
        curved,
        varying: false,
        material: None,
    }
}

/// One test: the compiled tangent of `$module::$name` with the struct `$row`.
macro_rules! elastic_test {
    ($test:ident, $module:path, $row:ident, $tangent:ident, $size:literal, $variant:expr, $form:expr $(, reference = $reference:ident, $count:literal)?, damped = $($damped:ident)?) => {
        #[test]
        fn $test() {
            use $module as kernels;
            let variant: Variant = $variant;
            // Undamped elements have no field for damping.
            let row = kernels::$row { length: 0.7, EA: 4000.0, EI: 130.0, rhoA: 0.44 $(, damping: value_for!($damped))? };
            let fields = [("length", row.length), ("EA", row.EA), ("EI", row.EI), ("damping", 2e-3)];
            let mut random = Random(7);
            for _ in 0..20 {
                #[allow(unused_mut)]
                let mut sample = sample(&variant, &fields, &mut random);
                let q: [f64; $size] = sample.q.clone().try_into().unwrap();
                let (mut stiffness, mut damping) = ([0.0; $size * $size], [0.0; $size * $size]);
                let _ = (&mut damping, &sample.v);
                $(
                    let mut reference = [0.0; $count];
                    let shape: [f64; $size] = std::array::from_fn(|i| q[i] + 0.1 * random.next());
                    kernels::$reference(&row, &shape, &mut reference);
                    for (index, &value) in reference.iter().enumerate() {
                        sample.inputs.insert(format!("reference[{index}]"), value);
                    }
                )?
                call!(kernels, $tangent, row, q, sample, stiffness, damping, $size $(, $reference reference)? ; $($damped)?);
                let library = Library::standard();
                let force = kernel(&variant, &library, $form, Quantity::Force).unwrap();
                let names = variant.component_names(&library, "").concat();
                assert_close(stringify!($test), &stiffness, &jacobian(&force, &sample.inputs, &names));
                if variant.damped {
                    let names = variant.component_names(&library, "v_").concat();
                    assert_close(stringify!($test), &damping, &jacobian(&force, &sample.inputs, &names));
                }
            }
        }
    };
}

macro_rules! value_for {
    (yes) => {
        2e-3
    };
}

macro_rules! call {
    ($k:ident, $f:ident, $row:ident, $q:ident, $s:ident, $stiff:ident, $damp:ident, $n:literal ;) => {
        $k::$f(&$row, &$q, &mut $stiff)
    };
    ($k:ident, $f:ident, $row:ident, $q:ident, $s:ident, $stiff:ident, $damp:ident, $n:literal ; yes) => {{
        let v: [f64; $n] = $s.v.clone().try_into().unwrap();
        $k::$f(&$row, &$q, &v, &mut $stiff, &mut $damp)
    }};
    ($k:ident, $f:ident, $row:ident, $q:ident, $s:ident, $stiff:ident, $damp:ident, $n:literal, $r:ident $reference:ident ; yes) => {{
        let v: [f64; $n] = $s.v.clone().try_into().unwrap();
        $k::$f(&$row, &$reference, &$q, &v, &mut $stiff, &mut $damp)
    }};
}

// The exact rule: the compiled tensor against five points; another form, another tangent formula.
elastic_test!(planar, rncf_models::spin_up_equations, CablePlanar, cable_planar_elastic_tangent, 8,
    variant(2, 0, Quadrature::Exact, false, false), Form::Points, damped =);
elastic_test!(spatial, rncf_models::spin_up_spatial_equations, CableSpatial, cable_spatial_elastic_tangent, 12,
    variant(3, 0, Quadrature::Exact, false, false), Form::Points, damped =);
elastic_test!(
    planar_curved_damped,
    crate::models::curved_damped_equations,
    CablePlanarCurvedDamped,
    cable_planar_curved_damped_elastic_tangent,
    8,
    variant(2, 0, Quadrature::Exact, true, true),
    Form::Tensor,
    reference = cable_planar_curved_damped_reference,
    9,
    damped = yes
);
elastic_test!(
    planar_exact_curved_damped,
    crate::models::curved_exact_equations,
    CablePlanarExactCurvedDamped,
    cable_planar_exact_curved_damped_elastic_tangent,
    8,
    variant(2, 1, Quadrature::Exact, true, true),
    Form::Points,
    reference = cable_planar_exact_curved_damped_reference,
    10,
    damped = yes
);
elastic_test!(
    spatial_exact_damped,
    crate::models::spatial_exact_equations,
    CableSpatialExactGauss3Damped,
    cable_spatial_exact_gauss3_damped_elastic_tangent,
    12,
    variant(3, 1, Quadrature::Gauss(3), true, false),
    Form::Points,
    damped = yes
);
elastic_test!(
    spatial_tensor_damped,
    crate::models::spatial_tensor_equations,
    CableSpatialGauss3TensorDamped,
    cable_spatial_gauss3_tensor_damped_elastic_tangent,
    12,
    variant(3, 0, Quadrature::Gauss(3), true, false),
    Form::Points,
    damped = yes
);

#[test]
fn moments_on_slopes() {
    let mut random = Random(5);
    for dimension in [2, 3] {
        let [force, _] = rncf_codegen::lower::loads::moment_kernels(dimension);
        let slope: Vec<f64> = (0..dimension)
            .map(|i| f64::from(u8::from(i == 0)) + 0.3 * random.next())
            .collect();
        let moment: [f64; 3] = std::array::from_fn(|_| random.next());
        let mut inputs = HashMap::new();
        let names: Vec<String> = (0..dimension).map(|i| format!("slope[{i}]")).collect();
        inputs.extend(names.iter().cloned().zip(slope.iter().copied()));
        inputs.extend((0..3).map(|i| (format!("moment[{i}]"), moment[i])));
        let mut compiled = vec![0.0; dimension * dimension];
        if dimension == 2 {
            crate::models::curved_damped_equations::moment_tangent_planar(&slope, moment, &mut compiled);
        } else {
            crate::models::spatial_exact_equations::moment_tangent_spatial(&slope, moment, &mut compiled);
        }
        assert_close("moment", &compiled, &jacobian(&force, &inputs, &names));
    }
}
