//! Bodies whose properties vary along the axis: tables, coefficients at points, masses element by element.

use std::fmt::Write;

use super::number::number;
use super::parts::Parts;
use crate::elements::Interpolant;
use crate::lower::camel_case;
use crate::lower::elastic::kept;
use crate::model::{Between, Body, Expr, Law, Model, NodeAt, Piece, Stations, Table, fold};
use crate::units::Dimension;
use crate::vocabulary::{CENTRES, DAMPINGS, MASS_ENTRIES, MASSES, STIFFNESS_ENTRIES};

/// Statics with the tables of a model.
pub fn tables(model: &Model) -> String {
    let list = |values: &[f64]| values.iter().map(|&value| number(value)).collect::<Vec<_>>().join(", ");
    let mut text = String::new();
    for table in &model.tables {
        let columns: Vec<String> = table
            .columns
            .iter()
            .map(|column| format!("&[{}]", list(&column.values)))
            .collect();
        let between = match table.between {
            Between::Line => "Line".to_string(),
            Between::Monotone => "Monotone".to_string(),
            Between::Spline | Between::Clamped | Between::Periodic => {
                let slopes = table
                    .columns
                    .iter()
                    .map(|column| format!("&[{}]", list(&column.slopes)));
                format!("{:?}(&[{}])", table.between, slopes.collect::<Vec<_>>().join(", "))
            }
        };
        let names: Vec<&str> = table.columns.iter().map(|column| column.name.as_str()).collect();
        let _ = writeln!(
            text,
            "/// Table `{}`: {}.\npub static {}: ::rncf::emitted::Table = ::rncf::emitted::Table {{ name: {:?}, places: &[{}], is_relative: {}, between: ::rncf::emitted::Between::{}, columns: &[{}] }};",
            table.name,
            names.join(", "),
            table.constant(),
            table.name,
            list(&table.places),
            table.is_relative,
            between,
            columns.join(", ")
        );
        if table.is_param {
            text += &form(table);
        }
    }
    text
}

/// What the files that stand for a table must have.
fn form(table: &Table) -> String {
    let columns = table.columns.iter().map(|column| {
        let name = column.header.as_ref().unwrap_or(&column.name);
        let unit = Dimension::of(column.dimension).symbol(column.dimension[5] != 0);
        format!(
            "::rncf::emitted::FileColumn {{ name: {name:?}, unit: {unit:?}, dimension: {:?} }}",
            column.dimension
        )
    });
    format!(
        "/// What a file for `{0}` has.\npub static {1}: ::rncf::emitted::TableForm = ::rncf::emitted::TableForm {{ table: &{2}, file: {3:?}, columns: &[{4}], places: &{5:?}, alike: &{6:?} }};\n",
        table.name,
        table.form(),
        table.constant(),
        table.file.as_deref().unwrap_or_default(),
        columns.collect::<Vec<_>>().join(", "),
        table.placed_by,
        table.alike
    )
}

/// The index as the last argument of the function along the axis of a body that depends on it.
fn repetition(body: &Body) -> &'static str {
    if body.differs() { ", index" } else { "" }
}

/// The properties of a body's section and material, with their names.
fn given(body: &Body) -> impl Iterator<Item = (&'static str, &Expr)> {
    let fields = body.law.iter().flat_map(|law| &law.fields);
    body.properties.iter().chain(fields).map(|(name, value)| (*name, value))
}

impl Parts<'_> {
    /// Fractions of the axis at the nodes.
    pub(super) fn stations(&self, body: &Body) -> String {
        match &body.stations {
            None => "::std::vec::Vec::new()".to_string(),
            Some(Stations::Rows { table, each }) => format!(
                "{}.stations({}.length(), {})",
                self.model.tables[table.0].reference(),
                self.line(body),
                self.count(each)
            ),
            Some(Stations::Places(places)) => {
                format!(
                    "::rncf::emitted::stations_at({}.length(), {}, &{})",
                    self.line(body),
                    self.count(&body.count),
                    self.places(places, &self.line(body))
                )
            }
        }
    }

    /// A list of places, those of loops once for each repetition.
    fn places(&self, places: &[NodeAt], line: &str) -> String {
        let (mut single, mut repeated) = (Vec::new(), Vec::new());
        for NodeAt { place, is_part, over } in places {
            let mut place = self.expr(place);
            if *is_part {
                place = format!("({place}) * {line}.length()");
            }
            match over {
                None => single.push(place),
                Some(repeat) => repeated.push(format!(
                    "(0..self.counts[{}]).map(|instance| {{\nlet index = instance as f64;\n{place}\n}}).collect::<::std::vec::Vec<f64>>()",
                    repeat.0
                )),
            }
        }
        let single = format!("[{}]", single.join(", "));
        if repeated.is_empty() {
            return single;
        }
        format!("[::std::vec::Vec::from({single}), {}].concat()", repeated.join(", "))
    }

    /// Of a piece of an axis with corners: the place and the length of the whole axis instead of its own.
    fn along_whole(&self, body: &Body) -> String {
        match &body.piece {
            None => String::new(),
            Some(Piece { from, whole }) => {
                format!("let (x, length) = (x + {}, {});\n", self.expr(from), self.expr(whole))
            }
        }
    }

    /// Twist of the section along the axis.
    pub(super) fn twist(&self, body: &Body) -> String {
        let twist = self.expr(&body.twist);
        if !fold::has_arclength(&body.twist) {
            return format!("::rncf::emitted::Twist::even({twist})");
        }
        format!(
            "{{ let (model, length) = (model.clone(), {}.length()); ::rncf::emitted::Twist::along(move |u| {{ let x = u * length; {}{twist} }}) }}",
            self.line(body),
            self.along_whole(body)
        )
    }

    /// Functions that give coefficients and masses per length of a section at an arclength.
    pub(super) fn along(&self) -> String {
        let mut text = String::new();
        for (index, body) in self.model.bodies.iter().enumerate().filter(|(_, body)| body.varies()) {
            let variant = &self.variant(index).variant;
            let coefficients = variant.varying_coefficients(self.library);
            let (statements, values) = match &body.law {
                Some(law) => {
                    let coefficients = if law.is_viscous() {
                        format!("law.viscous_coefficients([{}])", self.law_values(law, DAMPINGS))
                    } else {
                        "law.coefficients()".to_string()
                    };
                    (self.law(body, law), format!("({coefficients}, law.masses())"))
                }
                None => {
                    let element = variant.declaration(self.library);
                    let values: Vec<String> = coefficients.iter().map(|one| self.coefficient(body, one)).collect();
                    let mass = |of: Interpolant| {
                        let found = element.inertia_in(variant.dimension).find(|one| one.of == of);
                        let found = found
                            .and_then(|one| element.coefficients.iter().find(|other| other.name == one.coefficient));
                        found.map_or("0.0".to_string(), |one| self.coefficient(body, one))
                    };
                    let masses = [
                        mass(Interpolant::Position),
                        "0.0".into(),
                        "0.0".into(),
                        mass(Interpolant::SectionY),
                        mass(Interpolant::SectionZ),
                        "0.0".into(),
                    ];
                    (
                        self.properties(body) + &self.section_check(body),
                        format!("([{}], [{}])", values.join(", "), masses.join(", ")),
                    )
                }
            };
            let repetition = if body.differs() { ", index: f64" } else { "" };
            let _ = writeln!(
                text,
                "/// Coefficients of body `{3}` at the arclength x (m) of its axis, and its masses per length that move with r r, r r_y, r r_z, r_y r_y, r_z r_z, r_y r_z.\n\
                 pub fn along_{0}(model: &{1}, x: f64, length: f64{repetition}) -> ::std::result::Result<([f64; {2}], [f64; 6]), ::rncf::ModelError> {{\n\
                 {4}{statements}Ok({values})\n}}",
                body.identifier(),
                self.model.name,
                coefficients.len(),
                body.name,
                self.along_whole(body)
            );
        }
        text
    }

    /// Values of fields of a law, those that are not given being zero.
    fn law_values(&self, law: &Law, names: &[&'static str]) -> String {
        let value = |name: &&'static str| law.fields.get(name).map_or("0.0".to_string(), |value| self.expr(value));
        names.iter().map(value).collect::<Vec<_>>().join(", ")
    }

    fn law(&self, body: &Body, law: &Law) -> String {
        let values = |names: &[&'static str]| self.law_values(law, names);
        let stiffness = if law.is_matrix {
            format!("Stiffness::Matrix([{}])", values(STIFFNESS_ENTRIES))
        } else {
            format!("Stiffness::Centres([{}])", values(CENTRES))
        };
        let mass = if law.has_mass_matrix {
            format!("Mass::Matrix([{}])", values(MASS_ENTRIES))
        } else {
            format!("Mass::Centre([{}])", values(MASSES))
        };
        format!(
            "let law = ::rncf::emitted::SectionLaw::new({:?}, ::rncf::emitted::{stiffness}, ::rncf::emitted::{mass})?;\n",
            body.section_name
        )
    }

    /// A table as a reference that lives as long as the program.
    pub(super) fn table_itself(&self, table: usize, model: &str) -> String {
        let table = &self.model.tables[table];
        if table.is_param {
            format!("{model}.{}.table()", table.name)
        } else {
            format!("&{}", table.constant())
        }
    }

    /// The tables that a body reads.
    fn tables_of(&self, body: &Body) -> Vec<usize> {
        let mut tables: Vec<usize> = given(body)
            .map(|(_, value)| value)
            .chain([&body.twist])
            .flat_map(fold::tables)
            .map(|table| table.0)
            .collect();
        tables.extend(body.stations.iter().filter_map(|stations| match stations {
            Stations::Rows { table, .. } => Some(table.0),
            Stations::Places(_) => None,
        }));
        tables.sort_unstable();
        tables.dedup();
        tables
    }

    /// Constants of a body whose elements differ.
    pub(super) fn prepare_varying(&self, index: usize, body: &Body) -> String {
        let kernels = self.variant(index);
        let variant = &kernels.variant;
        let (row, size) = (camel_case(&kernels.name), variant.size(self.library));
        let coefficients = variant.varying_coefficients(self.library).len();
        let (_, places) = kept(variant, self.library);
        let mut text = "let length = nodes[nodes.len() - 1];\n".to_string();
        text += self.index(body);
        let repetition = repetition(body);
        let whole = match &body.piece {
            None => "length".to_string(),
            Some(piece) => self.expr(&piece.whole),
        };
        for table in self.tables_of(body) {
            let _ = writeln!(
                text,
                "{}.check({:?}, {whole})?;",
                self.model.tables[table].reference(),
                body.name
            );
        }
        let _ = writeln!(
            text,
            "let at = |x: f64| along_{}(model, x, length{repetition}).map_err(|error| ::rncf::ModelError::new(format!(\"{{error}}; at x = {{x:.6}} m of body `{}`\")));",
            body.identifier(),
            body.name
        );
        // Of files that a run names, it is the row that is told.
        let from = body
            .piece
            .as_ref()
            .map_or("0.0".to_string(), |piece| self.expr(&piece.from));
        for table in self
            .tables_of(body)
            .into_iter()
            .filter(|&table| self.model.tables[table].is_param)
        {
            let _ = writeln!(
                text,
                "{}.check_rows([{from}, length, {whole}], |x| along_{}(model, x, length{repetition}).map(|_| ()))?;",
                self.model.tables[table].reference(),
                body.identifier()
            );
        }
        let damping = body.properties.get("damping").filter(|_| variant.damped);
        let damping = damping.map_or(String::new(), |value| format!(", damping: {}", self.expr(value)));
        text += self.at_start(body);
        let timed = variant.coefficients(self.library).into_iter();
        let timed = timed.map(|one| format!(", {}: {}", one.name, self.coefficient(body, one)));
        let timed: String = timed.collect();
        let reference = match &kernels.elastic.reference {
            Some(kernel) => format!(
                "{}(&row, ::rncf::emitted::array(shape), &mut reference);\n",
                kernel.name
            ),
            None => String::new(),
        };
        let shapes = kernels.shapes.iter().filter_map(|(of, orders)| {
            let kernel = &orders.first()?.name;
            Some(format!(
                "::rncf::emitted::Interpolant::{of:?} => {kernel}(row.length, xi, ::rncf::emitted::array_mut(weights)),\n"
            ))
        });
        let shapes: String = shapes.collect();
        let points: Vec<String> = places
            .iter()
            .map(|(place, xi)| format!("({place}, {})", number(*xi)))
            .collect();
        let vectors = variant.vectors(self.library).len();
        let _ = write!(
            text,
            "let (mut rows, mut references, mut masses) = (::std::vec::Vec::new(), ::std::vec::Vec::new(), ::std::vec::Vec::new());\n\
             for (nodes, shape) in nodes.windows(2).zip(shape.chunks_exact({size})) {{\n\
             let row = {row} {{ length: nodes[1] - nodes[0]{damping}{timed} }};\n\
             let mut reference = [0.0; {kept}];\n\
             for (place, xi) in [{points}] {{\n\
             let (coefficients, _) = at(nodes[0] + xi * row.length)?;\n\
             reference[place..place + {coefficients}].copy_from_slice(&coefficients);\n}}\n\
             {reference}\
             masses.push(::rncf::emitted::mass_along({vectors}, row.length, |xi| Ok(at(nodes[0] + xi * row.length)?.1), |of, xi, weights| match of {{\n{shapes}\
             #[allow(unreachable_patterns)]\n_ => {{}}\n}})?);\n\
             rows.push(row);\nreferences.push(reference);\n}}\n",
            kept = kernels.elastic.kept,
            points = points.join(", "),
        );
        for (what, list) in [("row", "rows"), ("reference", "references"), ("mass", "masses")] {
            text += &self.keep(body, what, list);
        }
        text
    }

    /// Which bodies have elements that differ.
    pub(super) fn varies(&self) -> String {
        if !self.model.bodies.iter().any(Body::varies) {
            return "fn varies(&self, body: usize) -> bool { false }\n".to_string();
        }
        let kind = self.kind();
        let arms = self.by_body(|_, body| format!("{}", body.varies()));
        format!("fn varies(&self, body: usize) -> bool {{\n{kind}{arms}}}\n")
    }

    /// The tables that bodies read.
    pub(super) fn read_tables(&self) -> String {
        if self.model.tables.is_empty() {
            return "fn tables(&self, body: usize) -> ::std::vec::Vec<&'static ::rncf::emitted::Table> { ::std::vec::Vec::new() }\n".to_string();
        }
        let kind = self.kind();
        let arms = self.by_body(|_, body| {
            let tables = self.tables_of(body).into_iter();
            let names: Vec<String> = tables.map(|table| self.table_itself(table, "self.model")).collect();
            format!("::std::vec::Vec::from([{}])", names.join(", "))
        });
        format!(
            "fn tables(&self, body: usize) -> ::std::vec::Vec<&'static ::rncf::emitted::Table> {{\n{kind}{arms}}}\n"
        )
    }

    /// What bodies have at a place of their axes.
    pub(super) fn properties_along(&self) -> String {
        if !self.model.bodies.iter().any(Body::varies) {
            return "fn properties(&self, body: usize, x: f64, length: f64) -> ::std::vec::Vec<(&'static str, f64)> { ::std::vec::Vec::new() }\n"
                .to_string();
        }
        let kind = self.kind();
        let arms = self.by_body(|_, body| {
            let along = given(body).filter(|(_, value)| fold::has_arclength(value));
            let along: Vec<String> = along
                .map(|(name, value)| format!("({name:?}, {})", self.expr(value)))
                .collect();
            if along.is_empty() {
                return "::std::vec::Vec::new()".to_string();
            }
            format!(
                "{}{}::std::vec::Vec::from([{}])",
                self.index(body),
                self.along_whole(body),
                along.join(", ")
            )
        });
        format!(
            "fn properties(&self, body: usize, x: f64, length: f64) -> ::std::vec::Vec<(&'static str, f64)> {{\nlet model = &self.model;\n{kind}{arms}}}\n"
        )
    }

    /// Forces on the fields of a body whose coefficients vary.
    pub(super) fn field_forces_varying(&self, body: &Body, kernel: &str, rates: &str) -> String {
        let instance = if body.repeat.is_some() { "[instance]" } else { "" };
        let rows = format!("self.row_{}{instance}", body.identifier());
        let array = "::rncf::emitted::array";
        format!(
            "{}let [x, length] = at;\nif let Ok((coefficients, _)) = along_{}(&self.model, x, length{}) {{\n\
             {kernel}(&{rows}[0], &coefficients, {array}(stress_free), {array}(fields), {rates}{array}_mut(forces));\n}}",
            self.index(body),
            body.identifier(),
            repetition(body)
        )
    }
}
