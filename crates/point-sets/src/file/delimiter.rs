//! What separates the fields of a record, and where the fields are.

use std::ops::Range;

/// What separates fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Delimiter {
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// A tab.
    Tab,
    /// Any number of blanks and tabs.
    Whitespace,
}

/// Why a record could not be split; offsets are in bytes.
#[derive(Debug, PartialEq)]
pub(super) enum SplitError {
    /// The quote at this offset is not closed.
    Unclosed(usize),
    /// At this offset text follows a closed quote.
    AfterQuote(usize),
}

/// Where a field ends, and where the blanks after it do: at a separator, or at the end of the text.
struct End {
    field: usize,
    margin: usize,
}

impl Delimiter {
    /// Its name, for messages.
    pub fn name(self) -> &'static str {
        match self {
            Delimiter::Comma => ",",
            Delimiter::Semicolon => ";",
            Delimiter::Tab => "tab",
            Delimiter::Whitespace => "blank",
        }
    }

    /// What separates the fields of `text`: the first of tab, semicolon and comma that occurs outside
    /// quotes, else blanks.
    ///
    /// Semicolons come before commas because a comma beside a semicolon is a decimal comma.
    pub(super) fn detect(text: &str) -> Self {
        let unquoted: Vec<&str> = text.trim().split('"').step_by(2).collect();
        let occurs = |letter| unquoted.iter().any(|part| part.contains(letter));
        match () {
            () if occurs('\t') => Delimiter::Tab,
            () if occurs(';') => Delimiter::Semicolon,
            () if occurs(',') => Delimiter::Comma,
            () => Delimiter::Whitespace,
        }
    }

    fn separates(self, byte: u8) -> bool {
        match self {
            Delimiter::Comma => byte == b',',
            Delimiter::Semicolon => byte == b';',
            Delimiter::Tab => byte == b'\t',
            Delimiter::Whitespace => byte == b' ' || byte == b'\t',
        }
    }

    /// Puts into `fields` where the fields of `text` are, without the blanks around them, quotes included.
    ///
    /// A field is quoted if its first character is a quote; then it goes on to the next quote that is not
    /// doubled.
    pub(super) fn split(
        self,
        text: &str,
        fields: &mut Vec<Range<usize>>,
    ) -> Result<(), SplitError> {
        fields.clear();
        let mut at = 0;
        loop {
            let start = self.skip_blanks(text, at);
            if self == Delimiter::Whitespace && start == text.len() {
                return Ok(());
            }
            let end = if text[start..].starts_with('"') {
                self.quoted_end(text, start)?
            } else {
                self.plain_end(text, start)
            };
            fields.push(start..end.field);
            if end.margin == text.len() {
                return Ok(());
            }
            at = end.margin + 1;
        }
    }

    fn plain_end(self, text: &str, start: usize) -> End {
        let rest = &text.as_bytes()[start..];
        let length = rest
            .iter()
            .position(|&byte| self.separates(byte))
            .unwrap_or(rest.len());
        End {
            field: start + rest[..length].trim_ascii_end().len(),
            margin: start + length,
        }
    }

    fn quoted_end(self, text: &str, start: usize) -> Result<End, SplitError> {
        let field = quote_end(text.as_bytes(), start).ok_or(SplitError::Unclosed(start))?;
        let margin = match self {
            Delimiter::Whitespace => field,
            _ => self.skip_blanks(text, field),
        };
        match text.as_bytes().get(margin) {
            Some(&byte) if !self.separates(byte) => Err(SplitError::AfterQuote(margin)),
            _ => Ok(End { field, margin }),
        }
    }

    /// The first offset from `at` that is not a blank inside a field's margin.
    fn skip_blanks(self, text: &str, mut at: usize) -> usize {
        let bytes = text.as_bytes();
        let margin = |byte: u8| byte == b' ' || (byte == b'\t' && self != Delimiter::Tab);
        while at < bytes.len() && margin(bytes[at]) {
            at += 1;
        }
        at
    }
}

/// The offset after the quote that closes the one at `start`.
fn quote_end(bytes: &[u8], start: usize) -> Option<usize> {
    let mut at = start + 1;
    loop {
        at += bytes[at..].iter().position(|&byte| byte == b'"')? + 1;
        if bytes.get(at) != Some(&b'"') {
            return Some(at);
        }
        at += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(delimiter: Delimiter, text: &str) -> Vec<&str> {
        let mut fields = Vec::new();
        delimiter.split(text, &mut fields).unwrap();
        fields.into_iter().map(|range| &text[range]).collect()
    }

    #[test]
    fn fields_and_margins() {
        use Delimiter::*;
        assert_eq!(parts(Comma, " 1 ,2,, \t4 "), ["1", "2", "", "4"]);
        assert_eq!(parts(Comma, ","), ["", ""]);
        assert_eq!(parts(Tab, "1\t\t 3"), ["1", "", "3"]);
        assert_eq!(parts(Whitespace, "  1 \t 2  "), ["1", "2"]);
        assert_eq!(parts(Semicolon, "1,5;2,5"), ["1,5", "2,5"]);
        assert_eq!(parts(Comma, r#""a, ""b""" , 2"#), [r#""a, ""b""""#, "2"]);
        assert_eq!(parts(Whitespace, r#""New York" 2"#), [r#""New York""#, "2"]);
        assert_eq!(parts(Comma, r#"5" pipe,2"#), [r#"5" pipe"#, "2"]);
    }

    #[test]
    fn quotes_gone_wrong() {
        use Delimiter::*;
        let split = |delimiter: Delimiter, text| delimiter.split(text, &mut Vec::new());
        assert_eq!(split(Comma, r#"1,"2"#), Err(SplitError::Unclosed(2)));
        assert_eq!(split(Comma, r#"1,"2"3"#), Err(SplitError::AfterQuote(5)));
        assert_eq!(split(Whitespace, r#""1"2"#), Err(SplitError::AfterQuote(3)));
    }

    #[test]
    fn detection() {
        use Delimiter::*;
        for (text, delimiter) in [
            ("1,2", Comma),
            ("1,5;2,5", Semicolon),
            ("1\t2", Tab),
            ("1 2", Whitespace),
            ("1, 2", Comma),
            (r#""a,b" "c;d""#, Whitespace),
            ("\t1 2\t", Whitespace),
        ] {
            assert_eq!(Delimiter::detect(text), delimiter, "{text}");
        }
    }
}
