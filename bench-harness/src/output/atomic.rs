//! Files that appear whole or not at all.
//!
//! The content goes to a temporary file in the target's folder, is synced, and takes the target's name in one
//! step. A failure on the way leaves nothing behind and the old file as it was.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// What to do if the target exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existing {
    /// Leave it alone and fail with [`io::ErrorKind::AlreadyExists`].
    Keep,
    /// Replace it.
    Replace,
}

/// Writes the file at `path` by calling `content`.
///
/// A path that names a device or a pipe is written to directly: it has no content to replace.
///
/// # Errors
///
/// What the operating system says; [`io::ErrorKind::AlreadyExists`] if the file exists and `existing` is
/// [`Existing::Keep`].
pub fn write(
    path: &Path,
    existing: Existing,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    if is_stream(path) {
        let mut out = BufWriter::new(File::options().write(true).open(path)?);
        content(&mut out)?;
        return out.flush();
    }
    refuse_to_replace(path, existing)?;
    let path = through_links(path);
    let mut out = BufWriter::new(beside(&path)?);
    content(&mut out)?;
    let file = out.into_inner().map_err(io::IntoInnerError::into_error)?;
    file.as_file().sync_all()?;
    match existing {
        Existing::Keep => file.persist_noclobber(&path),
        Existing::Replace => file.persist(&path),
    }
    .map_err(|failed| failed.error)?;
    sync_folder(&path)
}

/// Fails early, before any work, where [`write()`] would refuse at the end.
///
/// # Errors
///
/// [`io::ErrorKind::AlreadyExists`] as [`write()`]; [`io::ErrorKind::IsADirectory`] for a folder;
/// [`io::ErrorKind::NotFound`] if the folder to write in does not exist.
pub fn refuse_to_replace(path: &Path, existing: Existing) -> io::Result<()> {
    if path.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if existing == Existing::Keep && path.exists() && !is_stream(path) {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    if !folder_of(path).is_dir() {
        return Err(io::ErrorKind::NotFound.into());
    }
    Ok(())
}

/// Whether `path` names something other than a file or folder: a device, a pipe, a socket.
fn is_stream(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
}

/// The file that `path` leads to, so that a symbolic link stays a link.
fn through_links(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf())
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A new temporary file in the folder of `path`, readable by whoever may read other new files there.
fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    #[cfg(unix)]
    let builder = {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666))
    };
    builder.prefix(".hullbench-").tempfile_in(folder_of(path))
}

/// Makes the new name itself durable, where the system allows a folder to be synced.
fn sync_folder(path: &Path) -> io::Result<()> {
    if cfg!(unix) {
        File::open(folder_of(path))?.sync_all()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn the_content_arrives_and_nothing_else_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        write(&path, Existing::Keep, |out| out.write_all(b"x,y\n")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"x,y\n");
        assert_eq!(names(folder.path()), ["a.csv"]);
    }

    #[test]
    fn an_existing_file_is_kept_unless_told_otherwise() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        fs::write(&path, "old").unwrap();
        let kept = write(&path, Existing::Keep, |out| out.write_all(b"new"));
        assert_eq!(kept.unwrap_err().kind(), io::ErrorKind::AlreadyExists);
        assert_eq!(fs::read(&path).unwrap(), b"old");
        write(&path, Existing::Replace, |out| out.write_all(b"new")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
    }

    #[test]
    fn a_failure_half_way_leaves_the_old_file_and_no_other() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        fs::write(&path, "old").unwrap();
        let failed = write(&path, Existing::Replace, |out| {
            out.write_all(b"half")?;
            Err(io::Error::other("the disk is full"))
        });
        assert!(failed.is_err());
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["a.csv"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link() {
        let folder = tempfile::tempdir().unwrap();
        let [path, link] = ["a.csv", "link.csv"].map(|name| folder.path().join(name));
        fs::write(&path, "old").unwrap();
        std::os::unix::fs::symlink(&path, &link).unwrap();
        write(&link, Existing::Replace, |out| out.write_all(b"new")).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&path).unwrap(), b"new");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_written_to_and_stays() {
        write(Path::new("/dev/null"), Existing::Keep, |out| {
            out.write_all(b"gone")
        })
        .unwrap();
        assert!(is_stream(Path::new("/dev/null")));
    }
}
