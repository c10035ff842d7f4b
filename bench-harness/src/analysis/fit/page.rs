//! The answer, for readers and programs.

use super::{Fits, Fitted, Quantity};
use crate::output::page::{Page, Section};
use crate::output::sheet::Sheet;
use crate::stats::growth::Lower;
use crate::stats::growth::choice::Candidate;
use serde_json::{Value, json};

impl Quantity {
    /// What it is called.
    pub fn name(&self) -> &str {
        match self {
            Quantity::Time => "nanoseconds",
            Quantity::Counter(counter) => counter,
        }
    }
}

impl Fits {
    /// The answer for readers and programs.
    pub fn page(&self) -> Page {
        let mut sections = vec![self.overview()];
        sections.extend(self.fitted.iter().map(section));
        let declared = self.fitted.iter().filter(|fitted| fitted.law().is_some());
        Page {
            title: format!("Growth of {}", self.quantity.name()),
            preface: vec![
                "A law is declared only if AICc prefers it to each other by more than 10, it foretells the upper 30 % \
                 of the sizes best from the lower 70 %, and what it leaves over has no pattern (runs test, p > 0.05, or \
                 less than 0.5 % of the cost). Otherwise the data do not say on this range."
                    .into(),
            ],
            sections,
            long: self.long(),
            value: self.value(),
            headline: format!(
                "{} of {} engines and sets have a law",
                declared.count(),
                self.fitted.len()
            ),
        }
    }

    /// One line an engine and set.
    fn overview(&self) -> Section {
        let mut sheet = Sheet::new(&["set", "engine", "n", "h", "slope", "verdict"]);
        for fitted in &self.fitted {
            sheet.push(vec![
                fitted.set.clone(),
                fitted.engine.clone(),
                fitted.range_text(),
                fitted.h_text(),
                fitted.slope_text(),
                fitted.verdict(),
            ]);
        }
        Section {
            heading: "Verdicts".into(),
            sheet,
            notes: Vec::new(),
        }
    }

    /// One line a candidate.
    fn long(&self) -> Sheet {
        let mut sheet = Sheet::new(&[
            "definition",
            "set",
            "engine",
            "quantity",
            "law",
            "lower_term",
            "leading",
            "leading_error",
            "correction",
            "scatter",
            "aicc_behind",
            "foretold",
            "share",
            "is_correction",
            "runs_p",
            "expected_slope",
            "verdict",
        ]);
        for fitted in &self.fitted {
            for candidate in &fitted.choice.candidates {
                let fit = &candidate.fit;
                let slope = fitted.expected_slope(candidate);
                sheet.push(vec![
                    fitted.definition.clone(),
                    fitted.set.clone(),
                    fitted.engine.clone(),
                    self.quantity.name().to_owned(),
                    fit.law.to_string(),
                    fit.lower.to_string().trim_start_matches(" + ").to_owned(),
                    fit.leading.to_string(),
                    fit.leading_error().to_string(),
                    fit.correction.to_string(),
                    fit.scatter.to_string(),
                    candidate.behind.to_string(),
                    candidate
                        .foretold
                        .map_or_else(String::new, |e| e.to_string()),
                    candidate.share.to_string(),
                    candidate.is_correction.to_string(),
                    candidate.runs_p.to_string(),
                    slope.map_or_else(String::new, |slope| slope.to_string()),
                    fitted.verdict(),
                ]);
            }
        }
        sheet
    }

    fn value(&self) -> Value {
        let candidate = |fitted: &Fitted, candidate: &Candidate| {
            let fit = &candidate.fit;
            json!({
                "law": fit.law.to_string(),
                "lower_term": fit.lower.to_string().trim_start_matches(" + "),
                "leading": fit.leading,
                "leading_error": fit.leading_error(),
                "correction": fit.correction,
                "scatter": fit.scatter,
                "aicc": fit.aicc,
                "aicc_behind": candidate.behind,
                "foretold": candidate.foretold,
                "share": candidate.share,
                "is_correction": candidate.is_correction,
                "runs_p": candidate.runs_p,
                "expected_slope": fitted.expected_slope(candidate),
            })
        };
        let local = |fitted: &Fitted| -> Vec<Value> {
            let slopes = fitted.local.iter();
            slopes
                .map(|slope| json!({"from": slope.from, "to": slope.to, "slope": slope.slope, "error": slope.error}))
                .collect()
        };
        let one = |fitted: &Fitted| {
            let candidates = fitted.choice.candidates.iter();
            let interval = fitted.line.map(|line| line.slope_interval(0.95));
            json!({
                "definition": fitted.definition,
                "set": fitted.set,
                "engine": fitted.engine,
                "sizes": fitted.choice.sizes,
                "law": fitted.law().map(|law| law.to_string()),
                "verdict": fitted.verdict(),
                "slope": fitted.line.map(|line| line.slope),
                "slope_interval": interval,
                "cost_a_point_b": fitted.a_point.map(|line| line.slope),
                "cost_a_point_b_interval": fitted.a_point.map(|line| line.slope_interval(0.95)),
                "local_slopes": local(fitted),
                "candidates": candidates.map(|c| candidate(fitted, c)).collect::<Vec<_>>(),
            })
        };
        json!({
            "quantity": self.quantity.name(),
            "fits": self.fitted.iter().map(one).collect::<Vec<_>>(),
        })
    }
}

/// The candidates of one engine on one set.
fn section(fitted: &Fitted) -> Section {
    let mut sheet = Sheet::new(&[
        "law",
        "fitted",
        "scatter",
        "AICc behind",
        "foretold within",
        "own term",
        "runs p",
        "slope here",
    ]);
    for candidate in &fitted.choice.candidates {
        let fit = &candidate.fit;
        let correction = match fit.lower {
            Lower::Absent => String::new(),
            Lower::Constant => format!(" {:+.3e}", fit.correction),
            Lower::Linear => format!(" {:+.3e} n", fit.correction),
        };
        let own = format!("{:.0} %", 100.0 * candidate.share);
        sheet.push(vec![
            fit.law.to_string(),
            format!("{:.4e} {}{correction}", fit.leading, fit.law),
            percent(Some(fit.scatter)),
            format!("{:.1}", candidate.behind),
            percent(candidate.foretold),
            if candidate.is_correction {
                format!("{own}: a correction")
            } else {
                own
            },
            format!("{:.3}", candidate.runs_p),
            fitted
                .expected_slope(candidate)
                .map_or_else(String::new, |slope| format!("{slope:.3}")),
        ]);
    }
    Section {
        heading: format!(
            "{} on {}/{}: {}",
            fitted.engine,
            fitted.definition,
            fitted.set,
            fitted.verdict()
        ),
        sheet,
        notes: fitted.notes(),
    }
}

impl Fitted {
    fn expected_slope(&self, candidate: &Candidate) -> Option<f64> {
        let found = self
            .expected
            .iter()
            .find(|(law, _)| *law == candidate.fit.law);
        found.map(|(_, slope)| *slope)
    }

    fn range_text(&self) -> String {
        match &self.choice.sizes[..] {
            [] => String::new(),
            [only] => only.to_string(),
            [first, .., last] => format!("{first}–{last}"),
        }
    }

    /// The median h at the least and at the largest n.
    fn h_text(&self) -> String {
        let at = |n: Option<&f64>| {
            let of_size = self.data.iter().filter(|place| Some(&place.n) == n);
            let known: Vec<f64> = of_size.filter_map(|place| place.h).collect();
            (!known.is_empty()).then(|| crate::stats::summary::median(&known))
        };
        match [at(self.choice.sizes.first()), at(self.choice.sizes.last())] {
            [Some(first), Some(last)] => format!("{first:.0}–{last:.0}"),
            _ => "?".into(),
        }
    }

    fn slope_text(&self) -> String {
        self.line.map_or_else(String::new, |line| {
            let (low, high) = line.slope_interval(0.95);
            format!("{:.3} [{low:.3}, {high:.3}]", line.slope)
        })
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = vec![format!(
            "n {}, h {}; slope of the logarithms {}",
            self.range_text(),
            self.h_text(),
            self.slope_text()
        )];
        if let Some(line) = self.a_point {
            let (low, high) = line.slope_interval(0.95);
            notes.push(format!(
                "cost a point = a + b ln n: b = {:.4} [{low:.4}, {high:.4}]; 0 for n, above it for n log n",
                line.slope
            ));
        }
        let slopes: Vec<String> = self
            .local
            .iter()
            .map(|slope| match slope.error {
                error if error.is_finite() => format!("{:.3} ± {error:.3}", slope.slope),
                _ => format!("{:.3}", slope.slope),
            })
            .collect();
        notes.push(format!("slopes from size to size: {}", slopes.join(", ")));
        for (cache, n) in &self.borders {
            notes.push(format!(
                "the points fill the L{} cache at n = {n:.0}",
                cache.level
            ));
        }
        notes
    }
}

fn percent(part: Option<f64>) -> String {
    part.map_or_else(String::new, |part| format!("{:.2} %", 100.0 * part))
}
