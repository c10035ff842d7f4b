//! Why a point set could not be named or made.

use crate::catalogue::{Entry, Kind, Parameter, catalogue};
use thiserror::Error;

/// What is wrong with a [`Spec`](crate::Spec), or with what is asked of it. Every message says what is
/// possible, and what was probably meant.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SpecError {
    /// No set has this name.
    #[error("there is no point set {given:?}{}; there are {}", suggestion(.nearest), names(catalogue(), |e| e.name))]
    UnknownSet {
        /// The name as given.
        given: String,
        /// The most similar name, if one is similar.
        nearest: Option<&'static str>,
    },
    /// The set has no parameter of this name.
    #[error("{set} has no parameter {given:?}{}; {}", suggestion(.nearest), possible(set))]
    UnknownParameter {
        /// The set.
        set: &'static str,
        /// The name as given.
        given: String,
        /// The most similar name, if one is similar.
        nearest: Option<&'static str>,
    },
    /// A parameter is given twice.
    #[error("{set}: {parameter} is given twice; give it once")]
    Repeated {
        /// The set.
        set: &'static str,
        /// The parameter.
        parameter: &'static str,
    },
    /// A parameter's value is not one that it takes.
    #[error("{set}: {parameter}={given} is not possible; {parameter} is {expected}{}", suggestion(.nearest))]
    Value {
        /// The set.
        set: &'static str,
        /// The parameter.
        parameter: &'static str,
        /// The value as given.
        given: String,
        /// Which values there are.
        expected: String,
        /// The most similar value, if one is similar.
        nearest: Option<&'static str>,
    },
    /// The text is not of the form `name` or `name:parameter=value,...`.
    #[error(
        "{text:?} at character {position}: {problem}; write name, or name:parameter=value,parameter=value, \
         with a set inside a set in parentheses"
    )]
    Syntax {
        /// The whole text.
        text: String,
        /// The 1-based character at which it goes wrong.
        position: usize,
        /// What is wrong there.
        problem: &'static str,
    },
    /// Parameters, or parameters and the number of points, do not go together.
    #[error("{set}: {problem}")]
    Conflict {
        /// The set.
        set: &'static str,
        /// What does not go together, and what would.
        problem: String,
    },
    /// The set is of the plane and a set of space is asked for, or the other way round.
    #[error("{set} is a set of {} and a set of {} is needed; take {}", place(5 - .asked), place(*.asked), sets_of(*.asked))]
    Dimension {
        /// The set.
        set: &'static str,
        /// The dimension asked for: 2 or 3.
        asked: usize,
    },
    /// The set cannot be made that large.
    #[error("{set} has at most {limit} points and {asked} are asked: {reason}")]
    TooMany {
        /// The set.
        set: &'static str,
        /// The largest possible number of points.
        limit: usize,
        /// The number asked for.
        asked: usize,
        /// What ends at the limit.
        reason: &'static str,
    },
}

fn suggestion(nearest: &Option<&'static str>) -> String {
    nearest.map_or(String::new(), |name| format!(" (did you mean {name}?)"))
}

fn names<T>(of: &[T], name: fn(&T) -> &'static str) -> String {
    of.iter().map(name).collect::<Vec<_>>().join(", ")
}

fn place(dimension: usize) -> &'static str {
    if dimension == 2 { "the plane" } else { "space" }
}

fn sets_of(dimension: usize) -> String {
    let only = |entry: &&Entry| entry.dimensions() == [dimension];
    let names: Vec<_> = catalogue().iter().filter(only).map(|e| e.name).collect();
    format!("one of {}, or a set made of one of these", names.join(", "))
}

fn possible(set: &str) -> String {
    match parameters(set) {
        [] => "it has none".to_owned(),
        parameters => format!("it has {}", names(parameters, |p: &Parameter| p.name)),
    }
}

fn parameters(set: &str) -> &'static [Parameter] {
    let entry: Option<&Entry> = catalogue().iter().find(|entry| entry.name == set);
    entry.map_or(&[], |entry| entry.parameters)
}

/// Which values a parameter takes, in words.
pub(crate) fn expectation(parameter: &Parameter) -> String {
    let values = match parameter.kind {
        Kind::Integer { min, max } => format!("a whole number from {min} to {max}"),
        Kind::Number => "a finite number".to_owned(),
        Kind::Word(words) => return format!("one of {}", words.join(", ")),
        Kind::Set => return "a point set, in parentheses if it has parameters".to_owned(),
    };
    match parameter.default.parse::<f64>() {
        Ok(_) => values,
        Err(_) => format!("{values}, or {}", parameter.default),
    }
}

/// The candidate most similar to `given`, if at most a third of its letters are wrong.
pub(crate) fn nearest<'a>(
    given: &str,
    candidates: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let given = given.to_lowercase();
    candidates
        .map(|candidate| (edit_distance(&given, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= 1.max(candidate.len() / 3))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Levenshtein's distance: how many letters to insert, remove or replace.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for j in 0..b.len() {
            let replaced = diagonal + usize::from(letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_of_words() {
        for (a, b, distance) in [
            ("", "abc", 3),
            ("disc", "disk", 1),
            ("kitten", "sitting", 3),
        ] {
            assert_eq!(edit_distance(a, b), distance, "{a} {b}");
            assert_eq!(edit_distance(b, a), distance, "{b} {a}");
        }
    }

    #[test]
    fn only_similar_words_are_suggested() {
        let words = || ["disc", "lattice", "near-collinear"].into_iter();
        assert_eq!(nearest("disk", words()), Some("disc"));
        assert_eq!(nearest("Lattis", words()), Some("lattice"));
        assert_eq!(nearest("near_colinear", words()), Some("near-collinear"));
        assert_eq!(nearest("banana", words()), None);
    }
}
