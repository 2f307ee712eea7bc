//! Points of other codes, `--beside FILE`: one line for each output of each setting of each code, errors in the SI unit of the
//! output over the same rows, processor time of one thread.

use std::fs;
use std::path::Path;

/// First line of the file.
const HEAD: &str = "code,setting,output,error_max,error_rms,cpu_s,steps";

/// A run of another code.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Peer {
    /// Name of the code.
    pub code: String,
    /// Its setting.
    pub setting: String,
    /// Largest error relative to the change of its output, the worst of the outputs that count.
    pub error: f64,
    /// Processor time, s.
    pub cpu: f64,
    pub steps: u64,
}

struct Row {
    code: String,
    setting: String,
    output: String,
    error: f64,
    cpu: f64,
    steps: u64,
}

/// Reads the file; `outputs` are the columns that count with their scales (SI, positive).
///
/// # Errors
/// The path with the line, the setting or the output that is missing or wrong.
pub(super) fn read(path: &Path, outputs: &[(String, f64)]) -> Result<Vec<Peer>, String> {
    let name = path.display();
    let text = fs::read_to_string(path).map_err(|error| format!("cannot read {name}: {error}"))?;
    let mut lines = text
        .lines()
        .map(str::trim)
        .enumerate()
        .filter(|(_, line)| !line.is_empty());
    if lines.next().map(|(_, line)| line) != Some(HEAD) {
        return Err(format!("{name}: the first line must be `{HEAD}`"));
    }
    let mut rows = Vec::new();
    for (index, line) in lines {
        let row = row(line).map_err(|mistake| format!("{name}, line {}: {mistake}", index + 1))?;
        rows.push(row);
    }
    let mut peers: Vec<Peer> = Vec::new();
    for index in 0..rows.len() {
        let of = |row: &&Row| row.code == rows[index].code && row.setting == rows[index].setting;
        if rows[..index].iter().any(|row| of(&row)) {
            continue;
        }
        let Row {
            code,
            setting,
            cpu,
            steps,
            ..
        } = &rows[index];
        let mut error = 0.0_f64;
        for (output, scale) in outputs {
            let found = rows.iter().filter(of).find(|row| row.output == *output);
            let found = found.ok_or_else(|| {
                format!("{name}: {code}, setting `{setting}`, has no output `{output}`; choose others with `--outputs`")
            })?;
            error = error.max(found.error / scale);
        }
        peers.push(Peer {
            code: code.clone(),
            setting: setting.clone(),
            error,
            cpu: *cpu,
            steps: *steps,
        });
    }
    Ok(peers)
}

fn row(line: &str) -> Result<Row, String> {
    let fields: Vec<&str> = line.split(',').map(str::trim).collect();
    let [code, setting, output, error_max, error_rms, cpu, steps] = fields[..] else {
        return Err(format!("{} fields instead of the 7 of `{HEAD}`", fields.len()));
    };
    let number = |field: &str, text: &str| match text.parse::<f64>() {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value),
        _ => Err(format!("`{field}` is `{text}`, which is no number of at least 0")),
    };
    number("error_rms", error_rms)?;
    let cpu = number("cpu_s", cpu)?;
    if cpu == 0.0 {
        return Err("`cpu_s` is 0".into());
    }
    Ok(Row {
        code: code.into(),
        setting: setting.into(),
        output: output.into(),
        error: number("error_max", error_max)?,
        cpu,
        steps: steps
            .parse()
            .map_err(|_| format!("`steps` is `{steps}`, which is no whole number"))?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::machine::files;
    use crate::app::testing::temporary_folder;

    #[test]
    fn peers_are_judged_by_their_worst_output_and_refused_by_name() {
        let folder = temporary_folder("peers");
        files::create_folder(&folder).unwrap();
        let found_in = |name: &str, lines: &[&str]| {
            files::write(&folder, name, &lines.join("\n")).unwrap();
            let outputs = [("u".to_owned(), 2.0), ("v".to_owned(), 0.5)];
            read(&folder.join(name), &outputs)
        };
        let a = "other,h = 1e-3,u,2e-3,1e-3,1.5,20000";
        let found = found_in(
            "a.csv",
            &[
                HEAD,
                a,
                "",
                "other,h = 1e-3,w,9,9,1.5,20000",
                "other,h = 1e-3,v,1e-3,1e-4,1.5,20000",
            ],
        );
        let expected = Peer {
            code: "other".into(),
            setting: "h = 1e-3".into(),
            error: 2e-3,
            cpu: 1.5,
            steps: 20000,
        };
        assert_eq!(found, Ok(vec![expected]));
        let cases: [(&[&str], &str); 5] = [
            (&["code,setting"], "the first line must be `code,setting,output,"),
            (
                &[HEAD, a],
                "other, setting `h = 1e-3`, has no output `v`; choose others with `--outputs`",
            ),
            (&[HEAD, "other,1,u,2"], "line 2: 4 fields instead of the 7"),
            (&[HEAD, "other,1,u,-1,0,1,1"], "line 2: `error_max` is `-1`"),
            (&[HEAD, "other,1,u,1,0,1,1.5"], "line 2: `steps` is `1.5`"),
        ];
        for (lines, expected) in cases {
            let refusal = found_in("b.csv", lines).unwrap_err();
            assert!(refusal.contains(expected), "{refusal}");
        }
        fs::remove_dir_all(folder).unwrap();
    }
}
