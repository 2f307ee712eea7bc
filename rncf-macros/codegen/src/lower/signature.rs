//! Names, arguments and documentation of the kernels of an element.

use super::form::{FieldKernels, Form, Quantity, points, rules};
use super::kernel::{Kernel, PointLoop};
use super::variant::Variant;
use crate::elements::Library;
use crate::symbolic::{Graph, Id};
use crate::tensors::Sampling;

/// What the signatures of an element's kernels depend on.
pub(super) struct Signature<'a> {
    pub variant: &'a Variant,
    pub library: &'a Library,
    /// Reference symbols that the kernel made.
    pub references: usize,
}

/// What a kernel of the fields at a point takes and gives.
pub(super) struct PointInputs {
    /// Names of the fields.
    pub names: Vec<&'static str>,
    /// Names of their components and of those of their rates.
    pub inputs: [Vec<Vec<String>>; 2],
    /// Numbers of blocks of stiffness and damping.
    pub blocks: [usize; 2],
}

impl Signature<'_> {
    /// The row's fields and the nodal components, bound to the names that the symbols have.
    pub fn bindings(&self, coefficients: bool, states: &[(&str, &str)]) -> Vec<String> {
        let element = self.variant.declaration(self.library);
        let mut fields = vec!["length"];
        if coefficients {
            fields.extend(
                self.variant
                    .coefficients(self.library)
                    .into_iter()
                    .map(|c| c.name)
                    .filter(|&name| element.inertia.iter().all(|inertia| inertia.coefficient != name)),
            );
            if self.variant.damped {
                fields.push("damping");
            }
        } else if !self.variant.varying {
            let vectors = self.variant.vectors(self.library);
            let used = element
                .inertia
                .iter()
                .filter(|inertia| vectors.iter().any(|vector| vector.of == inertia.of));
            for inertia in used {
                if !fields.contains(&inertia.coefficient) {
                    fields.push(inertia.coefficient);
                }
            }
        }
        let mut bindings = vec![format!("let {} {{ {}, .. }} = *row;", self.row(), fields.join(", "))];
        for (argument, prefix) in states {
            let names = self.variant.component_names(self.library, prefix).concat();
            bindings.push(format!("let [{}] = *{argument};", names.join(", ")));
        }
        bindings
    }

    /// The coefficients that expressions read, bound to their names; none where they read none.
    fn read_coefficients(&self, graph: &Graph, roots: &[Id]) -> Option<String> {
        let nodes = graph.reachable(roots);
        let is_read = |name: &&str| nodes.iter().any(|&node| graph.is_input(node, name));
        let coefficients = self.variant.coefficients(self.library).into_iter();
        let names: Vec<&str> = coefficients.map(|one| one.name).filter(is_read).collect();
        (!names.is_empty()).then(|| format!("let {} {{ {}, .. }} = *row;", self.row(), names.join(", ")))
    }

    /// Name of the struct with the constants of an element.
    pub fn row(&self) -> String {
        camel_case(&self.variant.name(self.library))
    }

    /// Number of reference values of an element.
    fn reference_count(&self, form: Form) -> usize {
        let element = self.variant.declaration(self.library);
        match form {
            Form::Loop => self.references * points(element, self.variant.quadrature).count(),
            Form::Tensor | Form::Points => self.references,
            Form::Fields => self.references,
        }
    }

    /// Wraps the expressions of an elastic kernel.
    pub fn elastic(
        &self,
        form: Form,
        quantity: Quantity,
        graph: Graph,
        points: Option<PointLoop>,
        outputs: Vec<(String, Id)>,
    ) -> Kernel {
        let size = self.variant.size(self.library);
        let name = self.variant.name(self.library);
        let with_rates = self.variant.damped && matches!(quantity, Quantity::Force | Quantity::Tangent);
        let mut arguments = vec![format!("row: &{}", self.row())];
        if self.variant.has_references() && quantity != Quantity::Reference {
            arguments.push(format!("reference: &[f64; {}]", self.reference_count(form)));
        }
        arguments.push(format!("q: &[f64; {size}]"));
        let mut states = vec![("q", "")];
        if with_rates {
            arguments.push(format!("v: &[f64; {size}]"));
            states.push(("v", "v_"));
        }
        let (suffix, what) = match quantity {
            Quantity::Force => {
                arguments.push(format!("force: &mut [f64; {size}]"));
                (
                    "elastic_force",
                    "Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes)",
                )
            }
            Quantity::Tangent => {
                arguments.push(format!("stiffness: &mut [f64; {}]", size * size));
                if with_rates {
                    arguments.push(format!("damping_matrix: &mut [f64; {}]", size * size));
                }
                (
                    "elastic_tangent",
                    "Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first",
                )
            }
            Quantity::Energy => {
                arguments.push("energy: &mut f64".to_string());
                ("strain_energy", "Adds the strain energy U of one element (J)")
            }
            Quantity::Reference => {
                arguments.push(format!("reference: &mut [f64; {}]", self.references));
                (
                    "reference",
                    "Values of one element in the stress-free shape, which the other kernels subtract",
                )
            }
        };
        let mut bindings = self.bindings(quantity != Quantity::Reference, &states);
        if quantity == Quantity::Reference {
            let roots: Vec<Id> = outputs.iter().map(|(_, value)| *value).collect();
            bindings.extend(self.read_coefficients(&graph, &roots));
        }
        Kernel {
            name: format!("{name}_{suffix}"),
            doc: vec![format!("{what}."), self.energy_text(), self.form_text(form)],
            arguments,
            bindings,
            graph,
            points,
            outputs,
            assign: quantity == Quantity::Reference,
        }
    }

    /// Wraps the expressions of a force between two states, or of its derivative.
    pub fn between_states(
        &self,
        form: Form,
        quantity: Quantity,
        graph: Graph,
        points: Option<PointLoop>,
        outputs: Vec<(String, Id)>,
    ) -> Kernel {
        let size = self.variant.size(self.library);
        let mut arguments = vec![format!("row: &{}", self.row())];
        if self.variant.has_references() {
            arguments.push(format!("reference: &[f64; {}]", self.reference_count(form)));
        }
        arguments.extend(["start", "end"].map(|state| format!("{state}: &[f64; {size}]")));
        let (suffix, what) = match quantity {
            Quantity::Tangent => {
                arguments.push(format!("stiffness: &mut [f64; {}]", size * size));
                (
                    "conserving_tangent",
                    "Adds the derivative of the conserving force of one element with respect to the mean of both states at \
                     a fixed start (half of it is that with respect to the end), rows first; not symmetric",
                )
            }
            _ => {
                arguments.push(format!("force: &mut [f64; {size}]"));
                (
                    "conserving_force",
                    "Adds the elastic force of one element between two states that does the work U(end) - U(start) over \
                     the step and has no moment about the mean positions: S_A(mean of I) dI_A/dq(mean of q)",
                )
            }
        };
        Kernel {
            name: format!("{}_{suffix}", self.variant.name(self.library)),
            doc: vec![format!("{what}."), self.energy_text(), self.form_text(form)],
            arguments,
            bindings: self.bindings(true, &[("start", "o_"), ("end", "e_")]),
            graph,
            points,
            outputs,
            assign: false,
        }
    }

    /// Wraps the expressions of a kernel of the fields at a point in two states: names of the fields, of their
    /// components in both states, number of blocks.
    pub fn point_between_states(
        &self,
        (points, quantity): (Sampling, Quantity),
        graph: Graph,
        outputs: Vec<(String, Id)>,
        (names, inputs, blocks): (&[&str], &[Vec<Vec<String>>; 2], usize),
    ) -> Kernel {
        let (dimension, count) = (self.variant.dimension, names.len());
        let mut arguments = vec![format!("row: &{}", self.row())];
        if self.variant.has_references() {
            arguments.push(format!("reference: &[f64; {}]", self.references));
        }
        let mut bindings = self.bindings(true, &[]);
        for (argument, components) in ["start", "end"].into_iter().zip(inputs) {
            arguments.push(format!("{argument}: &[[f64; {dimension}]; {count}]"));
            let vectors: Vec<String> = components.iter().map(|c| format!("[{}]", c.join(", "))).collect();
            bindings.push(format!("let [{}] = *{argument};", vectors.join(", ")));
        }
        let (word, what) = if quantity == Quantity::Tangent {
            arguments.push(format!("stiffness: &mut [[f64; {}]; {blocks}]", dimension * dimension));
            ("tangent", "the blocks of the derivative by the mean of both states")
        } else {
            arguments.push(format!("forces: &mut [[f64; {dimension}]; {count}]"));
            ("force", "the conserving forces")
        };
        Kernel {
            name: format!(
                "{}_{}_conserving_{word}",
                self.variant.name(self.library),
                points.word()
            ),
            doc: vec![format!(
                "Writes {what} on the fields {} at a point of weight one on the unit element between two states, for the \
                 terms that are integrated at {points}.",
                names.join(", ")
            )],
            arguments,
            bindings,
            graph,
            points: None,
            outputs,
            assign: true,
        }
    }

    /// Wraps the expressions of a kernel of the fields at a point.
    pub fn field_point(
        &self,
        points: Sampling,
        quantity: Quantity,
        graph: Graph,
        outputs: Vec<(String, Id)>,
        point: &PointInputs,
    ) -> Kernel {
        let PointInputs {
            names, inputs, blocks, ..
        } = point;
        let (dimension, count) = (self.variant.dimension, names.len());
        let with_rates = self.variant.damped && quantity != Quantity::Energy;
        let mut arguments = vec![format!("row: &{}", self.row())];
        if self.variant.has_references() {
            arguments.push(format!("reference: &[f64; {}]", self.references));
        }
        let mut bindings = self.bindings(true, &[]);
        for (argument, components) in ["fields", "rates"].into_iter().zip(inputs) {
            if argument == "fields" || with_rates {
                arguments.push(format!("{argument}: &[[f64; {dimension}]; {count}]"));
                let vectors: Vec<String> = components.iter().map(|c| format!("[{}]", c.join(", "))).collect();
                bindings.push(format!("let [{}] = *{argument};", vectors.join(", ")));
            }
        }
        let matrix = |name: &str, count: usize| format!("{name}: &mut [[f64; {}]; {count}]", dimension * dimension);
        let (word, what) = match quantity {
            Quantity::Force => {
                arguments.push(format!("forces: &mut [[f64; {dimension}]; {count}]"));
                ("force", "the forces on the fields")
            }
            Quantity::Tangent => {
                arguments.push(matrix("stiffness", blocks[0]));
                if with_rates {
                    arguments.push(matrix("damping_matrix", blocks[1]));
                }
                ("tangent", "the blocks of the tangent on the fields")
            }
            Quantity::Energy | Quantity::Reference => {
                arguments.push("energy: &mut f64".to_string());
                ("energy", "the strain energy")
            }
        };
        let name = self.variant.name(self.library);
        Kernel {
            name: format!("{name}_{}_{word}", points.word()),
            doc: vec![format!(
                "Writes {what} {} at a point of weight one on the unit element, for the terms that are integrated at \
                 {points}; fields are derivatives on the unit element.",
                names.join(", ")
            )],
            arguments,
            bindings,
            graph,
            points: None,
            outputs,
            assign: true,
        }
    }

    /// A kernel of the fields at a point that integrates the energy of a material over the section; `pairs` are the fields of
    /// the blocks of stiffness and damping.
    pub fn section_point(
        &self,
        (points, quantity): (Sampling, Quantity),
        point: &PointInputs,
        pairs: [Option<&[(usize, usize)]>; 2],
    ) -> Kernel {
        let mut kernel = self.field_point(points, quantity, Graph::new(), Vec::new(), point);
        let optional = |is_there: bool, text: &str| {
            if is_there {
                format!("Some({text})")
            } else {
                "None".to_string()
            }
        };
        let with_rates = self.variant.damped && quantity != Quantity::Energy;
        kernel.bindings = vec![format!(
            "let point = ::rncf::emitted::SectionPoint {{ length: row.length, fields, before: {}, rates: {} }};",
            optional(self.variant.curved, "&reference[..]"),
            optional(with_rates, "(rates, row.damping)"),
        )];
        kernel.bindings.push(match (quantity, pairs) {
            (Quantity::Force, _) => "row.section.force(&row.material, &point, forces);".to_string(),
            (Quantity::Tangent, [Some(pairs), None]) => {
                format!("row.section.tangent(&row.material, &point, &{pairs:?}, stiffness);")
            }
            (Quantity::Tangent, [Some(pairs), Some(damped)]) => format!(
                "row.section.damped_tangent(&row.material, &point, (&{pairs:?}, stiffness), (&{damped:?}, damping_matrix));"
            ),
            _ => "row.section.energy(&row.material, &point, energy);".to_string(),
        });
        kernel.doc.push(
            "Integrated over the section, of a material with an energy per volume W(E): lateral strains are relaxed at every \
             particle, E is that of the fibre r_x + y r_y' + z r_z' and of the section's axes (THEORY 4.2)."
                .to_string(),
        );
        kernel
    }

    /// The fields at all points in the stress-free shape, which a material with an energy needs.
    pub fn fields_before(variant: &Variant, library: &Library, fields: &FieldKernels) -> Option<(usize, Kernel)> {
        let rule = fields.rules.first()?;
        let count = rule.references * rule.points.count();
        let signature = Signature {
            variant,
            library,
            references: count,
        };
        let mut kernel = signature.elastic(Form::Fields, Quantity::Reference, Graph::new(), None, Vec::new());
        let upper = variant.name(library).to_uppercase();
        kernel.bindings = vec![
            format!("let vectors = {upper}_VECTORS.relative(row.length, q);"),
            format!(
                "for (point, reference) in reference.chunks_exact_mut({}).enumerate() {{ \
                 reference.copy_from_slice({}.fields(point, &vectors).as_flattened()); }}",
                rule.references,
                rule.points.table_of(&upper)
            ),
        ];
        Some((count, kernel))
    }

    /// A kernel that calls those of the fields at the points.
    pub fn by_fields(&self, quantity: Quantity, fields: &FieldKernels) -> Kernel {
        let empty = self.elastic(Form::Fields, quantity, Graph::new(), None, Vec::new());
        let mut kernel = empty;
        kernel.doc.push(format!(
            "Operations: {}.",
            fields.cost(quantity, self.variant.dimension)
        ));
        kernel.bindings = self.calls(quantity, fields);
        kernel
    }

    /// Statements that sum over the points of all rules.
    fn calls(&self, quantity: Quantity, fields: &FieldKernels) -> Vec<String> {
        let name = self.variant.name(self.library);
        let upper = name.to_uppercase();
        let damped = self.variant.damped && quantity != Quantity::Energy;
        let dd = self.variant.dimension * self.variant.dimension;
        let ss = fields.groups.size() * fields.groups.size();
        let mut out = vec![format!("let vectors = {upper}_VECTORS.relative(row.length, q);")];
        if damped {
            out.push(format!("let rates = {upper}_VECTORS.relative(row.length, v);"));
        }
        let sums = |name: &str, symmetric: bool| {
            format!("let mut {name} = [[[0.0; {ss}]; {dd}]; {}];", fields.tiles(symmetric))
        };
        match quantity {
            Quantity::Force => out.push("let mut sums = Default::default();".to_string()),
            Quantity::Tangent => {
                out.push(sums("tiles", !damped));
                if damped {
                    out.push(sums("viscous", true));
                }
            }
            Quantity::Energy | Quantity::Reference => {}
        }
        let mut passed = 0;
        for rule in &fields.rules {
            let (at, count) = (rule.points.table_of(&upper), rule.references);
            let kernel = |word: &str| format!("{name}_{}_{word}", rule.points.word());
            let reference = if self.variant.has_references() {
                format!("::rncf::emitted::array(&reference[{passed} + {count} * point..][..{count}]), ")
            } else {
                String::new()
            };
            passed += rule.references * rule.points.count();
            out.push(match quantity {
                Quantity::Force => format!(
                    "{at}.force(&vectors, {}, |point, fields, rates, forces| {}(row, {reference}fields, {}forces), &mut sums);",
                    if damped { "&rates" } else { "&vectors" },
                    kernel("force"),
                    if damped { "rates, " } else { "" },
                ),
                Quantity::Tangent if damped => format!(
                    "{at}.damped_tangent((&vectors, &rates), (&{at}_STIFFNESS, &mut tiles), (&{at}_DAMPING, &mut viscous), \
                     |point, fields, rates, stiffness, damping_matrix| {}(row, {reference}fields, rates, stiffness, damping_matrix));",
                    kernel("tangent")
                ),
                Quantity::Tangent => format!(
                    "{at}.tangent(&vectors, (&{at}_STIFFNESS, &mut tiles), \
                     |point, fields, stiffness| {}(row, {reference}fields, stiffness));",
                    kernel("tangent")
                ),
                Quantity::Energy | Quantity::Reference => format!(
                    "*energy += {at}.integral(&vectors, |point, fields| {{ let mut density = 0.0; {}(row, {reference}fields, \
                     &mut density); density }});",
                    kernel("energy")
                ),
            });
        }
        match quantity {
            Quantity::Force => out.push(format!("{upper}_VECTORS.add_force(row.length, &sums, force);")),
            Quantity::Tangent => {
                let add = if damped { "add_general" } else { "add_symmetric" };
                out.push(format!("{upper}_VECTORS.{add}(row.length, &tiles, stiffness);"));
                if damped {
                    out.push(format!(
                        "{upper}_VECTORS.add_symmetric(row.length, &viscous, damping_matrix);"
                    ));
                }
            }
            Quantity::Energy | Quantity::Reference => {}
        }
        out
    }

    /// Wraps the expressions of the mass matrix.
    pub fn mass(&self, graph: Graph, outputs: Vec<(String, Id)>) -> Kernel {
        let count = self.variant.vectors(self.library).len();
        Kernel {
            name: format!("{}_mass", self.variant.name(self.library)),
            doc: vec![
                "Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).".to_string(),
                "Mass tensors integrated exactly.".to_string(),
            ],
            arguments: vec![
                format!("row: &{}", self.row()),
                format!("mass: &mut [f64; {}]", count * count),
            ],
            bindings: self.bindings(false, &[]),
            graph,
            points: None,
            outputs,
            assign: true,
        }
    }

    /// The strain energy in words: terms, coefficients, damping.
    fn energy_text(&self) -> String {
        let element = self.variant.declaration(self.library);
        let choices: Vec<String> = element
            .options
            .iter()
            .zip(&self.variant.options)
            .filter(|(option, choice)| option.values[**choice] != "false")
            .map(|(option, &choice)| format!("{} = {}", option.name, option.values[choice]))
            .collect();
        format!("{}; {}.", element.doc, choices.join(", "))
    }

    fn form_text(&self, form: Form) -> String {
        let element = self.variant.declaration(self.library);
        let count = points(element, self.variant.quadrature);
        let exact = self.variant.quadrature == crate::model::Quadrature::Exact;
        let tensor = "U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the \
                      slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is";
        let points = "U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I \
                      of the fields, force S dI/dq.";
        match form {
            Form::Tensor if exact => format!("{tensor} integrated exactly, unrolled."),
            Form::Tensor => format!("{tensor} integrated with {count}, unrolled."),
            Form::Points => format!("{points} {count}, unrolled."),
            Form::Loop => format!("{points} {count}, in a loop."),
            Form::Fields => {
                let rules: Vec<String> = rules(self.variant, element).iter().map(ToString::to_string).collect();
                format!(
                    "{points} {}, one kernel of the fields at a point for each rule.",
                    rules.join(" and ")
                )
            }
        }
    }
}

/// `cable_planar` to `CablePlanar`.
pub fn camel_case(name: &str) -> String {
    let words = name.split('_').map(|word| {
        let mut letters = word.chars();
        letters
            .next()
            .map(|first| first.to_uppercase().chain(letters).collect::<String>())
            .unwrap_or_default()
    });
    words.collect()
}
