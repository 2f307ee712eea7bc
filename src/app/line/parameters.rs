//! Parameters and other quantities as text: `omega_s="40 rad/s"`, `elements=24`, `--t-end "20 s"`.

use std::path::Path;

use super::command::Command;
use crate::app::writing::numbers::in_unit;
use crate::emitted::{TableFile, TableForm};
use crate::nearest::nearest;
use crate::units::{Dimension, Number, SECOND, Unit};
use crate::{AnyModel, Param, ParamKind};

/// What is given of a parameter: one value, or several in some way.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) enum Values {
    /// At least two different values, in the order in which they are given.
    List(Vec<f64>),
    /// All from the first to the second one; the third says into how many values a sweep divides it.
    Range(f64, f64, Option<u32>),
    /// Normally distributed, with mean and standard deviation.
    Normal(f64, f64),
}

/// A parameter that is given more than one value.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Varied {
    /// Index in [`Model::params`].
    pub param: usize,
    /// Its values, SI.
    pub values: Values,
}

/// Several values of a parameter, each of which is tried.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct List {
    /// Index in [`Model::params`].
    pub param: usize,
    /// At least two different values, SI, in the order in which they are given.
    pub values: Vec<f64>,
}

/// Sets the parameters of a model from words `name=value`, and returns those with several values: `name=from..to`,
/// `name=from..to in 9`, `name=a,b,c`, `name=normal(mean, deviation)`; they are set to their last value, or the mean.
///
/// # Errors
/// All mistakes, one a line: each with the word and what would be right.
pub(in crate::app) fn assign(model: &mut dyn AnyModel, words: &[String]) -> Result<Vec<Varied>, String> {
    let mut given = vec![false; model.params().len()];
    let (mut mistakes, mut varied) = (Vec::new(), Vec::new());
    for word in words {
        let (param, value) = match read(model, word) {
            Ok(found) => found,
            Err(mistake) => {
                mistakes.push(mistake);
                continue;
            }
        };
        if std::mem::replace(&mut given[param], true) {
            mistakes.push(format!("`{}` is given twice", model.params()[param].name));
            continue;
        }
        let last = match &value {
            Given::One(value) | Given::Several(Values::Range(_, value, _) | Values::Normal(value, _)) => *value,
            Given::Several(Values::List(values)) => values[values.len() - 1],
        };
        model.set(param, last);
        if let Given::Several(values) = value {
            varied.push(Varied { param, values });
        }
    }
    if mistakes.is_empty() {
        Ok(varied)
    } else {
        Err(mistakes.join("\n"))
    }
}

/// What a word gives, SI.
enum Given {
    One(f64),
    Several(Values),
}

/// The index of the parameter with its value or values.
fn read(model: &dyn AnyModel, word: &str) -> Result<(usize, Given), String> {
    let Some((name, text)) = word.split_once('=') else {
        return Err(stray(model, word));
    };
    let (name, text) = (name.trim(), text.trim());
    let Some(index) = model.params().iter().position(|param| param.name == name) else {
        return Err(unknown(model, name));
    };
    let param = &model.params()[index];
    if let ParamKind::Table(form) = param.kind {
        let given = files(form, text).map_err(|mistake| format!("`{name}={text}`: {mistake}"))?;
        return Ok((index, given));
    }
    let given = if let Some(inside) = text.strip_prefix("normal(") {
        normal(param, inside).map(Given::Several)
    } else if text.contains(',') {
        list(param, text).map(Given::Several)
    } else if let Some((from, to)) = text.split_once("..") {
        range(param, from, to).map(Given::Several)
    } else {
        value(param, text).map(Given::One)
    };
    let given = given.map_err(|mistake| {
        let example = format!("{name}={}", quoted(&in_unit(param, param.default)));
        format!("`{name}={text}`: {mistake} (e.g. `{example}`)")
    })?;
    Ok((index, given))
}

fn value(param: &Param, text: &str) -> Result<f64, String> {
    match param.kind {
        ParamKind::Count => count(text),
        ParamKind::Quantity => quantity(text, param.unit, param.dimension),
        ParamKind::Table(form) => file(form, text),
    }
}

/// The number of a file with a table. The path of the declaration is, where it leads nowhere from here, the table that the model was
/// built with.
fn file(form: &'static TableForm, text: &str) -> Result<f64, String> {
    if !Path::new(text).exists() && text == form.file {
        return Ok(0.0);
    }
    let read = TableFile::declared(form).read(text);
    Ok(read.map_err(|error| error.to_string())?.number())
}

/// One file, or several with commas between them; a file may have commas in its name.
fn files(form: &'static TableForm, text: &str) -> Result<Given, String> {
    if Path::new(text).exists() || text == form.file || !text.contains(',') {
        return file(form, text).map(Given::One);
    }
    let numbers: Result<Vec<f64>, String> = text.split(',').map(|path| file(form, path.trim())).collect();
    listed(numbers?).map(Given::Several)
}

/// A value whose unit may stand behind a later one.
fn value_in(param: &Param, text: &str, unit: &str) -> Result<f64, String> {
    let text = text.trim();
    let is_bare = Number::split(text).is_some_and(|(_, unit)| unit.is_empty());
    if is_bare && !unit.is_empty() {
        return value(param, &format!("{text} {unit}"));
    }
    value(param, text)
}

fn list(param: &Param, text: &str) -> Result<Values, String> {
    let last = text.rsplit(',').next().and_then(Number::split);
    let unit = last.map_or("", |(_, unit)| unit);
    let values: Result<Vec<f64>, String> = text.split(',').map(|text| value_in(param, text, unit)).collect();
    listed(values?)
}

fn listed(values: Vec<f64>) -> Result<Values, String> {
    if (1..values.len()).any(|i| values[..i].contains(&values[i])) {
        return Err("a value is given twice".into());
    }
    Ok(Values::List(values))
}

fn range(param: &Param, from: &str, to: &str) -> Result<Values, String> {
    if param.kind == ParamKind::Count {
        return Err("a count does not change continuously: give one value, or a list".into());
    }
    let (to, parts) = match to.rsplit_once(" in ") {
        Some((to, parts)) => (to.trim(), Some(parts.trim())),
        None => (to, None),
    };
    let divided = |text: &str| match text.parse::<u32>() {
        Ok(number) if number >= 2 => Ok(number),
        _ => Err(format!(
            "`in {text}`: a whole number of at least 2 says into how many values"
        )),
    };
    let parts = parts.map(divided).transpose()?;
    let unit = Number::split(to).map_or("", |(_, unit)| unit);
    let (from, to) = (value_in(param, from, unit)?, value(param, to)?);
    if from == to {
        return Err("the range begins where it ends: give one value".into());
    }
    Ok(Values::Range(from, to, parts))
}

/// `mean, deviation) unit`
fn normal(param: &Param, inside: &str) -> Result<Values, String> {
    const FORM: &str = "a distribution is written `normal(mean, deviation) unit`";
    if param.kind == ParamKind::Count {
        return Err("a count does not change continuously: give one value, or a list".into());
    }
    let (inside, unit) = inside.split_once(')').ok_or(FORM)?;
    let (mean, deviation) = inside.split_once(',').ok_or(FORM)?;
    let unit = unit.trim();
    let mean = value_in(param, mean, unit)?;
    let deviation = value_in(param, deviation, unit)?;
    // A temperature in degrees has another zero than SI; none of the units here has.
    if deviation <= 0.0 {
        return Err("the standard deviation must be positive".into());
    }
    Ok(Values::Normal(mean, deviation))
}

fn stray(model: &dyn AnyModel, word: &str) -> String {
    if Command::ALL.iter().any(|command| command.name() == word) {
        return format!("`{word}` is a command and stands before what it is given: `{word} name=value`");
    }
    if let Some(command) = nearest(word, Command::ALL.map(Command::name)) {
        return format!("`{word}` is not a command; did you mean `{command}`? A command comes first");
    }
    let example = model
        .params()
        .iter()
        .find(|param| param.kind == ParamKind::Quantity)
        .map(|param| format!("{}={}", param.name, quoted(&in_unit(param, param.default))));
    match (Unit::parse(word), example) {
        (Ok(_), Some(example)) => format!("`{word}` stands alone: quote a value together with its unit, `{example}`"),
        _ => {
            let names = Command::ALL.map(Command::name).join(", ");
            format!("`{word}` is neither a command ({names}) nor `name=value`")
        }
    }
}

fn unknown(model: &dyn AnyModel, name: &str) -> String {
    let names: Vec<_> = model.params().iter().map(|param| param.name).collect();
    match nearest(name, names.iter().copied()) {
        Some(near) => format!("{} has no parameter `{name}`; did you mean `{near}`?", model.name()),
        None if names.is_empty() => format!("{} has no parameter `{name}`; it has none at all", model.name()),
        None => format!(
            "{} has no parameter `{name}`; it has {}",
            model.name(),
            names.join(", ")
        ),
    }
}

fn count(text: &str) -> Result<f64, String> {
    match text.parse::<u32>() {
        Ok(count) if count >= 1 => Ok(f64::from(count)),
        _ => Err("a whole number of at least 1 is needed, without a unit".into()),
    }
}

/// The value in SI of a quantity whose unit has the dimension of the declared one.
fn quantity(text: &str, declared: &str, dimension: Dimension) -> Result<f64, String> {
    let bare = dimension == [0; 6];
    let Some((number, symbols)) = Number::split(text) else {
        return Err(if bare {
            "a number is needed".into()
        } else {
            "a number with its unit is needed".into()
        });
    };
    if symbols.is_empty() && !bare {
        return Err(format!(
            "the unit is missing; write {declared} or another of its dimension"
        ));
    }
    let unit = Unit::parse(symbols)?;
    if unit.dimension != dimension && !is_angle_left_out(unit.dimension, dimension) {
        return Err(mismatch(symbols, unit.dimension, declared, dimension));
    }
    let value = unit.to_si(number);
    if !value.is_finite() {
        return Err("the number is too large".into());
    }
    Ok(value)
}

const PER_SECOND: Dimension = [0, 0, -1, 0, 0, 0];

/// Whether two dimensions differ by radians alone, which are 1, as `N*m` and `N*m/rad`. What is counted per second stays open.
fn is_angle_left_out(mut found: Dimension, mut declared: Dimension) -> bool {
    (found[5], declared[5]) = (0, 0);
    found == declared && declared != [0; 6] && declared != PER_SECOND
}

fn mismatch(symbols: &str, found: Dimension, declared: &str, dimension: Dimension) -> String {
    const ANGULAR_VELOCITY: Dimension = [0, 0, -1, 0, 0, 1];
    if found == PER_SECOND && dimension == ANGULAR_VELOCITY {
        return format!("`{symbols}` leaves open what is counted; write rad/s, rpm or deg/s");
    }
    match declared {
        "1" | "" => format!("`{symbols}` is out of place: the parameter has no dimension"),
        _ => format!("`{symbols}` does not have the dimension of {declared}"),
    }
}

/// A value with a unit of the dimension of `unit`, in `unit`.
///
/// # Errors
/// What is wrong with it.
pub(in crate::app) fn in_unit_of(text: &str, unit: &str) -> Result<f64, String> {
    let unit = if unit == "1" { "" } else { unit };
    let dimension = Unit::parse(unit)?.dimension;
    Ok(quantity(text, unit, dimension)? / quantity(&format!("1 {unit}"), unit, dimension)?)
}

/// A positive time with its unit, for a flag.
///
/// # Errors
/// The flag and what would be right.
pub(in crate::app) fn time(flag: &str, text: &str, example: &str) -> Result<f64, String> {
    seconds(flag, text, example, |seconds| seconds > 0.0, "positive")
}

/// A time that may be zero, with its unit, for a flag.
///
/// # Errors
/// The flag and what would be right.
pub(in crate::app) fn instant(flag: &str, text: &str, example: &str) -> Result<f64, String> {
    seconds(flag, text, example, |seconds| seconds >= 0.0, "zero or positive")
}

fn seconds(flag: &str, text: &str, example: &str, fits: fn(f64) -> bool, wanted: &str) -> Result<f64, String> {
    let seconds = quantity(text, "s", SECOND).and_then(|seconds| {
        if fits(seconds) {
            Ok(seconds)
        } else {
            Err(format!("the time must be {wanted}"))
        }
    });
    seconds.map_err(|mistake| format!("`{flag} {}`: {mistake} (e.g. `{flag} \"{example}\"`)", quoted(text)))
}

/// An angular velocity, rad/s, for a flag.
///
/// # Errors
/// The flag and what would be right.
pub(in crate::app) fn angular_velocity(flag: &str, text: &str, example: &str) -> Result<f64, String> {
    let value = quantity(text, "rad/s", [0, 0, -1, 0, 0, 1]);
    value.map_err(|mistake| format!("`{flag} {}`: {mistake} (e.g. `{flag} \"{example}\"`)", quoted(text)))
}

/// As it must be typed in a shell.
fn quoted(text: &str) -> String {
    if text.contains([' ', '(', '*']) {
        format!("\"{text}\"")
    } else {
        text.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;
    use crate::app::writing::numbers::short;

    fn mistake(word: &str) -> String {
        assign(&mut Rotor::default(), &[word.into()]).unwrap_err()
    }

    #[test]
    fn values_are_set_in_si() {
        let mut rotor = Rotor::default();
        let words = ["omega=60 rpm", "coils=3", "stiffness=0.2 kN/m", "loss=0.05"].map(String::from);
        assign(&mut rotor, &words).unwrap();
        assert_eq!(rotor.omega, 60.0 * (std::f64::consts::PI / 30.0));
        assert_eq!((rotor.coils, rotor.stiffness, rotor.loss), (3, 200.0, 0.05));
        assign(&mut rotor, &["loss=0.1".into()]).unwrap();
        assert_eq!(rotor.loss, 0.1);
    }

    fn varied(word: &str) -> (Rotor, Varied) {
        let mut rotor = Rotor::default();
        let mut varied = assign(&mut rotor, &[word.into()]).unwrap();
        assert_eq!(varied.len(), 1);
        (rotor, varied.remove(0))
    }

    #[test]
    fn ranges_carry_their_unit_at_the_end_or_twice() {
        for (word, parts) in [
            ("omega=0..60 rpm", None),
            ("omega=0 rad/s..60rpm", None),
            ("omega=0..60 rpm in 5", Some(5)),
        ] {
            let (rotor, found) = varied(word);
            assert_eq!((found.param, found.values), (0, Values::Range(0.0, rotor.omega, parts)));
            assert_eq!(rotor.omega, 60.0 * (std::f64::consts::PI / 30.0));
        }
        assert!(mistake("omega=0..60 rpm in 1").contains("`in 1`: a whole number of at least 2"));
    }

    #[test]
    fn lists_carry_their_unit_at_the_end_or_with_every_value() {
        let (rotor, found) = varied("omega=30, 60 rpm");
        assert_eq!(found.values, Values::List(vec![rotor.omega / 2.0, rotor.omega]));
        let (rotor, found) = varied("coils=3,5");
        assert_eq!((found.values, rotor.coils), (Values::List(vec![3.0, 5.0]), 5));
        assert_eq!(
            mistake("coils=3,3"),
            "`coils=3,3`: a value is given twice (e.g. `coils=2`)"
        );
        assert!(mistake("omega=1 rad/s,2").contains("the unit is missing"));
    }

    #[test]
    fn distributions_have_a_mean_a_deviation_and_a_unit() {
        let (rotor, found) = varied("stiffness=normal(0.2, 0.01) kN/m");
        assert_eq!((found.values, rotor.stiffness), (Values::Normal(200.0, 10.0), 200.0));
        assert_eq!(varied("loss=normal(0.5,0.1)").1.values, Values::Normal(0.5, 0.1));
        for (word, part) in [
            ("stiffness=normal(1, 2)", "the unit is missing"),
            (
                "loss=normal(1)",
                "a distribution is written `normal(mean, deviation) unit`",
            ),
            ("loss=normal(1, 0)", "the standard deviation must be positive"),
            ("coils=normal(3, 1)", "a count does not change continuously"),
        ] {
            assert!(mistake(word).contains(part), "{}", mistake(word));
        }
    }

    #[test]
    fn mistakes_say_what_would_be_right() {
        let cases = [
            ("omga=4 rad/s", "Rotor has no parameter `omga`; did you mean `omega`?"),
            (
                "gravity=1 m/s^2",
                "Rotor has no parameter `gravity`; it has omega, coils, stiffness, loss, fail_at",
            ),
            (
                "omega=40",
                "`omega=40`: the unit is missing; write rad/s or another of its dimension (e.g. `omega=\"3 rad/s\"`)",
            ),
            (
                "omega=40 Hz",
                "`omega=40 Hz`: `Hz` leaves open what is counted; write rad/s, rpm or deg/s (e.g. `omega=\"3 rad/s\"`)",
            ),
            (
                "omega=40 rad",
                "`omega=40 rad`: `rad` does not have the dimension of rad/s (e.g. `omega=\"3 rad/s\"`)",
            ),
            (
                "omega=40 rads/s",
                "`omega=40 rads/s`: `rads` is not a unit; did you mean `rad`? (e.g. `omega=\"3 rad/s\"`)",
            ),
            (
                "omega=fast",
                "`omega=fast`: a number with its unit is needed (e.g. `omega=\"3 rad/s\"`)",
            ),
            (
                "omega=1e999 rad/s",
                "`omega=1e999 rad/s`: the number is too large (e.g. `omega=\"3 rad/s\"`)",
            ),
            (
                "coils=2.5",
                "`coils=2.5`: a whole number of at least 1 is needed, without a unit (e.g. `coils=2`)",
            ),
            (
                "coils=0",
                "`coils=0`: a whole number of at least 1 is needed, without a unit (e.g. `coils=2`)",
            ),
            (
                "loss=1 m",
                "`loss=1 m`: `m` is out of place: the parameter has no dimension (e.g. `loss=0.01`)",
            ),
            (
                "coils=1..4",
                "`coils=1..4`: a count does not change continuously: give one value, or a list (e.g. `coils=2`)",
            ),
            (
                "omega=1..4",
                "`omega=1..4`: the unit is missing; write rad/s or another of its dimension (e.g. `omega=\"3 rad/s\"`)",
            ),
            (
                "loss=0.1..0.1",
                "`loss=0.1..0.1`: the range begins where it ends: give one value (e.g. `loss=0.01`)",
            ),
            (
                "rad/s",
                "`rad/s` stands alone: quote a value together with its unit, `omega=\"3 rad/s\"`",
            ),
            (
                "steddy",
                "`steddy` is not a command; did you mean `steady`? A command comes first",
            ),
            (
                "static",
                "`static` is a command and stands before what it is given: `static name=value`",
            ),
            (
                "whatever",
                "`whatever` is neither a command (run, steady, modes, campbell, static, chart, advise, sweep, optimise, plan, task, collect, explain) nor `name=value`",
            ),
        ];
        for (word, expected) in cases {
            assert_eq!(mistake(word), expected);
        }
    }

    #[test]
    fn all_mistakes_come_at_once() {
        let words = ["coils=1", "coils=2", "omga=1"].map(String::from);
        let error = assign(&mut Rotor::default(), &words).unwrap_err();
        assert_eq!(
            error,
            "`coils` is given twice\nRotor has no parameter `omga`; did you mean `omega`?"
        );
    }

    #[test]
    fn times_need_a_unit_and_a_sign() {
        assert_eq!(time("--t-end", "2 min", "20 s"), Ok(120.0));
        let error = |text| time("--t-end", text, "20 s").unwrap_err();
        assert_eq!(
            error("20"),
            "`--t-end 20`: the unit is missing; write s or another of its dimension (e.g. `--t-end \"20 s\"`)"
        );
        assert_eq!(
            error("-1 s"),
            "`--t-end \"-1 s\"`: the time must be positive (e.g. `--t-end \"20 s\"`)"
        );
        assert_eq!(
            error("1 m"),
            "`--t-end \"1 m\"`: `m` does not have the dimension of s (e.g. `--t-end \"20 s\"`)"
        );
    }

    #[test]
    fn values_are_shown_without_noise() {
        assert_eq!(short(0.7299e-4 / 1e-4), "0.7299");
        assert_eq!(short(0.1 + 0.2), "0.3");
        assert_eq!(short(68.95e9), "6.895e10");
        assert_eq!(short(0.0), "0");
    }
}
