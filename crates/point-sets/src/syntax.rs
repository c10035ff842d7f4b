//! The text of a spec: `name` or `name:parameter=value,parameter=value`, a value in parentheses if it holds
//! a comma, a colon or an equals sign.

use crate::error::SpecError;

/// How deep sets may be nested in sets.
const DEPTH: usize = 8;

/// A parameter's name and its value.
type Pair<'a> = (&'a str, &'a str);

/// The name and the `(parameter, value)` pairs of `text`, values without their parentheses.
pub(crate) fn split(text: &str) -> Result<(&str, Vec<Pair<'_>>), SpecError> {
    check_parentheses(text)?;
    let Some((name, rest)) = text.split_once(':') else {
        return Ok((text.trim(), Vec::new()));
    };
    let mut pairs = Vec::new();
    for part in top_level_commas(rest) {
        let (parameter, value) = part
            .split_once('=')
            .ok_or_else(|| error(text, offset(text, part), "parameter=value expected"))?;
        let value = unwrapped(value.trim());
        if value.is_empty() {
            return Err(error(text, offset(text, part), "a value is missing"));
        }
        pairs.push((parameter.trim(), value));
    }
    Ok((name.trim(), pairs))
}

/// Whether a value has to stand in parentheses.
pub(crate) fn needs_parentheses(value: &str) -> bool {
    value.contains([',', ':', '=', '(', ')'])
}

fn check_parentheses(text: &str) -> Result<(), SpecError> {
    let mut depth = 0_usize;
    for (at, letter) in text.char_indices() {
        match letter {
            '(' if depth == DEPTH => return Err(error(text, at, "sets nested too deep")),
            '(' => depth += 1,
            ')' if depth == 0 => return Err(error(text, at, "a parenthesis was never opened")),
            ')' => depth -= 1,
            _ => {}
        }
    }
    if depth > 0 {
        return Err(error(text, text.len(), "a parenthesis is not closed"));
    }
    Ok(())
}

fn top_level_commas(text: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_usize;
    text.split(move |letter| {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        letter == ',' && depth == 0
    })
}

fn unwrapped(value: &str) -> &str {
    value
        .strip_prefix('(')
        .and_then(|value| value.strip_suffix(')'))
        .unwrap_or(value)
        .trim()
}

/// Where in `text` its part begins, in bytes.
fn offset(text: &str, part: &str) -> usize {
    part.as_ptr() as usize - text.as_ptr() as usize
}

fn error(text: &str, at: usize, problem: &'static str) -> SpecError {
    SpecError::Syntax {
        text: text.to_owned(),
        position: text[..at].chars().count() + 1,
        problem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_pairs() {
        assert_eq!(split("disc").unwrap(), ("disc", vec![]));
        let (name, pairs) = split("duplicated:copies=3, of=(lattice:cols=2,rows=3)").unwrap();
        assert_eq!(name, "duplicated");
        assert_eq!(pairs, [("copies", "3"), ("of", "lattice:cols=2,rows=3")]);
    }

    #[test]
    fn places_of_mistakes() {
        for (text, place) in [
            ("lattice:", 9),
            ("lattice:cols", 9),
            ("lattice:cols=3,", 16),
            ("lattice:cols=", 9),
            ("a:b=(c", 7),
            ("a:b=c)", 6),
            ("ä:b=c)", 6),
        ] {
            match split(text) {
                Err(SpecError::Syntax { position, .. }) => assert_eq!(position, place, "{text}"),
                other => panic!("{text}: {other:?}"),
            }
        }
    }

    #[test]
    fn nesting_has_an_end() {
        let deep = format!("{}disc{}", "shuffled:of=(".repeat(9), ")".repeat(9));
        assert!(matches!(split(&deep), Err(SpecError::Syntax { .. })));
    }
}
