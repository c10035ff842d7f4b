//! Files as people have them, and every error with its place and its remedy.

use point_sets::file::{
    Column, Delimiter, FileError, Header, PointFile, ReadOptions, read2, write_csv2,
};
use point_sets::{Spec, fingerprint};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::io::Write;

fn read_bytes(content: &[u8], options: &ReadOptions) -> Result<PointFile, FileError> {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(content).unwrap();
    read2(file.path(), options)
}

#[track_caller]
fn read(content: &str) -> PointFile {
    read_bytes(content.as_bytes(), &ReadOptions::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

fn columns(x: &str, y: &str) -> ReadOptions {
    let column = |text: &str| -> Column { text.parse().unwrap() };
    ReadOptions {
        columns: Some([column(x), column(y)]),
        ..ReadOptions::default()
    }
}

fn header(header: Header) -> ReadOptions {
    ReadOptions {
        header,
        ..ReadOptions::default()
    }
}

/// The message without the name of the temporary file.
#[track_caller]
fn message(content: &[u8], options: &ReadOptions) -> String {
    let error = read_bytes(content, options).expect_err("an error");
    let text = error.to_string();
    let file = format!("{}:", error.path.display());
    text.strip_prefix(&file)
        .unwrap_or_else(|| panic!("{text}"))
        .to_owned()
}

#[test]
fn separators_are_found_out() {
    for (content, delimiter) in [
        ("1,2\n3,4\n", Delimiter::Comma),
        ("1, 2\n 3 ,4", Delimiter::Comma),
        ("1;2\n3;4\n", Delimiter::Semicolon),
        ("1\t2\n3\t4\n", Delimiter::Tab),
        ("1 2\n  3   4  \n", Delimiter::Whitespace),
    ] {
        let file = read(content);
        assert_eq!(file.points, [[1.0, 2.0], [3.0, 4.0]], "{content:?}");
        assert_eq!(file.delimiter, delimiter, "{content:?}");
        assert_eq!(file.header, None, "{content:?}");
    }
}

#[test]
fn marks_line_ends_comments_and_blank_lines() {
    let file = read("\u{feff}# towns\r\n\r\nx,y\r\n// the first\r\n1,2\r\n   \r\n  # more\n3,4");
    assert_eq!(file.points, [[1.0, 2.0], [3.0, 4.0]]);
    assert_eq!(file.rows, [5, 8]);
    assert_eq!(
        file.header.as_deref(),
        Some(&["x".to_owned(), "y".to_owned()][..])
    );
}

#[test]
fn quoted_fields() {
    let file =
        read("name,x,y\n\"Rome, \"\"Roma\"\"\",1,2\n\"two\nlines\",\"3\", \"4\"\nParis,5,6\n");
    assert_eq!(file.points, [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]);
    assert_eq!(file.rows, [2, 3, 5]);
    assert_eq!(read("\"New York\" 1 2\n").points, [[1.0, 2.0]]);
}

#[test]
fn pairs_of_names_are_known() {
    for (content, taken) in [
        ("id,y,x\n7,1,2\n", ["field 3 (x)", "field 2 (y)"]),
        (
            "Latitude;Longitude\n1;2\n",
            ["field 2 (Longitude)", "field 1 (Latitude)"],
        ),
        (
            "name\tlat\tlng\na\t1\t2\n",
            ["field 3 (lng)", "field 2 (lat)"],
        ),
        (
            "Northing (m),Easting (m)\n1,2\n",
            ["field 2 (Easting (m))", "field 1 (Northing (m))"],
        ),
        ("y2,x2,y1,x1\n8,9,1,2\n", ["field 4 (x1)", "field 3 (y1)"]),
        ("2019,y,x\n7,1,2\n", ["field 3 (x)", "field 2 (y)"]),
    ] {
        let file = read(content);
        assert_eq!(
            file.columns.map(|column| column.to_string()),
            taken,
            "{content:?}"
        );
        assert_eq!(file.points, [[2.0, 1.0]], "{content:?}");
    }
}

#[test]
fn else_the_first_two_numeric_columns() {
    let file = read("town,height,depth\nA,1,2\n");
    assert_eq!(file.columns[0].to_string(), "field 2 (height)");
    let file = read("2020-01-31,A,1,2\n2020-02-01,B,3,4\n");
    assert_eq!(file.columns.map(|column| column.number), [3, 4]);
    assert_eq!(file.points.len(), 2);
}

#[test]
fn columns_can_be_chosen() {
    let content = b"a,b,c,B\n1,2,3,4\n";
    for (x, y, point) in [
        ("c", "a", [3.0, 1.0]),
        ("B", "b", [4.0, 2.0]),
        ("C", "A", [3.0, 1.0]),
        ("4", "2", [4.0, 2.0]),
    ] {
        assert_eq!(
            read_bytes(content, &columns(x, y)).unwrap().points,
            [point],
            "{x} {y}"
        );
    }
    assert_eq!(
        read_bytes(b"1,2,3\n", &columns("3", "1")).unwrap().points,
        [[3.0, 1.0]]
    );
    let named_like_numbers = ReadOptions {
        columns: Some(["1990", "2000"].map(|name| Column::Name(name.to_owned()))),
        ..ReadOptions::default()
    };
    let file = read_bytes(b"town,1990,2000\nA,1,2\n", &named_like_numbers).unwrap();
    assert_eq!(file.points, [[1.0, 2.0]]);
}

#[test]
fn a_header_can_be_forced_either_way() {
    let file = read_bytes(b"1990,2000\n1,2\n", &header(Header::Present)).unwrap();
    assert_eq!(file.points, [[1.0, 2.0]]);
    assert_eq!(file.columns[1].to_string(), "field 2 (2000)");
    assert_eq!(read("1990,2000\n1,2\n").points.len(), 2);
    let text = message(b"x,y\n1,2\n", &header(Header::Absent));
    assert!(
        text.starts_with("1:1: \"x,y\" has 0 numeric of 2 fields"),
        "{text}"
    );
}

#[test]
fn decimals_as_rust_reads_them() {
    let file = read("+1,-2.5e-3\n.5,5.\n1E5,-0\n4.9e-324,1.7976931348623157e308\n0.1,1e-400\n");
    let expected = [
        [1.0, -0.0025],
        [0.5, 5.0],
        [1e5, -0.0],
        [5e-324, f64::MAX],
        [0.1, 0.0],
    ];
    assert_eq!(fingerprint(&file.points), fingerprint(&expected));
}

#[test]
fn every_error_has_its_place_and_its_remedy() {
    let plain = ReadOptions::default();
    let cases: &[(&[u8], ReadOptions, &str)] = &[
        (
            b"",
            plain.clone(),
            "1:1: no points: the file is empty, or all comments and blank lines; give one point a line, such \
             as 1.5,2.25",
        ),
        (
            b"# nothing\n\n",
            plain.clone(),
            "2:1: no points: the file is empty, or all comments and blank lines; give one point a line, such \
             as 1.5,2.25",
        ),
        (
            b"x,y\n",
            plain.clone(),
            "1:1: no points: there is a header and nothing else; give one point a line, such as 1.5,2.25",
        ),
        (
            b"x,y\n1,2\n3, 4.5.6\n",
            plain.clone(),
            "3:4: field 2 (y): \"4.5.6\" is not a number; write it as 12.5, -3 or 1e-9, or choose other columns",
        ),
        (
            "näme,x,y\nGößä,1,z\n".as_bytes(),
            plain.clone(),
            "2:8: field 3 (y): \"z\" is not a number; if the line is a header, say that there is one; else \
             choose other columns or correct it",
        ),
        (
            b"1;2\n1,5;2\n",
            plain.clone(),
            "2:1: field 1: \"1,5\" is not a number; write a decimal point, and nothing between thousands",
        ),
        (
            b"1,5;2,5\n3,5;4,5\n",
            plain.clone(),
            "1:1: field 1: \"1,5\" is not a number; write a decimal point, and nothing between thousands",
        ),
        (
            b"1 2\n1.0D+03 2\n",
            plain.clone(),
            "2:1: field 1: \"1.0D+03\" is not a number; write the exponent with e, as in 1e-9",
        ),
        (
            b"x,y\n1,2\nNA,3\n",
            plain.clone(),
            "3:1: field 1 (x): \"NA\" is not a number; it marks a missing value: fill it in or remove the line",
        ),
        (
            b"x,y\n1,\n",
            plain.clone(),
            "2:3: field 2 (y): the value is missing; fill it in or remove the line",
        ),
        (
            b"1,2\n3,NaN\n",
            plain.clone(),
            "2:3: field 2: \"NaN\" is not a finite number; remove the line, or give a value up to 1.797e308",
        ),
        (
            b"1,2\n3,-inf\n",
            plain.clone(),
            "2:3: field 2: \"-inf\" is not a finite number; remove the line, or give a value up to 1.797e308",
        ),
        (
            b"1,2\n1e999,3\n",
            plain.clone(),
            "2:1: field 1: \"1e999\" is not a finite number; remove the line, or give a value up to 1.797e308",
        ),
        (
            b"nan,1\n1,2\n",
            plain.clone(),
            "1:1: field 1: \"nan\" is not a finite number; remove the line, or give a value up to 1.797e308",
        ),
        (
            b"# c\n1,2\n3,4,5\n",
            plain.clone(),
            "3:5: 3 fields where line 2 has 2; separate every line alike, and quote fields that hold the \
             separator \",\"",
        ),
        (
            b"1 2\n3\n",
            plain.clone(),
            "2:2: 1 field where line 1 has 2; separate every line alike, and quote fields that hold the \
             separator \"blank\"",
        ),
        (
            b"x,y\n\"a\nb\",1,2\n",
            plain.clone(),
            "3:6: 3 fields where line 1 has 2; separate every line alike, and quote fields that hold the \
             separator \",\"",
        ),
        (
            b"town,7,z\n",
            plain.clone(),
            "1:1: \"town,7,z\" may be a header or a point, since one of its fields is a number; say which, or \
             correct it",
        ),
        (
            b"a,1,b\n",
            columns("1", "2"),
            "1:1: \"a,1,b\" may be a header or a point, since one of the chosen fields is a number and \
             another is not; say which, or correct it",
        ),
        (
            b"east,west\n1,2\n",
            columns("eest", "west"),
            "1:1: there is no column \"eest\" (did you mean east?); the header has east, west",
        ),
        (
            b"1,2\n",
            ReadOptions {
                header: Header::Absent,
                ..columns("x", "y")
            },
            "1:1: there is no column \"x\"; without a header choose columns by number",
        ),
        (
            b"1,2\n",
            columns("1", "3"),
            "1:1: there is no column 3; choose from 1 to 2, or another separator than \",\"",
        ),
        (
            b"1,2\n",
            columns("0", "1"),
            "1:1: there is no column 0; choose from 1 to 2, or another separator than \",\"",
        ),
        (
            b"a,b\nc,d\n",
            plain.clone(),
            "2:1: \"c,d\" has 0 numeric of 2 fields, and a point needs 2; choose the columns, or the \
             separator (now \",\")",
        ),
        (
            b"x,y\n1,\"2\n3,4\n",
            plain.clone(),
            "2:3: a quote opens here and never closes; close it, or double a quote that belongs to the text",
        ),
        (
            b"x,y\n1,\"2\"3\n",
            plain.clone(),
            "2:6: text follows a closed quote; double a quote that belongs to the text",
        ),
        (
            b"x,y\n\xc3\xa4,\xe4\n",
            plain.clone(),
            "2:3: byte 0xe4 is not UTF-8 text; save the file as UTF-8, without compression",
        ),
        (
            b"\x1f\x8b\x08\x00",
            plain.clone(),
            "1:2: byte 0x8b is not UTF-8 text; save the file as UTF-8, without compression",
        ),
    ];
    for (content, options, expected) in cases {
        assert_eq!(
            message(content, options),
            *expected,
            "{:?}",
            String::from_utf8_lossy(content)
        );
    }
}

#[test]
fn a_file_that_is_not_there() {
    let error = read2("no/such/file.csv".as_ref(), &ReadOptions::default()).unwrap_err();
    assert!(error.place.is_none());
    let text = error.to_string();
    assert!(
        text.starts_with("no/such/file.csv: cannot be opened: "),
        "{text}"
    );
    assert!(
        text.ends_with("; check the name and the permissions"),
        "{text}"
    );
}

#[test]
fn long_fields_are_shown_shortened() {
    let long = "9".repeat(100) + "x";
    let text = message(
        format!("1,2\n1,{long}\n").as_bytes(),
        &ReadOptions::default(),
    );
    assert!(
        text.contains(&format!("{:?}", "9".repeat(40) + "...")),
        "{text}"
    );
    assert!(text.len() < 160, "{text}");
}

#[test]
fn a_quote_never_closed_is_found_without_reading_everything_again_and_again() {
    let mut content = b"x,y\n1,\"2\n".to_vec();
    content.extend(b"3,4\n".repeat(500_000));
    assert!(message(&content, &ReadOptions::default()).starts_with("2:3: a quote opens here"));
}

#[test]
fn written_points_read_back_to_the_bit() {
    for spec in [
        "cauchy",
        "killer",
        "near-collinear",
        "rounded:of=normal,decimals=0",
    ] {
        let points = spec.parse::<Spec>().unwrap().generate(1000, 11).unwrap();
        let mut text = Vec::new();
        write_csv2(&mut text, &points).unwrap();
        let file = read_bytes(&text, &ReadOptions::default()).unwrap();
        assert_eq!(fingerprint(&file.points), fingerprint(&points), "{spec}");
        assert_eq!(file.rows, (2..1002).collect::<Vec<u64>>());
    }
    let extremes = [
        [f64::MAX, f64::MIN],
        [f64::MIN_POSITIVE, 5e-324],
        [-0.0, 0.0],
        [0.1, 1.0 / 3.0],
    ];
    let mut text = Vec::new();
    write_csv2(&mut text, &extremes).unwrap();
    let file = read_bytes(&text, &ReadOptions::default()).unwrap();
    assert_eq!(fingerprint(&file.points), fingerprint(&extremes));
}

/// The splitter against the one of the `csv` crate, on records of random quotes, commas and line ends.
#[test]
fn fields_are_those_of_another_splitter() {
    let noise = "normal"
        .parse::<Spec>()
        .unwrap()
        .generate(4000, 12)
        .unwrap();
    for (round, pair) in noise.chunks(8).enumerate() {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let text = |value: f64| -> String {
            let pieces = ["a", "\"", ",", "\n", " b", ";", "#", "ä"];
            let digits = value.to_bits();
            (0..5)
                .map(|place| pieces[(digits >> (4 * place) & 7) as usize])
                .collect()
        };
        writer.write_record(["name", "x", "y"]).unwrap();
        for [a, b] in pair {
            writer
                .write_record([format!("n{}", text(*a)), b.to_string(), a.to_string()])
                .unwrap();
        }
        let bytes = writer.into_inner().unwrap();
        let file = read_bytes(&bytes, &ReadOptions::default())
            .unwrap_or_else(|error| panic!("{round}: {error}"));
        let mut reader = csv::Reader::from_reader(&bytes[..]);
        for (index, record) in reader.records().enumerate() {
            let record = record.unwrap();
            let point = [1, 2].map(|field| record[field].parse::<f64>().unwrap());
            assert_eq!(file.points[index], point, "{round}");
            assert_eq!(
                file.rows[index],
                record.position().unwrap().line(),
                "{round}"
            );
        }
        assert_eq!(file.points.len(), pair.len());
    }
}

/// Files spoilt at random: no panic, and every error is at a place that the file has.
#[test]
fn spoilt_files_are_read_or_refused_at_a_place_that_exists() {
    let sound = "\u{feff}name,x,y\n\"Rome, Italy\",1.5,2\n# note\n\nÅbo,-3e2,4\r\n\"a\nb\",5,6\n"
        .as_bytes();
    let pieces: [&[u8]; 10] = [
        b"", b"\"", b",", b"\n", b"\r", b"nan", b"\xff", b" ", b"//", b";",
    ];
    let mut words = ChaCha8Rng::seed_from_u64(13);
    let mut below = |bound: usize| words.next_u64() as usize % bound;
    let mut refused = 0;
    for _ in 0..3000 {
        let mut content = sound.to_vec();
        for _ in 0..1 + below(3) {
            let start = below(content.len());
            let end = (start + below(3)).min(content.len());
            content.splice(start..end, pieces[below(pieces.len())].iter().copied());
        }
        match read_bytes(&content, &ReadOptions::default()) {
            Ok(file) => assert_eq!(file.points.len(), file.rows.len()),
            Err(error) => {
                refused += 1;
                let place = error.place.expect("the file could be opened");
                let lines: Vec<_> = content.split(|byte| *byte == b'\n').collect();
                let line = lines[place.line as usize - 1];
                assert!(
                    (1..=line.len() as u64 + 1).contains(&place.column),
                    "{place:?}"
                );
            }
        }
    }
    assert!((1000..2900).contains(&refused), "{refused}");
}
