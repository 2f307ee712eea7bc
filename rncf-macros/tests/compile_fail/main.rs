//! Wrong models, folder by kind of mistake: what a user's build says, which word it underlines, and that it says
//! nothing else.
//!
//! Beside each program `name.rs` stands `name.stderr`, what the compiler of `rustc-version.txt` prints. That compiler
//! builds all of them through trybuild; every other one checks messages and underlined words through the library.
//! `TRYBUILD=overwrite cargo test -p rncf-macros --test compile_fail` rewrites them; read the difference.

mod expected;
mod programs;
