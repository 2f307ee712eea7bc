//! What is written for a model with loops.

use proc_macro2::TokenStream;

use crate::elements::Library;
use crate::errors::Errors;
use crate::expand;
use crate::{check, parse};

/// A wheel: spokes and sides in a loop, each side between two spokes, beside an axle without a loop.
const WHEEL: &str = "model Wheel {
    param spokes: count = 4;
    param rim = 1 m;
    material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
    frame hub = free();
    fixture core on hub { mass = 2 kg; }
    body axle in hub { spatial; line from [0, 0, 0] m to [0, 0, 1] m; mesh 1 * cable(wire, steel); }
    joint middle = clamp(axle.start, hub);
    for a in 0..spokes {
        body spoke[a] in hub {
            spatial;
            line from [0, 0, 0] m to [rim * cos(2*pi*a/spokes), rim * sin(2*pi*a/spokes), 0 m];
            mesh 2 * cable(wire, steel);
        }
        body side[a] in hub {
            spatial; line from [0, 0, 0] m to [rim, 0 m, 0 m]; mesh 1 * cable(wire, steel);
            initial position [rim - x * (a + 1), x, 0 m];
        }
        joint root[a] = clamp(spoke[a].start, hub);
        joint near[a] = share(side[a].start, spoke[a].end);
        joint far[a] = share(side[a].end, spoke[(a + 1) % spokes].end);
        fixture ball[a] on spoke[a].end { mass = 1 kg; }
    }
    output high = max(a in 0..spokes, spoke[a].end.z) - axle.end.z;
    output sum = sum(a in 0..spokes, a * side[a].end.z);
    output last = spoke[3].end.z;
}";

#[test]
fn what_is_repeated_is_written_once_and_expanded() {
    let mut errors = Errors::new();
    let tree = parse::parse(WHEEL.parse::<TokenStream>().unwrap(), &mut errors).unwrap();
    let model = check::check(&tree, &Library::standard(), &mut errors);
    let mistakes = errors.finish();
    assert!(mistakes.is_empty(), "{mistakes:?}");
    let text = expand::format(&expand::written_out(&model.unwrap(), &Library::standard()));
    let there = [
        "pub row_axle: CableSpatial,",
        "pub row_spoke: ::std::vec::Vec<CableSpatial>,",
        "firsts: ::rncf::emitted::firsts([1, counts[0], counts[0]]),",
        "first_joints: ::rncf::emitted::firsts([1, counts[0]]),",
        "::rncf::emitted::repetitions(\"a\", (model.spokes as f64))?;",
        "for instance in 0..self.counts[0] {",
        "instance: Some(instance)",
        "body: ::rncf::emitted::instance(self.first(1), self.counts[0], index)",
        "let joint = self.joint_kind(joint);",
        "self.row_spoke.truncate(instance);",
        "Reduction::Max",
        "Reduction::Sum",
        "let (plain, mut rest) = observed.split_at(2);",
    ];
    // Lines are broken where they are too long.
    let dense = |text: &str| text.split_whitespace().collect::<String>().replace(",)", ")");
    let whole = dense(&text);
    for there in there {
        assert!(whole.contains(&dense(there)), "{there} is missing in\n{text}");
    }
    // Kernels stand once for each kind of element, not for each body.
    assert_eq!(text.matches("pub fn cable_spatial_mass").count(), 1);
    assert_eq!(text.matches("rem_euclid").count(), 1);
}
