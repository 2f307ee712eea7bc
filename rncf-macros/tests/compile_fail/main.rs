//! Wrong models, folder by kind of mistake: what a user's build says, which word it underlines, and that it says
//! nothing else.
//!
//! Beside each program `name.rs` stands `name.stderr`, what the compiler of `rustc-version.txt` prints. Messages and
//! underlined words of all of them are checked through the library. That compiler checks one of each folder, against the
//! library `rncf` that lies there, and all with `ALL=1`. `BLESS=1 cargo test -p rncf-macros --test compile_fail` rewrites
//! them; read the difference.

mod expected;
mod programs;
