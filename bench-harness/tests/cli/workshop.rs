//! A folder to run the program in, and what a run leaves behind.

use assert_cmd::Command;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

/// A square with a point inside, one on an edge and a copy of a corner.
pub(crate) const SQUARE: &str = "name,x,y\na,0,0\nb,2,0\nc,1,1\nd,2,2\ne,1,0\nf,0,2\ng,0,0\n";

/// A cube with the middle of a facet, its centre and a copy of a corner.
pub(crate) const CUBE: &str = "name,x,y,z\na,0,0,0\nb,2,0,0\nc,0,2,0\nd,2,2,0\ne,0,0,2\nf,2,0,2\ng,0,2,2\n\
                               h,2,2,2\ni,1,1,0\nj,1,1,1\nk,2,2,2\n";

/// A folder with files of the given names and contents, and the program run inside it.
pub(crate) struct Workshop {
    pub(crate) folder: TempDir,
}

impl Workshop {
    pub(crate) fn new(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for (name, content) in files {
            fs::write(folder.path().join(name), content).unwrap();
        }
        Self { folder }
    }

    /// Runs the program with `arguments`, which are separated by blanks.
    pub(crate) fn run(&self, arguments: &str) -> Outcome {
        self.launch(arguments.split_whitespace().map(OsStr::new))
    }

    /// Runs a command, with options separated by blanks, on a file, whatever its path.
    pub(crate) fn run_on(&self, command: &str, path: &Path) -> Outcome {
        let words = command.split_whitespace().map(OsStr::new);
        self.launch(words.chain([path.as_os_str()]))
    }

    fn launch<'a>(&self, arguments: impl IntoIterator<Item = &'a OsStr>) -> Outcome {
        let output = Command::new(env!("CARGO_BIN_EXE_hullbench"))
            .current_dir(self.folder.path())
            .args(arguments)
            .output()
            .unwrap();
        Outcome::of(output)
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join(name)).unwrap()
    }

    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<_> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

/// What a run left behind.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Outcome {
    pub(crate) fn of(output: Output) -> Self {
        Self {
            code: output.status.code(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Standard output of a run that ended well.
    #[track_caller]
    pub(crate) fn stdout(self) -> String {
        assert_eq!(self.code, Some(0), "{self:?}");
        self.stdout
    }

    /// The message of a run that failed with `code`: one line, and nothing on standard output.
    #[track_caller]
    pub(crate) fn failure(self, code: i32) -> String {
        assert_eq!(self.code, Some(code), "{self:?}");
        assert_eq!(self.stdout, "", "{self:?}");
        assert!(self.stderr.starts_with("error: "), "{self:?}");
        assert_eq!(self.stderr.lines().count(), 1, "{self:?}");
        self.stderr
    }
}

/// The value after `label` at the beginning of a line of a summary.
#[track_caller]
pub(crate) fn value<'a>(summary: &'a str, label: &str) -> &'a str {
    let line = summary.lines().find_map(|line| line.strip_prefix(label));
    line.unwrap_or_else(|| panic!("no line begins with {label:?} in\n{summary}"))
        .trim()
}
