//! A pipe on nine elastic supports, where absolute coordinates are the cheaper ones.
//!
//! `cargo run --release --example pinned_pipe -- chart`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::PinnedPipe>()
}
