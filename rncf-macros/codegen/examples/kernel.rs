//! Prints kernels.
use rncf_codegen::{elements::Library, emit, lower::*, model::*};
fn main() {
    let library = Library::standard();
    for (dimension, p, damped) in [(2, 0, false), (2, 0, true), (2, 1, false), (3, 0, false), (3, 1, true)] {
        let variant = Variant {
            element: ElementId(0),
            dimension,
            options: vec![p],
            quadrature: Quadrature::Exact,
            evaluation: Evaluation::Automatic,
            damped,
            curved: false,
        };
        let t = std::time::Instant::now();
        let kernels = elastic_kernels(&variant, &library);
        eprintln!("{} {} {:?}", variant.name(&library), kernels.choice, t.elapsed());
        println!(
            "{}{}{}",
            emit::kernel::function(&kernels.force),
            emit::kernel::function(&kernels.tangent),
            emit::kernel::function(&kernels.energy)
        );
        let t = std::time::Instant::now();
        let inertia = inertia::inertia_kernels(&variant, &library);
        eprintln!("{:?}", t.elapsed());
        println!(
            "{}{}",
            emit::kernel::function(&inertia.referenced),
            emit::kernel::function(&inertia.referenced_tangent)
        );
    }
}
