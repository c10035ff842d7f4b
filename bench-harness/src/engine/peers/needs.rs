//! What a peer needs of the machine, and whether it is there.

use std::env;
use std::ffi::OsString;
use std::fmt;
use std::io::Write;
use std::process::{Command, Stdio};

/// Something that must be installed, and the Debian package that holds it.
#[derive(Clone, Copy, Debug)]
pub enum Need {
    /// A program.
    Command {
        /// Its name.
        program: &'static str,
        /// The environment variable that may name another.
        variable: &'static str,
        /// The package.
        package: &'static str,
    },
    /// A header that the C++ compiler finds.
    Header {
        /// As it is included.
        header: &'static str,
        /// The package.
        package: &'static str,
    },
}

impl Need {
    /// Whether it is there.
    pub fn is_met(&self) -> bool {
        match self {
            Need::Command {
                program, variable, ..
            } => succeeds(Command::new(chosen(variable, program)).arg("--version")),
            Need::Header { header, .. } => finds_header(header),
        }
    }
}

impl fmt::Display for Need {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Need::Command {
                program, package, ..
            } => write!(f, "the program {program} (Debian: {package})"),
            Need::Header { header, package } => {
                write!(f, "the header <{header}> (Debian: {package})")
            }
        }
    }
}

/// The program that the environment variable names, or else `program`.
pub(super) fn chosen(variable: &str, program: &str) -> OsString {
    env::var_os(variable).unwrap_or_else(|| program.into())
}

/// The C++ compiler.
pub(super) fn compiler() -> OsString {
    chosen("CXX", "g++")
}

/// The first Python interpreter that can import `modules`: the one the environment names, or else the first on the
/// path, or else that of the system.
pub(super) fn python(modules: &[&str]) -> Option<OsString> {
    let imports = format!("import {}", modules.join(", "));
    let candidates = match env::var_os("HULLBENCH_PYTHON") {
        Some(named) => vec![named],
        None => vec!["python3".into(), "/usr/bin/python3".into()],
    };
    let can_import = |python: &OsString| succeeds(Command::new(python).args(["-c", &imports]));
    candidates.into_iter().find(can_import)
}

fn finds_header(header: &str) -> bool {
    let child = Command::new(compiler())
        .args(["-std=c++17", "-E", "-x", "c++", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let Ok(mut child) = child else {
        return false;
    };
    if let Some(mut stdin) = child.stdin.take() {
        // Asked whether it is there, a compiler does not read it, nor the thousand headers behind it. One that has not
        // read the question has failed, and says so by its status.
        let _ = writeln!(stdin, "#if !__has_include(<{header}>)\n#error\n#endif");
    }
    child.wait().is_ok_and(|status| status.success())
}

fn succeeds(command: &mut Command) -> bool {
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_is_named_with_its_package() {
        let header = Need::Header {
            header: "no/such/header.h",
            package: "libnothing-dev",
        };
        assert!(!header.is_met());
        assert!(header.to_string().contains("libnothing-dev"));
        let program = Need::Command {
            program: "no-such-program",
            variable: "NO_SUCH_VARIABLE",
            package: "nothing",
        };
        assert!(!program.is_met());
        assert!(program.to_string().contains("no-such-program"));
    }
}
