//! One stop: every engine is judged, those that are certified are timed in turn, then counted.

use super::judge::{Judgement, Reference};
use super::ledger::Ledger;
use super::plan::Stop;
use super::realisation::Realisation;
use super::roster::Roster;
use super::{Depth, instructions};
use crate::definition::Measure;
use crate::engine::client::Session;
use crate::engine::fault::Fault;
use crate::engine::protocol::Run;
use crate::records::rows::twin_of;
use crate::records::{Cell, Count, Outcome, Sample, Subject};
use anyhow::{Context, Result};
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use std::num::{NonZeroU32, NonZeroU64};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// A sample lasts at least this long, so that the clock's grain does not show.
const SHORTEST: Duration = Duration::from_millis(2);

/// How long an engine may take to start and to end.
const POLITE: Duration = Duration::from_secs(20);

/// An engine that has been certified here.
struct Contestant {
    subject: Subject,
    session: Session,
    /// Passes over the sets that make a sample long enough.
    passes: NonZeroU32,
}

/// Visits `stop`; what is recorded already is not done again.
pub(super) fn visit(
    stop: &Stop<'_>,
    depth: Depth,
    roster: &Roster,
    ledger: &Mutex<&mut Ledger>,
) -> Result<()> {
    let wants = |measure| depth == Depth::Measure && stop.block.measure.contains(&measure);
    let rounds = if wants(Measure::Time) {
        stop.block.rounds
    } else {
        0
    };
    let wants_counts = wants(Measure::Counts) || wants(Measure::Instructions);
    let open = stop
        .engines
        .iter()
        .filter(|engine| !locked(ledger).is_done(&subject(stop, engine), rounds, wants_counts));
    let open: Vec<&String> = open.collect();
    if open.is_empty() {
        return Ok(());
    }
    let realisation = Realisation::generate(stop).with_context(|| stop.name())?;
    let mut reference = Reference::new(stop.definition.problem, stop.definition.boundary.into());
    let mut contestants = Vec::new();
    for engine in open {
        let subject = subject(stop, engine);
        let given_up = locked(ledger).given_up(&subject);
        let entered = match given_up {
            Some(finding) => Err((Outcome::Timeout, finding)),
            None => enter(stop, &subject, &realisation, &mut reference, roster, ledger),
        };
        let cell = match entered {
            Ok((contestant, judgement)) => {
                let cell = cell(&subject, &realisation, judgement);
                if cell.outcome == Outcome::Certified {
                    contestants.push(contestant);
                }
                cell
            }
            Err((outcome, finding)) => cell(
                &subject,
                &realisation,
                Judgement::without_answer(outcome, finding),
            ),
        };
        locked(ledger).cell(cell)?;
    }
    time(stop, &realisation, rounds, &mut contestants, ledger)?;
    if wants_counts {
        count(stop, &realisation, roster, &mut contestants, ledger)?;
    }
    for contestant in contestants {
        contestant.session.quit(POLITE);
    }
    Ok(())
}

/// The ledger, for one entry. What a panic elsewhere has left is whole lines all the same.
fn locked<'a, 'm>(ledger: &'a Mutex<&'m mut Ledger>) -> MutexGuard<'a, &'m mut Ledger> {
    ledger.lock().unwrap_or_else(PoisonError::into_inner)
}

fn subject(stop: &Stop<'_>, engine: &str) -> Subject {
    Subject {
        case: stop.case(),
        seed: stop.seed(),
        engine: engine.to_owned(),
    }
}

fn limit(stop: &Stop<'_>) -> Duration {
    Duration::from_secs(stop.block.timeout_seconds)
}

fn cell(subject: &Subject, realisation: &Realisation, judgement: Judgement) -> Cell {
    Cell {
        subject: subject.clone(),
        fingerprint: realisation.fingerprint.clone(),
        outcome: judgement.outcome,
        h: judgement.h,
        facets: judgement.facets,
        finding: judgement.finding,
    }
}

/// Starts an engine, hands it the points, runs it once and judges what it says of every set.
fn enter(
    stop: &Stop<'_>,
    subject: &Subject,
    realisation: &Realisation,
    reference: &mut Reference,
    roster: &Roster,
    ledger: &Mutex<&mut Ledger>,
) -> Result<(Contestant, Judgement), (Outcome, String)> {
    let mut tried = || -> Result<(Session, Judgement, Duration), Fault> {
        let mut session = Session::start(&roster.launch(&subject.engine)?, POLITE)?;
        locked(ledger).met(&subject.engine, session.receipt());
        let (problem, sets) = (stop.definition.problem, &realisation.sets);
        session.load_sets(problem, stop.definition.boundary, sets, limit(stop))?;
        let timed = session.run(Run::ONCE, limit(stop))?;
        if let Some(about) = roster.yardstick(&subject.engine) {
            return Ok((session, Judgement::yardstick(about), timed.elapsed));
        }
        let mut judgements = Vec::new();
        for (number, set) in (0..).zip(sets) {
            let answer = session.hull_of(number, limit(stop))?;
            judgements.push(reference.judge(number as usize, set, &answer));
        }
        Ok((session, Judgement::of_all(judgements), timed.elapsed))
    };
    let (session, judgement, once) =
        tried().map_err(|fault| (outcome(&fault), fault.to_string()))?;
    let passes = SHORTEST.as_nanos().div_ceil(once.as_nanos().max(1));
    let passes = u32::try_from(passes).ok().and_then(NonZeroU32::new);
    let contestant = Contestant {
        subject: subject.clone(),
        session,
        passes: passes.unwrap_or(NonZeroU32::MIN),
    };
    Ok((contestant, judgement))
}

fn outcome(fault: &Fault) -> Outcome {
    match fault {
        Fault::Refused { .. } => Outcome::Refused,
        Fault::Timeout { .. } => Outcome::Timeout,
        Fault::Crashed { .. } => Outcome::Crashed,
        Fault::Garbled { .. } => Outcome::Garbled,
        Fault::Absent { .. } => Outcome::Absent,
    }
}

/// One sample of every contestant a round, in an order shuffled anew. The first, not recorded, is to warm up and to
/// learn how many passes last long enough; who fails on the way is heard no more.
fn time(
    stop: &Stop<'_>,
    realisation: &Realisation,
    rounds: u32,
    contestants: &mut Vec<Contestant>,
    ledger: &Mutex<&mut Ledger>,
) -> Result<()> {
    if rounds == 0 {
        return Ok(());
    }
    contestants.retain_mut(|contestant| match sample(stop, contestant) {
        Ok(nanoseconds) => {
            let wanted = SHORTEST.as_nanos() as u64 * u64::from(contestant.passes.get());
            let passes = wanted
                .div_ceil(nanoseconds.max(1))
                .clamp(1, u64::from(u32::MAX)) as u32;
            contestant.passes = NonZeroU32::new(passes).unwrap_or(NonZeroU32::MIN);
            true
        }
        Err(fault) => {
            locked(ledger).failed_late(&contestant.subject, &fault);
            false
        }
    });
    let mut random = ChaCha8Rng::seed_from_u64(stop.seed());
    for round in 0..rounds {
        contestants.shuffle(&mut random);
        let mut failed = Vec::new();
        for contestant in contestants.iter_mut() {
            if locked(ledger).has_round(&contestant.subject, round) {
                continue;
            }
            match sample(stop, contestant) {
                Ok(nanoseconds) => {
                    let sets = realisation.sets.len() as u64;
                    let calls = u64::from(contestant.passes.get()) * sets;
                    locked(ledger).sample(Sample {
                        subject: contestant.subject.clone(),
                        round,
                        inner: NonZeroU64::new(calls).unwrap_or(NonZeroU64::MIN),
                        nanoseconds,
                    })?;
                }
                Err(fault) => {
                    locked(ledger).failed_late(&contestant.subject, &fault);
                    failed.push(contestant.subject.clone());
                }
            }
        }
        contestants.retain(|contestant| !failed.contains(&contestant.subject));
    }
    Ok(())
}

fn sample(stop: &Stop<'_>, contestant: &mut Contestant) -> Result<u64, Fault> {
    let run = Run {
        samples: NonZeroU32::MIN,
        inner: contestant.passes,
    };
    let timed = contestant.session.run(run, limit(stop))?;
    Ok(timed.nanoseconds.iter().sum())
}

/// Integers from runs of their own on the first set alone: a count is that of one call. A twin counts what its engine
/// does.
fn count(
    stop: &Stop<'_>,
    realisation: &Realisation,
    roster: &Roster,
    contestants: &mut [Contestant],
    ledger: &Mutex<&mut Ledger>,
) -> Result<()> {
    for contestant in contestants {
        let subject = &contestant.subject;
        if twin_of(&subject.engine).is_some() || locked(ledger).is_counted(subject) {
            continue;
        }
        let (problem, boundary) = (stop.definition.problem, stop.definition.boundary);
        let mut counters = BTreeMap::new();
        if stop.block.measure.contains(&Measure::Counts) {
            let session = &mut contestant.session;
            let one = &realisation.sets[..1];
            let loaded = session.load_sets(problem, boundary, one, limit(stop));
            match loaded.and_then(|()| session.counters(limit(stop))) {
                Ok(counted) => counters.extend(counted),
                Err(fault) => locked(ledger).failed_late(subject, &fault),
            }
        }
        if stop.block.measure.contains(&Measure::Instructions) && roster.has_valgrind() {
            let question = instructions::Question {
                problem,
                boundary,
                set: &realisation.sets[0],
                limit: limit(stop),
            };
            let launch = roster.launch(&subject.engine);
            match launch.and_then(|launch| instructions::of_a_call(&launch, &question)) {
                Ok(count) => _ = counters.insert(instructions::COUNTER.to_owned(), count),
                Err(fault) => locked(ledger).uncounted(subject, &fault),
            }
        }
        let row = |(counter, value)| Count {
            subject: subject.clone(),
            counter,
            value,
        };
        let rows = counters.into_iter().map(row).collect();
        locked(ledger).counts(subject, rows)?;
    }
    Ok(())
}
