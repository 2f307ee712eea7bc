//! The methods of `Parts` for cross-sections: properties of bodies, and the forces on their fields.

use std::borrow::Cow;
use std::fmt::Write;

use super::number::number;
use super::parts::Parts;
use crate::elements::{Coefficient, Interpolant};
use crate::model::fold;
use crate::model::{Body, Expr, SectionShape, Space};
use crate::vocabulary::{DERIVED, Derived, LAW, MATERIAL, Property, Range, SECTION, product_of};

/// Variable with a property's value.
fn variable(name: &str) -> &str {
    // `yield` is a word of Rust.
    if name == "yield" { "yield_stress" } else { name }
}

/// Properties that coefficients alone read.
const ELASTIC: [&str; 7] = [
    "poisson",
    "second_moment",
    "second_moment_y",
    "second_moment_z",
    "torsion_constant",
    "shear_factor_y",
    "shear_factor_z",
];

/// Whether coefficients read a property, or something that follows from it.
fn is_factor(coefficients: &[&Coefficient], name: &str) -> bool {
    let follows = |factor: &str| {
        let derived = DERIVED.iter().find(|derived| derived.name == factor);
        derived.is_some_and(|derived| derived.from.contains(&name))
    };
    let factors = coefficients.iter().flat_map(|coefficient| &coefficient.factors);
    factors.into_iter().any(|factor| *factor == name || follows(factor))
}

/// The properties whose product a coefficient is: of material and section, or the one number of a section that says its stiffness by itself. `None`: the
/// body's material has an energy in their place.
fn factors<'c>(body: &Body, coefficient: &'c Coefficient) -> Option<Cow<'c, [&'static str]>> {
    if coefficient.factors.iter().all(|factor| has(body, factor)) {
        return Some(Cow::Borrowed(&coefficient.factors));
    }
    let number = product_of(&coefficient.factors).filter(|number| body.properties.contains_key(number))?;
    Some(Cow::Owned(vec![number]))
}

/// Whether a body has a property, or those that it follows from.
fn has(body: &Body, name: &str) -> bool {
    let derived = DERIVED.iter().find(|derived| derived.name == name);
    let from = |derived: &Derived| derived.from.iter().all(|name| body.properties.contains_key(name));
    body.properties.contains_key(name) || derived.is_some_and(from)
}

impl Parts<'_> {
    /// A coefficient of an element; zero where the body's material has other properties instead.
    pub fn coefficient(&self, body: &Body, coefficient: &Coefficient) -> String {
        let Some(factors) = factors(body, coefficient) else {
            return "0.0".to_string();
        };
        let scale = coefficient.scale.as_ref().map(|scale| self.expr(scale));
        let factors = factors.iter().map(ToString::to_string);
        let list: Vec<String> = scale.into_iter().chain(factors).collect();
        if list.is_empty() {
            "1.0".to_string()
        } else {
            list.join(" * ")
        }
    }

    /// Statements that bind the properties of a body, each checked, and those that its coefficients derive.
    pub fn properties(&self, body: &Body) -> String {
        let mut text = String::new();
        let element = &self.library.elements[body.element.0];
        let coefficients = element.coefficients_in(body.space.dimension(), &body.options);
        let (of_section, of_material) = (("section", &body.section_name), ("material", &body.material_name));
        let vocabularies: &[(&[Property], _)] = if body.has_own_stiffness() {
            &[(&LAW, of_section)]
        } else {
            &[(MATERIAL, of_material), (SECTION, of_section)]
        };
        for (vocabulary, (kind, owner)) in vocabularies {
            for property in *vocabulary {
                // What is not given is no more than its default, and nothing reads it.
                let default = property.default.map(Expr::Number);
                let is_read = !ELASTIC.contains(&property.name) || is_factor(&coefficients, property.name);
                let given = body.properties.get(property.name).filter(|_| is_read);
                if let Some(value) = given.filter(|value| default.as_ref() != Some(value)) {
                    let value = check(property, kind, owner, &self.expr(value));
                    let _ = writeln!(text, "let {} = {value};", variable(property.name));
                }
            }
        }
        for derived in DERIVED {
            let used = coefficients
                .iter()
                .any(|coefficient| coefficient.factors.contains(&derived.name));
            if used && has(body, derived.name) {
                let _ = writeln!(text, "let {} = {};", derived.name, derived.value);
            }
        }
        text
    }

    /// Checks that some section has the declared properties, where they depend on params; constants are checked already, and
    /// what varies along the axis where it is evaluated.
    pub fn section_checks(&self) -> String {
        let mut text = String::new();
        for body in self.model.bodies.iter().filter(|body| !body.varies()) {
            let check = self.section_check(body);
            let check = match body.differs() && !check.is_empty() {
                true => self.in_loop(body.repeat, &check),
                false => check,
            };
            // Several bodies have one section.
            if !text.contains(&check) {
                text += &check;
            }
        }
        text
    }

    /// The check of one body's section.
    pub(super) fn section_check(&self, body: &Body) -> String {
        const NAMES: [&str; 6] = [
            "area",
            "second_moment_y",
            "second_moment_z",
            "torsion_constant",
            "extent_y",
            "extent_z",
        ];
        let SectionShape::General { extent } = &body.shape else {
            return String::new();
        };
        let given = NAMES.map(|name| match name {
            "extent_y" => extent[0].as_ref(),
            "extent_z" => extent[1].as_ref(),
            // Of a centre line in space both moments are equal; that of a planar body is about the normal of its plane.
            "second_moment_y" if body.space == Space::Spatial => body
                .properties
                .get(name)
                .or_else(|| body.properties.get("second_moment")),
            "second_moment_z" => body
                .properties
                .get(name)
                .or_else(|| body.properties.get("second_moment")),
            _ => body.properties.get(name),
        });
        if given.iter().flatten().all(|value| fold::constant(value).is_some()) {
            return String::new();
        }
        let values = given.map(|value| value.map_or("f64::NAN".to_string(), |value| self.expr(value)));
        format!(
            "::rncf::emitted::section(\"section `{}`\", [{}])?;\n",
            body.section_name,
            values.join(", ")
        )
    }

    /// Constants of a body's sections, its fields, and the forces on them.
    pub fn sections(&self) -> String {
        let section = self.by_body(|index, body| self.index(body).to_string() + &self.section(index, body));
        let fields = self.by_body(|_, body| {
            let element = &self.library.elements[body.element.0];
            let fields = element.fields_in(body.space.dimension());
            let fields: Vec<String> = fields
                .map(|field| format!("(::rncf::emitted::Interpolant::{:?}, {})", field.of, field.order))
                .collect();
            format!("&[{}]", fields.join(", "))
        });
        let forces = self.by_body(|index, body| {
            let variant = self.variant(index);
            let array = "::rncf::emitted::array";
            let rates = if variant.variant.damped {
                format!("{array}(rates), ")
            } else {
                String::new()
            };
            let kernel = &variant.field_forces.name;
            if variant.variant.varying {
                return self.field_forces_varying(body, kernel, &rates);
            }
            format!(
                "{kernel}(&{}, {array}(stress_free), {array}(fields), {rates}{array}_mut(forces));",
                self.row(body)
            )
        });
        let kind = self.kind();
        format!(
            "fn section(&self, body: usize, x: f64, length: f64) -> ::rncf::emitted::SectionSpec {{\n{kind}let model = &self.model;\n{section}}}\n\
             fn fields(&self, body: usize) -> &'static [(::rncf::emitted::Interpolant, usize)] {{\n{kind}{fields}}}\n\
             fn field_forces(&self, body: usize, at: [f64; 2], stress_free: &[f64], fields: &[f64], rates: &[f64], forces: &mut [f64]) {{\n{kind}{forces}}}\n"
        )
    }

    /// How much more a moment turns a curved axis than a thin beam's, in parts `I curvature^2 / A`: bending that is measured by `r_x x r_xx` or `r_x . r_y'`
    /// grows with the stretch, which on a curved axis couples both (docs/elements.md, curved axes).
    fn softness_of_curves(&self, index: usize) -> f64 {
        let variant = &self.variant(index).variant;
        let element = variant.declaration(self.library);
        let chosen = |name: &str| {
            let mut options = element.options.iter().zip(&variant.options);
            let (option, &value) = options.find(|(option, _)| option.name == name)?;
            option.values.get(value).copied()
        };
        let has_section = element.vectors.iter().any(|vector| vector.of != Interpolant::Position);
        match chosen("bending") {
            _ if has_section && !element.of_stiffness => 2.0,
            Some("polynomial") if element.is_of_library => 4.0,
            _ => 0.0,
        }
    }

    /// The larger stiffness of bending of a section that says it by itself over that of the axis.
    fn square_of_gyration(&self, body: &Body) -> String {
        let fields = body.law.as_ref().map_or(&body.properties, |law| &law.fields);
        let value = |names: [&str; 2]| {
            names
                .iter()
                .find_map(|name| fields.get(name))
                .map(|value| self.expr(value))
        };
        let bending = [["EIy", "K55"], ["EIz", "K66"]].map(value);
        match (bending, value(["EA", "K11"])) {
            ([Some(y), Some(z)], Some(axial)) if y != z => format!("f64::max({y}, {z}) / ({axial})"),
            ([_, Some(bending)] | [Some(bending), _], Some(axial)) => format!("({bending}) / ({axial})"),
            _ => "0.0".to_string(),
        }
    }

    fn section(&self, index: usize, body: &Body) -> String {
        let given = |name: &str| body.properties.get(name).map(|value| self.expr(value));
        let property = |names: &[&str]| {
            names
                .iter()
                .find_map(|name| given(name))
                .unwrap_or_else(|| "0.0".to_string())
        };
        let option = |value: &Option<Expr>| match value {
            Some(value) => format!("Some({})", self.expr(value)),
            None => "None".to_string(),
        };
        let shape = match &body.shape {
            _ if body.has_own_stiffness() => {
                format!("Numbers {{ square_of_gyration: {} }}", self.square_of_gyration(body))
            }
            SectionShape::General { extent: [y, z] } => {
                let factors = ["shear_factor_y", "shear_factor_z"].map(|name| property(&[name, "shear_factor"]));
                format!(
                    "General {{ extent: [{}, {}], shear_factors: [{}] }}",
                    option(y),
                    option(z),
                    factors.join(", ")
                )
            }
            SectionShape::Circle { radius } => format!("Circle {{ radius: {} }}", self.expr(radius)),
            SectionShape::Tube { radius, thickness } => format!(
                "Tube {{ radius: {}, thickness: {} }}",
                self.expr(radius),
                self.expr(thickness)
            ),
            SectionShape::Rectangle { sizes } => format!("Rectangle {{ sizes: {} }}", self.array(sizes)),
        };
        let young_over_shear = match (given("young"), given("poisson")) {
            (Some(_), Some(poisson)) => format!("2.0 * (1.0 + {poisson})"),
            _ => "0.0".to_string(),
        };
        let yield_stress = option(&body.properties.get("yield").cloned());
        format!(
            "::rncf::emitted::SectionSpec {{ shape: ::rncf::emitted::SectionShape::{shape}, area: {}, second_moments: [{}, {}], torsion_constant: {}, young_over_shear: {young_over_shear}, softness_of_curves: {}, yield_stress: {yield_stress}, material: {:?} }}",
            property(&["area"]),
            property(&["second_moment_y", "second_moment"]),
            property(&["second_moment_z", "second_moment"]),
            property(&["torsion_constant"]),
            number(self.softness_of_curves(index)),
            body.material_name
        )
    }
}

/// A property's value, checked when the model is built.
fn check(property: &Property, kind: &str, owner: &str, value: &str) -> String {
    let function = match property.range {
        Range::Positive => "positive",
        Range::NonNegative => "non_negative",
        Range::Part => "part",
        Range::Poisson => "poisson",
        Range::Any => "finite",
    };
    format!(
        "::rncf::emitted::{function}(\"{kind} `{owner}`\", \"{}\", {value}, \"{}\")?",
        property.name, property.unit
    )
}
