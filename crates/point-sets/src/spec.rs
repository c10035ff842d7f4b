//! The name of a point set and its parameters, as text and as a value.

use crate::catalogue::{Entry, Generate, Kind, Parameter, catalogue};
use crate::error::{SpecError, expectation, nearest};
use crate::syntax;
use std::fmt;
use std::str::FromStr;

/// A point set: its name and its parameters.
///
/// Read from text: `disc`, `lattice:cols=10,rows=10`, or with a set inside a set
/// `duplicated:of=(lattice:cols=10),copies=3`. Printed in canonical form: parameters in the catalogue's order,
/// those at their defaults left out, so that equal specs print alike.
///
/// ```
/// use point_sets::Spec;
/// let spec: Spec = "duplicated:copies=3,of=disc".parse()?;
/// assert_eq!(spec.to_string(), "duplicated:copies=3");
/// assert_eq!(spec.name(), "duplicated");
///
/// let error = "lattice:columns=10".parse::<Spec>().unwrap_err();
/// assert_eq!(error.to_string(), "lattice has no parameter \"columns\"; it has cols, rows");
/// # Ok::<(), point_sets::SpecError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Spec {
    entry: &'static Entry,
    /// One for each of the entry's parameters.
    values: Vec<Value>,
}

/// The value of one parameter.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    /// A default that is a word, such as `auto`: decided when points are made.
    Open,
    Integer(i64),
    Number(f64),
    Word(&'static str),
    Set(Box<Spec>),
}

impl Spec {
    /// The name of the set, without its parameters.
    pub fn name(&self) -> &'static str {
        self.entry.name
    }

    /// Its entry in the catalogue.
    pub fn entry(&self) -> &'static Entry {
        self.entry
    }

    /// The dimension of the points: 2 for a set of the plane, 3 for a set of space.
    ///
    /// A set made of another has the dimension of that one.
    ///
    /// ```
    /// # use point_sets::Spec;
    /// assert_eq!("disc".parse::<Spec>()?.dimension(), 2);
    /// assert_eq!("shuffled:of=ball".parse::<Spec>()?.dimension(), 3);
    /// # Ok::<(), point_sets::SpecError>(())
    /// ```
    pub fn dimension(&self) -> usize {
        match self.entry.generate {
            Generate::Plane(_) => 2,
            Generate::Space(_) => 3,
            Generate::Either(..) => self.set("of").dimension(),
        }
    }

    /// The number of points that the parameters say there are: `cols` times `rows` if both are given, also
    /// inside another set.
    ///
    /// ```
    /// # use point_sets::Spec;
    /// assert_eq!("lattice:cols=4,rows=5".parse::<Spec>()?.size(), Some(20));
    /// assert_eq!("duplicated:of=(lattice:cols=4,rows=5),copies=3".parse::<Spec>()?.size(), Some(60));
    /// assert_eq!("lattice:cols=4".parse::<Spec>()?.size(), None);
    /// # Ok::<(), point_sets::SpecError>(())
    /// ```
    pub fn size(&self) -> Option<usize> {
        let declares = |name: &str| self.entry.parameters.iter().any(|p| p.name == name);
        let own = ["cols", "rows", "layers", "copies", "parts"].into_iter();
        let mut factors: Vec<Option<usize>> = own
            .filter(|name| declares(name))
            .map(|name| self.open_integer(name).map(|value| value as usize))
            .collect();
        if declares("of") {
            factors.push(self.set("of").size());
        }
        let product = |size: usize, factor: Option<usize>| size.checked_mul(factor?);
        (!factors.is_empty())
            .then_some(1)
            .and_then(|one| factors.into_iter().try_fold(one, product))
    }

    /// Makes `n` points of a set of the plane.
    ///
    /// The same spec, `n` and `seed` give the same bits on every machine. Sets without randomness ignore the
    /// seed.
    ///
    /// # Errors
    ///
    /// [`SpecError::TooMany`] or [`SpecError::Conflict`] if the set cannot have `n` points;
    /// [`SpecError::Dimension`] for a set of space.
    ///
    /// # Cost
    ///
    /// O(n) time and space.
    ///
    /// ```
    /// let disc: point_sets::Spec = "disc".parse()?;
    /// let points = disc.generate(1000, 7)?;
    /// assert!(points.iter().all(|[x, y]| x * x + y * y <= 1.0));
    /// # Ok::<(), point_sets::SpecError>(())
    /// ```
    pub fn generate(&self, n: usize, seed: u64) -> Result<Vec<[f64; 2]>, SpecError> {
        self.check_count(n)?;
        match self.entry.generate {
            Generate::Plane(make) | Generate::Either(make, _) => make(self, n, seed),
            Generate::Space(_) => Err(self.wrong_dimension(2)),
        }
    }

    /// Makes `n` points of a set of space; otherwise as [`generate`](Self::generate).
    ///
    /// # Errors
    ///
    /// As [`generate`](Self::generate), with [`SpecError::Dimension`] for a set of the plane.
    ///
    /// # Cost
    ///
    /// O(n) time and space.
    ///
    /// ```
    /// let ball: point_sets::Spec = "ball".parse()?;
    /// let points = ball.generate3(1000, 7)?;
    /// assert!(points.iter().all(|[x, y, z]| x * x + y * y + z * z <= 1.0));
    ///
    /// let disc: point_sets::Spec = "disc".parse()?;
    /// assert!(disc.generate3(10, 7).is_err());
    /// # Ok::<(), point_sets::SpecError>(())
    /// ```
    pub fn generate3(&self, n: usize, seed: u64) -> Result<Vec<[f64; 3]>, SpecError> {
        self.check_count(n)?;
        match self.entry.generate {
            Generate::Space(make) | Generate::Either(_, make) => make(self, n, seed),
            Generate::Plane(_) => Err(self.wrong_dimension(3)),
        }
    }

    fn check_count(&self, n: usize) -> Result<(), SpecError> {
        if u32::try_from(n).is_ok() {
            return Ok(());
        }
        Err(SpecError::TooMany {
            set: self.name(),
            limit: u32::MAX as usize,
            asked: n,
            reason: "points are named by 32-bit indices",
        })
    }

    fn wrong_dimension(&self, asked: usize) -> SpecError {
        SpecError::Dimension {
            set: self.name(),
            asked,
        }
    }

    /// The value of an integer parameter, or `None` if it is left open.
    pub(crate) fn open_integer(&self, parameter: &'static str) -> Option<i64> {
        match self.value(parameter) {
            Value::Integer(value) => Some(*value),
            _ => None,
        }
    }

    /// The value of an integer parameter that has a number as its default.
    pub(crate) fn integer(&self, parameter: &'static str) -> i64 {
        self.open_integer(parameter)
            .expect("declared as an integer with a number as its default")
    }

    /// The value of a number parameter, or `None` if it is left open.
    pub(crate) fn open_number(&self, parameter: &'static str) -> Option<f64> {
        match self.value(parameter) {
            Value::Number(value) => Some(*value),
            _ => None,
        }
    }

    /// The value of a number parameter that has a number as its default.
    pub(crate) fn number(&self, parameter: &'static str) -> f64 {
        self.open_number(parameter)
            .expect("declared as a number with a number as its default")
    }

    /// The value of a word parameter.
    pub(crate) fn word(&self, parameter: &'static str) -> &'static str {
        match self.value(parameter) {
            Value::Word(word) => word,
            _ => unreachable!("declared as a word"),
        }
    }

    /// The value of a set parameter.
    pub(crate) fn set(&self, parameter: &'static str) -> &Spec {
        match self.value(parameter) {
            Value::Set(spec) => spec,
            _ => unreachable!("declared as a set"),
        }
    }

    fn value(&self, parameter: &'static str) -> &Value {
        let declared = self.entry.parameters.iter().zip(&self.values);
        let mut named = declared.filter(|(declared, _)| declared.name == parameter);
        let (_, value) = named
            .next()
            .expect("a set asks only for its own parameters");
        value
    }
}

/// Points of the plane or of space, for sets made of other sets.
pub(crate) trait Made: Copy {
    /// Makes `n` points of `spec` of this dimension.
    fn made(spec: &Spec, n: usize, seed: u64) -> Result<Vec<Self>, SpecError>;
}

impl Made for [f64; 2] {
    fn made(spec: &Spec, n: usize, seed: u64) -> Result<Vec<Self>, SpecError> {
        spec.generate(n, seed)
    }
}

impl Made for [f64; 3] {
    fn made(spec: &Spec, n: usize, seed: u64) -> Result<Vec<Self>, SpecError> {
        spec.generate3(n, seed)
    }
}

/// Equal if they name the same set with the same values.
impl PartialEq for Spec {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name() && self.values == other.values
    }
}

impl FromStr for Spec {
    type Err = SpecError;

    fn from_str(text: &str) -> Result<Self, SpecError> {
        let (name, pairs) = syntax::split(text)?;
        let entry = find_entry(name)?;
        let mut given: Vec<Option<&str>> = vec![None; entry.parameters.len()];
        for (parameter, value) in pairs {
            let slot = find_parameter(entry, parameter)?;
            if given[slot].replace(value).is_some() {
                return Err(SpecError::Repeated {
                    set: entry.name,
                    parameter: entry.parameters[slot].name,
                });
            }
        }
        let values = entry.parameters.iter().zip(given);
        let values = values.map(|(parameter, given)| {
            read_value(entry, parameter, given.unwrap_or(parameter.default))
        });
        Ok(Spec {
            entry,
            values: values.collect::<Result<_, _>>()?,
        })
    }
}

fn find_entry(name: &str) -> Result<&'static Entry, SpecError> {
    let found = catalogue().iter().find(|entry| entry.name == name);
    found.ok_or_else(|| SpecError::UnknownSet {
        given: name.to_owned(),
        nearest: nearest(name, catalogue().iter().map(|entry| entry.name)),
    })
}

fn find_parameter(entry: &'static Entry, name: &str) -> Result<usize, SpecError> {
    let found = entry.parameters.iter().position(|p| p.name == name);
    found.ok_or_else(|| SpecError::UnknownParameter {
        set: entry.name,
        given: name.to_owned(),
        nearest: nearest(name, entry.parameters.iter().map(|p| p.name)),
    })
}

fn read_value(
    entry: &'static Entry,
    parameter: &'static Parameter,
    given: &str,
) -> Result<Value, SpecError> {
    let mut similar = None;
    let value = match parameter.kind {
        Kind::Integer { min, max } => given
            .parse()
            .ok()
            .filter(|value| (min..=max).contains(value))
            .map(Value::Integer),
        // Adding zero turns -0 into 0, so that equal numbers print alike.
        Kind::Number => given
            .parse()
            .ok()
            .filter(|value: &f64| value.is_finite())
            .map(|value| Value::Number(value + 0.0)),
        Kind::Word(words) => {
            similar = nearest(given, words.iter().copied());
            let word = words.iter().find(|word| **word == given);
            word.map(|word| Value::Word(word))
        }
        Kind::Set => return Ok(Value::Set(Box::new(given.parse()?))),
    };
    match value {
        Some(value) => Ok(value),
        None if given == parameter.default => Ok(Value::Open),
        None => Err(SpecError::Value {
            set: entry.name,
            parameter: parameter.name,
            given: given.to_owned(),
            expected: expectation(parameter),
            nearest: similar,
        }),
    }
}

impl fmt::Display for Spec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())?;
        let mut separator = ':';
        for (parameter, value) in self.entry.parameters.iter().zip(&self.values) {
            let text = value.to_string();
            if text == parameter.default || *value == Value::Open {
                continue;
            }
            write!(f, "{separator}{}=", parameter.name)?;
            if syntax::needs_parentheses(&text) {
                write!(f, "({text})")?;
            } else {
                f.write_str(&text)?;
            }
            separator = ',';
        }
        Ok(())
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Open => Ok(()),
            Value::Integer(value) => write!(f, "{value}"),
            Value::Number(value) => write!(f, "{value}"),
            Value::Word(word) => f.write_str(word),
            Value::Set(spec) => write!(f, "{spec}"),
        }
    }
}
