//! Sections: a block of properties, or a shape that has all of them.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::known::{Section, Values};
use super::law::{OF_TABLE, law_property, law_words};
use crate::check::values::quantity::Wanted;
use crate::check::values::scope::Scope;
use crate::check::{Arguments, Check, Shape, fold, say};
use crate::errors::Area;
use crate::joints::algebra::{add, call, divide, multiply, number, subtract};
use crate::model::{Binary, Comparison, Expr as Value, Function, Law, SectionShape};
use crate::parse::tree::{Call, Fields, Item, ItemKind, Keyword};
use crate::suggest;
use crate::vocabulary::{BOTH_AXES, Property, SECTION, SIZES, field_of};

/// Relative size of what counts as round-off of declared properties.
const ROUND_OFF: f64 = 1e-6;

/// A shape of the language.
struct Kind {
    word: &'static str,
    arguments: &'static [&'static str],
    /// Names of the arguments as properties.
    sizes: &'static [&'static str],
    usage: &'static str,
}

const KINDS: [Kind; 3] = [
    Kind {
        word: "circle",
        arguments: &["radius"],
        sizes: &["radius"],
        usage: "circle(radius = 5 mm)",
    },
    Kind {
        word: "tube",
        arguments: &["radius", "thickness"],
        sizes: &["radius", "thickness"],
        usage: "tube(radius = 50 mm, thickness = 2 mm)",
    },
    Kind {
        word: "rectangle",
        arguments: &["y", "z"],
        sizes: &["size_y", "size_z"],
        usage: "rectangle(y = 20 mm, z = 5 mm)",
    },
];

impl Section {
    /// A property of a section of this material; `None` where it is not known.
    pub fn property(&self, name: &str, poisson: Option<&Value>) -> Option<Value> {
        if let Some(value) = self.properties.get(name) {
            return Some(value.clone());
        }
        if !["shear_factor_y", "shear_factor_z"].contains(&name) {
            return None;
        }
        let factor = match &self.shape {
            SectionShape::General { .. } => return None,
            SectionShape::Rectangle { .. } => number(5.0 / 6.0),
            SectionShape::Circle { .. } => shear_factor(poisson?, &number(0.0)),
            SectionShape::Tube { radius, .. } => {
                let inner = self.properties.get("inner_radius")?;
                shear_factor(poisson?, &square(&divide(inner.clone(), radius.clone())))
            }
        };
        Some(folded(factor))
    }

    /// A section that says its stiffness by itself and could not be read.
    fn broken_law() -> Self {
        Self {
            law: Some(Law::default()),
            ..Self::default()
        }
    }

    /// Whether the shear factors depend on Poisson's ratio.
    pub fn needs_poisson(&self) -> bool {
        matches!(self.shape, SectionShape::Circle { .. } | SectionShape::Tube { .. })
    }
}

impl<'a> Check<'a> {
    /// Checks all sections, also those that nothing uses.
    pub(in crate::check) fn sections(&mut self) {
        for item in self.items(Keyword::Section) {
            let section = self.in_loop(item, |check| match &item.kind {
                ItemKind::Section(fields) => Some(check.block(item, fields)),
                ItemKind::NamedSection(call) if OF_TABLE.contains(&call.name.text.as_str()) => Some(
                    check
                        .section_of_table(&item.name.text, call)
                        .unwrap_or_else(Section::broken_law),
                ),
                ItemKind::NamedSection(call) => check.named_section(call),
                _ => None,
            });
            if let Some(section) = section {
                self.sections.insert(item.name.text.as_str(), section);
            }
        }
    }

    /// `section odd { area = ..; .. }`
    fn block(&mut self, item: &Item, fields: &'a Fields) -> Section {
        let vocabulary = || SECTION.iter().filter(|property| !SIZES.contains(&property.name));
        let is_law = |name: &str| law_property(name).is_some();
        if let Some(law) = fields.fields.iter().find(|field| is_law(&field.name.text)) {
            let is_size = |name: &str| property(name).is_some();
            if let Some(size) = fields.fields.iter().find(|field| is_size(&field.name.text)) {
                let message = say::mixed_section(&size.name.text, &law.name.text);
                self.errors.at(size.name.span, message);
                return Section::broken_law();
            }
            let (values, is_whole) = self.property_fields(item, fields, law_words().collect(), law_property);
            let section = is_whole.then(|| self.stiffness_law(&item.name.text, values, item.name.span.into()));
            return section.flatten().unwrap_or_else(Section::broken_law);
        }
        let words = vocabulary().map(|property| property.name).chain(["shear_factor"]);
        let (values, mut is_whole) = self.property_fields(item, fields, words.collect(), property);
        let values = self.on_each_axis(values).unwrap_or_else(|values| {
            is_whole = false;
            values
        });
        let properties = values.iter().map(|(name, (value, _))| (*name, value.clone()));
        let mut section = Section {
            properties: properties.collect(),
            is_whole,
            ..Section::default()
        };
        section.is_whole &= self.is_possible(&section, &values, item);
        let extent = |name| section.properties.get(name).cloned();
        section.shape = SectionShape::General {
            extent: ["extent_y", "extent_z"].map(extent),
        };
        section
    }

    /// Fields with those that stand for both axes as two; the same as an error where an axis has two values, which is reported.
    pub(super) fn on_each_axis(&mut self, values: Values) -> Result<Values, Values> {
        let mut each = Values::new();
        let mut is_right = true;
        for (name, (value, area)) in &values {
            let Some((_, axes)) = BOTH_AXES.iter().find(|(word, _)| *word == *name) else {
                each.insert(name, (value.clone(), *area));
                continue;
            };
            if let Some(other) = axes.iter().find(|axis| values.contains_key(*axis)) {
                self.errors.at(*area, say::sets_both(name, other));
                is_right = false;
            }
            each.extend(axes.map(|axis| (axis, (value.clone(), *area))));
        }
        if is_right { Ok(each) } else { Err(each) }
    }

    /// Whether some section has these properties, with the defaults of the params; reports where none has.
    fn is_possible(&mut self, section: &Section, values: &Values, item: &Item) -> bool {
        let number = |name: &str| {
            Some(self.default(section.properties.get(name)?)).filter(|value| value.is_finite() && *value > 0.0)
        };
        let area_of = |name: &str| values.get(name).map_or(item.name.span.into(), |(_, area)| *area);
        let moments = ["second_moment_y", "second_moment_z"].map(number);
        let mut mistakes = Vec::new();
        if let (Some(torsion), [Some(y), Some(z)]) = (number("torsion_constant"), moments)
            && torsion > (y + z) * (1.0 + ROUND_OFF)
        {
            let polar = format!("{:.4e}", y + z);
            mistakes.push((area_of("torsion_constant"), say::torsion_beyond(&polar)));
        }
        // The fibres of `int Y^2 dA`, the moment about z, are at most as far away as the extent along y.
        for (moment, extent, name) in [(1, "extent_y", "second_moment_z"), (0, "extent_z", "second_moment_y")] {
            if let (Some(moment), Some(area), Some(extent_value)) = (moments[moment], number("area"), number(extent))
                && moment > area * extent_value * extent_value * (1.0 + ROUND_OFF)
            {
                let most = format!("{:.4e}", area * extent_value * extent_value);
                mistakes.push((area_of(name), say::moment_beyond(extent, &most)));
            }
        }
        let is_possible = mistakes.is_empty();
        for (area, message) in mistakes {
            self.errors.at(area, message);
        }
        is_possible
    }

    /// `section shaft = circle(radius = 50 mm);`
    fn named_section(&mut self, call: &'a Call) -> Option<Section> {
        let word = call.name.text.as_str();
        let Some(kind) = KINDS.iter().find(|kind| kind.word == word) else {
            let kinds = KINDS.iter().map(|kind| kind.word).chain(OF_TABLE);
            let message = suggest::unknown("shape of a section", word, kinds);
            self.errors.at(call.name.span, message);
            return None;
        };
        let shape = Shape {
            positional: 0,
            named: kind.arguments,
            required: kind.arguments,
            usage: kind.usage,
        };
        let arguments = self.arguments(call, &shape)?;
        let mut values = BTreeMap::new();
        let mut is_whole = true;
        for (argument, name) in kind.arguments.iter().zip(kind.sizes) {
            match self.size(&arguments, argument, name) {
                Some(value) => drop(values.insert(*name, value)),
                None => is_whole = false,
            }
        }
        if !is_whole {
            return None;
        }
        let size = |name: &str| values[name].clone();
        let shape = match word {
            "circle" => SectionShape::Circle { radius: size("radius") },
            "rectangle" => SectionShape::Rectangle {
                sizes: [size("size_y"), size("size_z")],
            },
            _ => SectionShape::Tube {
                radius: size("radius"),
                thickness: size("thickness"),
            },
        };
        if let SectionShape::Tube { radius, thickness } = &shape {
            let inner = folded(subtract(radius.clone(), thickness.clone()));
            if fold::constant(&inner).is_some_and(|inner| inner.is_nan() || inner <= 0.0) {
                let area = arguments.named.get("thickness").map_or(call.area, |expr| expr.area);
                self.errors.at(area, say::THICKNESS);
                return None;
            }
            values.insert("inner_radius", inner);
        }
        values.extend(of_shape(&shape).into_iter().map(|(name, value)| (name, folded(value))));
        for value in values.values() {
            self.is_finite(value, call.area)?;
            if fold::constant(value) == Some(0.0) {
                self.errors.at(call.area, say::VANISHES);
                return None;
            }
        }
        Some(Section {
            shape,
            properties: values,
            law: None,
            is_whole: true,
        })
    }

    fn size(&mut self, arguments: &Arguments<'a>, argument: &'static str, name: &str) -> Option<Value> {
        let expr = *arguments.named.get(argument)?;
        let wanted = Wanted {
            what: match argument {
                "radius" => "the radius",
                "thickness" => "the thickness",
                "y" => "the size along y",
                _ => "the size along z",
            },
            dimension: [1, 0, 0, 0, 0, 0],
            unit: "m",
        };
        let value = self.along_axis(|check| check.quantity(expr, Scope::Parameter, wanted))?;
        let property = property(name)?;
        match fold::constant(&value) {
            Some(constant) => self
                .range(wanted.what, property.range, constant, expr.area)
                .then_some(value),
            None => Some(value),
        }
    }

    /// The second moment of an element that bends alike in all directions: in a plane with the section's y
    /// axis in it, in space that of both axes.
    pub(in crate::check) fn one_moment(
        &mut self,
        section: &Section,
        (name, element): (&str, &str),
        is_planar: bool,
        area: Area,
    ) -> Option<Value> {
        let [y, z] = ["second_moment_y", "second_moment_z"].map(|name| section.properties.get(name));
        if is_planar {
            return z.cloned();
        }
        let (y, z) = (y?, z?);
        if y != z {
            self.errors.at(area, say::unequal_moments(name, element));
        }
        Some(z.clone())
    }
}

/// A property of a section, or one that stands for both axes.
fn property(word: &str) -> Option<&'static Property> {
    field_of(SECTION, word).map(|(_, property)| property)
}

/// A number where it is one.
fn folded(value: Value) -> Value {
    fold::constant(&value).map_or(value, Value::Number)
}

fn square(value: &Value) -> Value {
    power(value, 2.0)
}

fn power(value: &Value, exponent: f64) -> Value {
    Value::Power(Box::new(value.clone()), Box::new(number(exponent)))
}

fn product(factors: impl IntoIterator<Item = Value>) -> Value {
    factors.into_iter().fold(number(1.0), multiply)
}

/// Area, second moments and torsion constant of a shape.
fn of_shape(shape: &SectionShape) -> Vec<(&'static str, Value)> {
    let (area, [y, z], torsion) = match shape {
        SectionShape::General { .. } => return Vec::new(),
        SectionShape::Circle { radius } => {
            let area = product([number(PI), square(radius)]);
            let quarter = product([number(PI / 4.0), power(radius, 4.0)]);
            let torsion = product([number(PI / 2.0), power(radius, 4.0)]);
            (area, [quarter.clone(), quarter], torsion)
        }
        SectionShape::Tube { radius, thickness } => {
            let inner = subtract(radius.clone(), thickness.clone());
            // pi (R^2 - r^2) without the difference of squares, which loses digits where the wall is thin.
            let area = product([number(PI), thickness.clone(), add(radius.clone(), inner.clone())]);
            let squares = add(square(radius), square(&inner));
            let half = product([area.clone(), divide(squares, number(2.0))]);
            let quarter = divide(half.clone(), number(2.0));
            (area, [quarter.clone(), quarter], half)
        }
        SectionShape::Rectangle { sizes: [y, z] } => {
            let cubed =
                |along: &Value, across: &Value| divide(product([across.clone(), power(along, 3.0)]), number(12.0));
            let area = product([y.clone(), z.clone()]);
            let torsion = Value::If(
                Comparison::Less,
                Box::new(y.clone()),
                Box::new(z.clone()),
                Box::new(rectangle_torsion(z, y)),
                Box::new(rectangle_torsion(y, z)),
            );
            (area, [cubed(z, y), cubed(y, z)], torsion)
        }
    };
    vec![
        ("area", area),
        ("second_moment_y", y),
        ("second_moment_z", z),
        ("torsion_constant", torsion),
    ]
}

/// Torsion constant of a rectangle with the sides a >= b (Saint-Venant's series):
/// `a b^3 (1/3 - 64/pi^5 b/a sum over odd n of tanh(n pi a / 2 b) / n^5)`.
///
/// With `tanh x = 1 - 2 / (e^2x + 1)` the sum is `31/32 zeta(5)` less terms of which two are enough for a
/// relative error below 1e-9.
fn rectangle_torsion(a: &Value, b: &Value) -> Value {
    const ALL: f64 = 1.004_523_762_795_139_6;
    let ratio = divide(a.clone(), b.clone());
    let rest = |n: f64| {
        let growth = call(Function::Exp, multiply(number(n * PI), ratio.clone()));
        divide(number(2.0 / n.powi(5)), add(growth, number(1.0)))
    };
    let sum = subtract(number(ALL), add(rest(1.0), rest(3.0)));
    let series = divide(product([number(64.0 / PI.powi(5)), sum]), ratio.clone());
    product([a.clone(), power(b, 3.0), subtract(number(1.0 / 3.0), series)])
}

/// Cowper's shear factor of a circular tube with the square m of the ratio of its radii; 0 of a full circle:
/// `6 (1 + nu) (1 + m)^2 / ((7 + 6 nu) (1 + m)^2 + (20 + 12 nu) m)`.
fn shear_factor(poisson: &Value, squared_ratio: &Value) -> Value {
    let linear = |constant: f64, slope: f64| add(number(constant), multiply(number(slope), poisson.clone()));
    let whole = match squared_ratio {
        Value::Number(0.0) => number(1.0),
        other => square(&add(number(1.0), other.clone())),
    };
    let above = product([linear(6.0, 6.0), whole.clone()]);
    let below = add(
        product([linear(7.0, 6.0), whole]),
        product([linear(20.0, 12.0), squared_ratio.clone()]),
    );
    Value::Binary(Binary::Divide, Box::new(above), Box::new(below))
}
