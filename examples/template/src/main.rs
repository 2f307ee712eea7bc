//! `cargo run --release -- length="1.2 m" --rtol 1e-8`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<swing::Swing>()
}
