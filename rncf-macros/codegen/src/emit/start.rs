//! Frames whose bodies start in relative equilibrium.

use std::fmt::Write;

use super::parts::Parts;

impl Parts<'_> {
    /// The method that names them.
    pub(super) fn starts(&self) -> String {
        if self.model.starts.is_empty() {
            return self.list("starts", "StartSpec", &[]);
        }
        let mut text = "fn starts(&self) -> ::std::vec::Vec<::rncf::emitted::StartSpec> {\nlet model = &self.model;\n\
                    ::std::vec::Vec::from([\n"
            .to_string();
        for start in &self.model.starts {
            let spin = match &start.spin {
                Some(spin) => format!("Some({})", self.vector(spin)),
                None => "None".to_string(),
            };
            let _ = writeln!(
                text,
                "::rncf::emitted::StartSpec {{ name: {:?}, frame: {}, spin: {spin} }},",
                start.name, start.frame.0
            );
        }
        text + "])\n}\n"
    }
}
