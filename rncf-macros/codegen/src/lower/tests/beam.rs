//! Inertia, joints and moments of bodies whose nodes carry the axes of a section.

use super::Inputs;
use crate::elements::Library;
use crate::lower::Variant;
use crate::lower::carried::element_kernels;
use crate::lower::inertia::inertia_kernels;
use crate::model::{ElementId, Evaluation, Quadrature};

fn variant(dimension: usize) -> Variant {
    Variant {
        element: ElementId(Library::standard().find("beam").unwrap()),
        dimension,
        options: vec![0],
        quadrature: Quadrature::Exact,
        evaluation: Evaluation::Automatic,
        damped: false,
        curved: false,
    }
}

#[test]
fn sizes() {
    let library = Library::standard();
    for dimension in [2, 3] {
        let variant = variant(dimension);
        let start = std::time::Instant::now();
        let inertia = inertia_kernels(&variant, &library);
        let carried = element_kernels(&variant, &library);
        eprintln!("{:?}", start.elapsed());
        for kernel in [&inertia.mass, &inertia.referenced, &inertia.referenced_tangent, &inertia.absolute, &carried.force, &carried.tangent] {
            eprintln!("{} {} {:?}", kernel.name, kernel.size(), kernel.cost());
            let text = crate::emit::kernel::function(kernel);
            eprintln!("   {}", text.lines().count());
            std::fs::write(format!("/tmp/k_{}.rs", kernel.name), text).unwrap();
        }
    }
}
