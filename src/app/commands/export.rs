//! Files of bodies in modes, which `import` reads.

use crate::app::line::arguments::Arguments;
use crate::app::machine::files;
use crate::app::results::failure::{FAILURE, Failure, MISTAKE};
use crate::{Formulation, Joints};

/// Writes one archive for each body in modes; the lines that name the files.
pub(in crate::app) fn execute(arguments: &Arguments) -> Result<String, Failure> {
    let scene = arguments
        .model()
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(|error| Failure::new(MISTAKE, error))?;
    let bodies = scene.exported();
    if bodies.is_empty() {
        let message = "no body is described by modes, `modal(n);` or `small(n);`, so that there are none to export";
        return Err(Failure::new(MISTAKE, message));
    }
    let mut lines = String::new();
    for body in &bodies {
        let name = format!("{}.npz", body.name);
        files::write_bytes(&arguments.out, &name, &body.to_npz()).map_err(|text| Failure::new(FAILURE, text))?;
        lines += &format!("\n  {}", arguments.out.join(name).display());
    }
    Ok(lines)
}
