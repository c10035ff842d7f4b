//! Commands and replies as they are written down.

use super::*;

fn some(number: u32) -> NonZeroU32 {
    NonZeroU32::new(number).unwrap()
}

#[test]
fn every_command_is_read_as_it_was_written() {
    let load = |boundary, sets| Load {
        task: Problem::Hull2,
        n: 1000,
        sets: some(sets),
        dimension: 2,
        boundary,
    };
    for command in [
        Command::Version,
        Command::Load(load(Convention::Extreme, 1)),
        Command::Load(load(Convention::All, 200)),
        Command::Run(Run {
            samples: some(3),
            inner: some(16),
        }),
        Command::Hull(Which { set: 0 }),
        Command::Hull(Which { set: 7 }),
        Command::Counters,
        Command::Quit,
    ] {
        assert_eq!(command.to_string().parse(), Ok(command));
    }
}

#[test]
fn commands_look_as_they_are_written_down() {
    for text in [
        r#"load {"task":"hull3","n":1000,"dimension":3,"boundary":"extreme"}"#,
        r#"load {"task":"hull2","n":100,"sets":200,"dimension":2,"boundary":"extreme"}"#,
        r#"run {"samples":3,"inner":16}"#,
        "hull",
        r#"hull {"set":7}"#,
    ] {
        let command: Command = text.parse().unwrap();
        assert_eq!(command.to_string(), text);
    }
    let first: Command = r#"hull {"set":0}"#.parse().unwrap();
    assert_eq!(first, Command::Hull(Which::default()));
}

#[test]
fn nonsense_is_no_command() {
    for text in [
        "",
        "haul",
        "run",
        "run {\"samples\":0,\"inner\":1}",
        "run {\"samples\":1}",
        "load {\"task\":\"hull4\",\"n\":1,\"dimension\":4}",
        "load {\"task\":\"hull2\",\"n\":-1,\"dimension\":2}",
        "load {\"task\":\"hull2\",\"n\":1,\"sets\":0,\"dimension\":2}",
        "hull {\"set\":-1}",
        "hull 1",
    ] {
        assert!(text.parse::<Command>().is_err(), "{text:?}");
    }
}

#[test]
fn a_dimension_that_is_not_the_problems_has_no_size() {
    let mut load = Load {
        task: Problem::Hull3,
        n: 7,
        sets: some(5),
        dimension: 3,
        boundary: Convention::Extreme,
    };
    assert_eq!(load.bytes(), Some(5 * 7 * 3 * 8));
    load.dimension = 2;
    assert_eq!(load.bytes(), None);
}

#[test]
fn a_reply_is_what_was_asked_for_or_a_refusal() {
    let read = |text| serde_json::from_str::<Reply<Loaded>>(text).ok();
    let loaded = |loaded, sets| {
        let sets = some(sets);
        Some(Reply::Done(Loaded { loaded, sets }))
    };
    assert_eq!(read(r#"{"loaded":5}"#), loaded(5, 1));
    assert_eq!(read(r#"{"loaded":5,"sets":3}"#), loaded(5, 3));
    let refused = "no room".to_owned();
    assert_eq!(
        read(r#"{"refused":"no room"}"#),
        Some(Reply::Refused { refused })
    );
    assert_eq!(read(r#"{"nanoseconds":[1]}"#), None);
    assert_eq!(read("loaded"), None);
}
