//! Models as Python modules: `rncf::python!(swing: Swing)`.
//!
//! The Rust side of it ([`Core`]) takes the words of a command line and gives tables and JSON; what a Python user meets,
//! keyword arguments, numpy arrays and exceptions, is written in Python (`layer.py`).

// What `pymethods` writes is unsafe code of its own, checked there.
#![allow(unsafe_code)]

use std::ffi::{CString, OsString};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};

pub use pyo3;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde_json::{Value, json};

use crate::app::commands::execute::execute;
use crate::app::equilibria::steady::equilibria;
use crate::app::line::arguments::{Arguments, Refusal, parse};
use crate::app::line::command::Command;
use crate::app::line::flags::command_line;
use crate::app::line::program::Program;
use crate::app::line::scenario;
use crate::app::modal::modes::modes;
use crate::app::page::summary;
use crate::app::results::error::RunError;
use crate::app::results::failure::MISTAKE;
use crate::app::results::history::History;
use crate::app::runs::run::run_watched;
use crate::app::writing::entries::Summary;
use crate::app::writing::entries::to_text;
use crate::app::writing::numbers::in_unit;
use crate::equilibrium::Kind;
use crate::{AnyModel, Model, ParamKind};

/// Makes a Python module with a class for each model. The module has the name of the crate, which is built as `cdylib`:
///
/// ```ignore
/// #[cfg(feature = "python")]
/// rncf::python!(swing: Swing, Chain);
/// ```
#[macro_export]
macro_rules! python {
    ($module:ident: $($model:ty),+ $(,)?) => {
        #[$crate::app::python::pyo3::pymodule]
        #[pyo3(crate = "::rncf::app::python::pyo3")]
        fn $module(
            module: &$crate::app::python::pyo3::Bound<'_, $crate::app::python::pyo3::types::PyModule>,
        ) -> $crate::app::python::pyo3::PyResult<()> {
            $($crate::app::python::register::<$model>(module)?;)+
            Ok(())
        }
    };
}

/// Adds the class of a model to a module, and those of its results.
///
/// # Errors
/// What Python raises: numpy is not installed.
pub fn register<M: Model>(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    let layer = match module.getattr("_layer") {
        Ok(layer) => layer,
        Err(_) => {
            let code = CString::new(include_str!("layer.py"))?;
            let layer = PyModule::from_code(py, &code, c"rncf/layer.py", c"rncf_layer")?.into_any();
            module.setattr("_layer", &layer)?;
            for name in ["Equilibria", "Incomplete", "Modes", "Run", "Sweep", "stubs"] {
                module.setattr(name, layer.getattr(name)?)?;
            }
            layer
        }
    };
    let core = Bound::new(
        py,
        Core {
            model: Box::new(M::default()),
        },
    )?;
    let class = layer.call_method1("model_class", (core, module.name()?))?;
    module.setattr(M::NAME, class)
}

/// A model with its default parameters.
#[pyclass(frozen)]
struct Core {
    model: Box<dyn AnyModel>,
}

/// How often Python is asked whether the user ends the work, and shown the progress.
const PAUSE: Duration = Duration::from_millis(50);

/// Between a run and the interpreter.
struct Watch {
    seen: Instant,
    progress: Option<Py<PyAny>>,
    raised: Option<PyErr>,
}

impl Watch {
    fn new(progress: Option<Py<PyAny>>) -> Self {
        Self {
            seen: Instant::now(),
            progress,
            raised: None,
        }
    }

    /// Looks for Ctrl-C, and shows which part of the work is done.
    fn look(&mut self, share: f64, at: f64) -> ControlFlow<()> {
        if self.raised.is_none() && self.seen.elapsed() < PAUSE {
            return ControlFlow::Continue(());
        }
        self.seen = Instant::now();
        let asked = Python::attach(|py| {
            py.check_signals()?;
            match &self.progress {
                Some(progress) => progress.call1(py, (share, at)).map(drop),
                None => Ok(()),
            }
        });
        match asked {
            Ok(()) => ControlFlow::Continue(()),
            Err(raised) => {
                self.raised = Some(raised);
                ControlFlow::Break(())
            }
        }
    }
}

/// Summary, heads and units of the columns with that of the rows first, keys and values of the rows.
type Found<'py> = (
    String,
    Vec<String>,
    Vec<String>,
    Bound<'py, PyBytes>,
    Bound<'py, PyBytes>,
);

fn found<'py>(py: Python<'py>, summary: Summary, history: &History) -> Found<'py> {
    let columns = || std::iter::once(&history.key).chain(&history.columns);
    let bytes = |values: &[f64]| {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_ne_bytes()).collect();
        PyBytes::new(py, &bytes)
    };
    (
        to_text(&summary),
        columns().map(|column| column.name.clone()).collect(),
        columns().map(|column| column.unit.to_owned()).collect(),
        bytes(&history.keys),
        bytes(&history.values),
    )
}

fn failed(error: &RunError) -> PyErr {
    match error {
        RunError::Settings(_) | RunError::Model(_) => PyValueError::new_err(error.to_string()),
        _ => PyRuntimeError::new_err(error.to_string()),
    }
}

impl Core {
    fn program(&self) -> Program<'_> {
        Program {
            name: self.model.name(),
            default: Command::Run,
            more: "",
            out: PathBuf::from("out").join(self.model.name()),
        }
    }

    fn arguments(&self, words: Vec<String>) -> PyResult<Arguments> {
        parse(
            self.model.as_ref(),
            &self.program(),
            words.into_iter().map(OsString::from),
        )
        .map_err(|refusal| match refusal {
            Refusal::Help(text) | Refusal::Mistake(text) => PyValueError::new_err(text),
        })
    }
}

#[pymethods]
impl Core {
    /// Name, text, params, outputs and settings of the model, as JSON.
    fn describe(&self) -> String {
        let model = self.model.as_ref();
        let line = command_line(model, &self.program());
        let params = model.params().iter().map(|param| {
            json!({
                "name": param.name,
                "unit": param.unit,
                "dimension": param.dimension,
                "is_count": param.kind == ParamKind::Count,
                "is_file": matches!(param.kind, ParamKind::Table(_)),
                "doc": param.doc.trim(),
            })
        });
        let outputs = model.outputs().iter().map(
            |output| json!({ "name": output.name, "unit": output.unit, "components": output.components, "doc": output.doc.trim() }),
        );
        let value = json!({
            "name": model.name(),
            "doc": model.doc().trim(),
            "source": model.source(),
            // So many notes are the same for all results.
            "notes": model.notes().len(),
            "settings": scenario::settings(&line),
            "params": params.collect::<Value>(),
            "outputs": outputs.collect::<Value>(),
        });
        value.to_string()
    }

    /// Values of all params, SI, with those of the words.
    fn values(&self, words: Vec<String>) -> PyResult<Vec<f64>> {
        let arguments = self.arguments(words)?;
        let model = arguments.model();
        Ok((0..model.params().len()).map(|index| model.get(index)).collect())
    }

    /// The same as texts with their units, and paths of files.
    fn texts(&self, words: Vec<String>) -> PyResult<Vec<String>> {
        let arguments = self.arguments(words)?;
        let model = arguments.model();
        let params = model.params().iter().enumerate();
        Ok(params.map(|(index, param)| in_unit(param, model.get(index))).collect())
    }

    #[pyo3(signature = (words, progress=None))]
    fn run<'py>(&self, py: Python<'py>, words: Vec<String>, progress: Option<Py<PyAny>>) -> PyResult<Found<'py>> {
        let arguments = self.arguments(words)?;
        let mut watch = Watch::new(progress);
        let outcome = py.detach(|| {
            run_watched(arguments.model(), &arguments.settings, |progress| {
                watch.look(progress.t / progress.t_end, progress.t)
            })
        });
        if let Some(raised) = watch.raised {
            return Err(raised);
        }
        let result = match outcome {
            Ok(result) => result,
            Err(RunError::Incomplete(result)) => *result,
            Err(error) => return Err(failed(&error)),
        };
        Ok(found(py, summary::of_run(arguments.model(), &result), &result.history))
    }

    #[pyo3(signature = (words, progress=None))]
    fn equilibria<'py>(
        &self,
        py: Python<'py>,
        words: Vec<String>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Found<'py>> {
        let arguments = self.arguments(words)?;
        let kind = if arguments.command == Command::Static {
            Kind::Static
        } else {
            Kind::Steady
        };
        let mut watch = Watch::new(progress);
        let outcome = py.detach(|| {
            equilibria(arguments.model(), kind, &arguments.equilibrium, |progress| {
                watch.look(progress.share, progress.key)
            })
        });
        if let Some(raised) = watch.raised {
            return Err(raised);
        }
        let result = match outcome {
            Ok(result) => result,
            Err(RunError::Equilibria(result)) => *result,
            Err(error) => return Err(failed(&error)),
        };
        let summary = summary::of_equilibria(arguments.model(), &result);
        Ok(found(py, summary, &result.history))
    }

    /// The summary of the modes, as JSON.
    fn modes(&self, py: Python<'_>, words: Vec<String>) -> PyResult<String> {
        let arguments = self.arguments(words)?;
        let result = py
            .detach(|| modes(arguments.model(), &arguments.equilibrium))
            .map_err(|error| failed(&error))?;
        Ok(to_text(&summary::of_modes(arguments.model(), &result)))
    }

    /// Does what a command line says, files and all; the text that it would print.
    fn command(&self, py: Python<'_>, words: Vec<String>) -> PyResult<String> {
        let arguments = self.arguments(words)?;
        let watch = std::sync::Mutex::new(Watch::new(None));
        let outcome = py.detach(|| {
            execute(&arguments, || match watch.lock() {
                Ok(mut watch) => watch.look(0.0, 0.0).is_break(),
                Err(_) => true,
            })
        });
        if let Some(raised) = watch.into_inner().ok().and_then(|watch| watch.raised) {
            return Err(raised);
        }
        outcome.map_err(|failure| match failure.code {
            MISTAKE => PyValueError::new_err(failure.message),
            _ => PyRuntimeError::new_err(failure.message),
        })
    }
}
