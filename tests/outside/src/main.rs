//! The command line of the model.

fn main() -> std::process::ExitCode {
    rncf::app::main::<swing::Swing>()
}
