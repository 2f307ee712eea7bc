//! Time and memory of the E-sail against its size: 25 to 400 tethers of 8, 16 and 32 elements.
//!
//! `RAYON_NUM_THREADS=1 cargo run --release --example esail_scaling` prints a table and writes `esail_scaling.csv` and
//! `esail_scaling.svg`. Every size is a process of its own: resident set at its largest, processor time of
//! 20 steps of 1 s with generalized-alpha.

use std::fmt::Write;
use std::process::Command;

use rncf::prelude::*;
use rncf_models::Esail;

const TETHERS: [usize; 5] = [25, 50, 100, 200, 400];
const ELEMENTS: [usize; 3] = [8, 16, 32];
const STEPS: f64 = 20.0;

/// Unknowns, milliseconds a step, MB.
type Row = [f64; 3];

fn main() {
    let sizes: Vec<usize> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    if let [tethers, elements] = sizes[..] {
        return one(tethers, elements);
    }
    let mut csv = String::from("tethers,elements,unknowns,ms per step,resident MB\n");
    let mut lines: Vec<Vec<Row>> = Vec::new();
    println!(
        "| tethers | elements | unknowns | ms per step | us per unknown | MB | kB per unknown |\n|---|---|---|---|---|---|---|"
    );
    for elements in ELEMENTS {
        let mut line = Vec::new();
        for tethers in TETHERS {
            let row = measured(tethers, elements);
            let [unknowns, time, memory] = row;
            println!(
                "| {tethers} | {elements} | {unknowns} | {time:.2} | {:.2} | {memory:.1} | {:.2} |",
                1e3 * time / unknowns,
                1e3 * memory / unknowns
            );
            let _ = writeln!(csv, "{tethers},{elements},{unknowns},{time:.3},{memory:.1}");
            line.push(row);
        }
        lines.push(line);
    }
    for (name, text) in [("esail_scaling.csv", csv), ("esail_scaling.svg", svg(&lines))] {
        std::fs::write(name, text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// Of one size, by the fastest of three processes: others on the machine only slow it.
fn measured(tethers: usize, elements: usize) -> Row {
    let program = std::env::current_exe().unwrap_or_else(|error| panic!("{error}"));
    let runs = (0..3).map(|_| {
        let output = Command::new(&program)
            .args([tethers, elements].map(|size| size.to_string()))
            .output();
        let output = output.unwrap_or_else(|error| panic!("{error}"));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let numbers: Vec<f64> = text.split_whitespace().filter_map(|text| text.parse().ok()).collect();
        <Row>::try_from(numbers).unwrap_or_else(|_| panic!("{tethers} tethers of {elements} elements: {text}"))
    });
    runs.reduce(|a, b| if b[1] < a[1] { b } else { a }).unwrap_or_default()
}

fn one(tethers: usize, elements: usize) {
    let model = Esail {
        tethers,
        elements,
        ..Esail::default()
    };
    let scene = model.build(Formulation::Rncf, Joints::Eliminated);
    let mut scene = scene.unwrap_or_else(|error| panic!("{error}"));
    let (rest, unknowns) = (scene.rest(0.0), scene.unknowns());
    let options = Options {
        step: StepSize::Fixed(1.0),
        ..Options::default()
    };
    let method = Method::GeneralizedAlpha { rho_inf: 0.8 };
    let integrator = Integrator::new(scene.as_mut(), rest, STEPS, method, options);
    let mut integrator = integrator.unwrap_or_else(|error| panic!("{error}"));
    let start = cpu();
    while integrator.step().unwrap_or_else(|error| panic!("{error}")) != Stop::End {}
    println!("{unknowns} {} {}", 1e3 * (cpu() - start) / STEPS, resident());
}

/// Processor time of the main thread, s.
fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = text.split(' ').next().and_then(|text| text.parse().ok());
    nanoseconds.unwrap_or(f64::NAN) * 1e-9
}

/// Resident set, MB.
fn resident() -> f64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse().ok());
    kilobytes.unwrap_or(f64::NAN) / 1024.0
}

const COLORS: [&str; 3] = ["#1f5fa8", "#c2510c", "#2a7d46"];

/// Two logarithmic charts side by side, with a line of proportionality each.
fn svg(lines: &[Vec<Row>]) -> String {
    let mut text = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 400\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#333\">\n<rect width=\"960\" height=\"400\" fill=\"#fff\"/>\n",
    );
    for (place, (quantity, name)) in [(1, "ms per step of 1 s"), (2, "resident MB")].into_iter().enumerate() {
        panel(&mut text, 60.0 + 480.0 * place as f64, quantity, name, lines);
    }
    text + "</svg>\n"
}

fn panel(text: &mut String, left: f64, quantity: usize, name: &str, lines: &[Vec<Row>]) {
    let all = || lines.iter().flatten();
    let extent = |of: usize| {
        let values = all().map(|row| row[of].log10());
        let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        (low.floor(), high.ceil())
    };
    let ((x0, x1), (y0, y1)) = (extent(0), extent(quantity));
    let x = |value: f64| left + 390.0 * (value.log10() - x0) / (x1 - x0);
    let y = |value: f64| 340.0 - 300.0 * (value.log10() - y0) / (y1 - y0);
    for exponent in x0 as i32..=x1 as i32 {
        let (value, at) = (10_f64.powi(exponent), x(10_f64.powi(exponent)));
        let _ = writeln!(
            text,
            "<path d=\"M{at:.1} 40V340\" stroke=\"#ddd\"/><text x=\"{at:.1}\" y=\"358\" text-anchor=\"middle\">{value}</text>"
        );
    }
    for exponent in y0 as i32..=y1 as i32 {
        let (value, at) = (10_f64.powi(exponent), y(10_f64.powi(exponent)));
        let end = left + 390.0;
        let _ = writeln!(
            text,
            "<path d=\"M{left} {at:.1}H{end}\" stroke=\"#ddd\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{value}</text>",
            left - 6.0,
            at + 5.0
        );
    }
    let _ = writeln!(
        text,
        "<text x=\"{:.0}\" y=\"384\" text-anchor=\"middle\">unknowns</text><text x=\"{left}\" y=\"24\">{name}</text>",
        left + 195.0
    );
    // Through the middle of all: proportional to the number of unknowns.
    let factor = 10_f64.powf(all().map(|row| (row[quantity] / row[0]).log10()).sum::<f64>() / all().count() as f64);
    let ends =
        [10_f64.powf(x0), 10_f64.powf(x1)].map(|at| at.max(10_f64.powf(y0) / factor).min(10_f64.powf(y1) / factor));
    let _ = writeln!(
        text,
        "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" stroke=\"#888\" stroke-dasharray=\"5 5\"/>",
        x(ends[0]),
        y(factor * ends[0]),
        x(ends[1]),
        y(factor * ends[1])
    );
    for (index, (line, elements)) in lines.iter().zip(ELEMENTS).enumerate() {
        let color = COLORS[index];
        let points: String = line
            .iter()
            .map(|row| format!("{:.1},{:.1} ", x(row[0]), y(row[quantity])))
            .collect();
        let _ = writeln!(
            text,
            "<polyline points=\"{points}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>"
        );
        for row in line {
            let _ = writeln!(
                text,
                "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"4\" fill=\"{color}\"/>",
                x(row[0]),
                y(row[quantity])
            );
        }
        let at = 64 + 20 * index;
        let _ = writeln!(
            text,
            "<circle cx=\"{:.0}\" cy=\"{}\" r=\"4\" fill=\"{color}\"/><text x=\"{:.0}\" y=\"{at}\">{elements} elements</text>",
            left + 18.0,
            at - 5,
            left + 28.0
        );
    }
}
