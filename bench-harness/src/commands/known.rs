//! Small tables of the checkout that are built in too, so that the program works anywhere.

use crate::failure::Failure;
use serde::de::DeserializeOwned;
use std::path::Path;

/// A CSV file below `data/`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// Its path in a checkout.
    pub(super) path: &'static str,
    /// Its text when the program was built.
    pub(super) built_in: &'static str,
}

impl Known {
    /// Its rows, those of the checkout if there is one round the current folder.
    ///
    /// # Errors
    ///
    /// [`Failure::Data`] with the line of a row that is not one; [`Failure::Io`].
    pub(super) fn rows<T: DeserializeOwned>(&self) -> Result<Vec<T>, Failure> {
        let Self { path, built_in } = *self;
        let text = if Path::new(path).is_file() {
            std::fs::read_to_string(path)
                .map_err(|error| Failure::io(path, &error, "is this a whole checkout?"))?
        } else {
            built_in.to_owned()
        };
        let rows = csv::Reader::from_reader(text.as_bytes()).into_deserialize();
        let rows: Result<Vec<T>, csv::Error> = rows.collect();
        rows.map_err(|error| Failure::Data(format!("{path}: {error}")))
    }
}
