//! The header of a PLY file: which elements there are, and which properties each has.

use super::body::{Body, Endian};
use crate::mesh_file::error::{Failure, MeshPlace, MeshProblem};
use crate::mesh_file::words::{Line, Lines};

/// What a PLY file says it holds.
pub(super) struct Header<'a> {
    pub(super) elements: Vec<Element<'a>>,
}

/// A kind of element.
pub(super) struct Element<'a> {
    pub(super) name: &'a str,
    pub(super) count: usize,
    pub(super) properties: Vec<Property<'a>>,
    place: MeshPlace,
}

/// A property of each element of a kind: one value, or a list of them.
pub(super) struct Property<'a> {
    pub(super) name: &'a str,
    /// The type of the length of a list.
    pub(super) count_type: Option<Scalar>,
    pub(super) value_type: Scalar,
}

/// The types of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Scalar::I8,
            "uchar" | "uint8" => Scalar::U8,
            "short" | "int16" => Scalar::I16,
            "ushort" | "uint16" => Scalar::U16,
            "int" | "int32" => Scalar::I32,
            "uint" | "uint32" => Scalar::U32,
            "float" | "float32" => Scalar::F32,
            "double" | "float64" => Scalar::F64,
            _ => return None,
        })
    }
}

impl<'a> Header<'a> {
    /// The header of `content`, and the body that follows it.
    pub(super) fn read(content: &'a [u8]) -> Result<(Self, Body<'a>), Failure> {
        let end = header_end(content);
        let mut lines = Lines::new(&content[..end], None)?;
        let magic = lines.expect("ply")?.expect("ply")?;
        if magic.text != "ply" {
            return Err(magic.is_not("ply"));
        }
        let endian = format(lines.expect("the format")?)?;
        let mut elements: Vec<Element<'a>> = Vec::new();
        loop {
            let mut line = lines.expect("end_header")?;
            let keyword = line.expect("a keyword")?;
            match (keyword.text, elements.last_mut()) {
                ("end_header", _) => break,
                ("comment" | "obj_info", _) => {}
                ("element", _) => elements.push(Element {
                    name: line.expect("the name of an element")?.text,
                    count: line.number("the number of elements")?,
                    properties: Vec::new(),
                    place: keyword.place(),
                }),
                ("property", Some(element)) => element.properties.push(property(line)?),
                _ => return Err(keyword.is_not("an element, a property or end_header")),
            }
        }
        for element in &elements {
            element.has_properties()?;
        }
        let body = match endian {
            Some(endian) => Body::binary(content, end, endian),
            None => Body::text(content, end)?,
        };
        Ok((Header { elements }, body))
    }

    /// How many elements of this name there are.
    pub(super) fn count_of(&self, name: &str) -> usize {
        let named = self.elements.iter().find(|element| element.name == name);
        named.map_or(0, |element| element.count)
    }
}

impl Element<'_> {
    /// Elements of which there is nothing to read could be as many as a number can say.
    fn has_properties(&self) -> Result<(), Failure> {
        if !self.properties.is_empty() {
            return Ok(());
        }
        let what = format!("an element {} without properties", self.name);
        let remedy = "give it some, or leave it out";
        Err((self.place, MeshProblem::Unsupported { what, remedy }))
    }

    /// Where the properties of these names are among the properties.
    pub(super) fn positions(&self, names: [&'static str; 3]) -> Result<[usize; 3], Failure> {
        let position = |name: &str| {
            let is_value = |p: &Property<'_>| p.name == name && p.count_type.is_none();
            self.properties.iter().position(is_value)
        };
        match names.map(position) {
            [Some(x), Some(y), Some(z)] => Ok([x, y, z]),
            _ => Err((
                self.place,
                MeshProblem::Unsupported {
                    what: format!("an element {} without x, y and z", self.name),
                    remedy: "give it these properties",
                },
            )),
        }
    }
}

impl Property<'_> {
    /// Passes over its value in `body`.
    pub(super) fn skip(&self, body: &mut Body<'_>) -> Result<(), Failure> {
        let count = match self.count_type {
            Some(count_type) => body.index(count_type, "the length of a list")?,
            None => 1,
        };
        for _ in 0..count {
            body.scalar(self.value_type, "a value")?;
        }
        Ok(())
    }
}

/// The order of bytes; `None` for text.
fn format(mut line: Line<'_>) -> Result<Option<Endian>, Failure> {
    let keyword = line.expect("the format")?;
    if keyword.text != "format" {
        return Err(keyword.is_not("the format"));
    }
    let format = line.expect("the format")?;
    match format.text {
        "ascii" => Ok(None),
        "binary_little_endian" => Ok(Some(Endian::Little)),
        "binary_big_endian" => Ok(Some(Endian::Big)),
        _ => Err(format.is_not("ascii, binary_little_endian or binary_big_endian")),
    }
}

fn property<'a>(mut line: Line<'a>) -> Result<Property<'a>, Failure> {
    let first = line.expect("a type")?;
    let (count_type, value) = match first.text {
        "list" => {
            let count = line.expect("a type")?;
            let scalar = Scalar::named(count.text).ok_or_else(|| count.is_not("a type"))?;
            (Some(scalar), line.expect("a type")?)
        }
        _ => (None, first),
    };
    Ok(Property {
        count_type,
        value_type: Scalar::named(value.text).ok_or_else(|| value.is_not("a type"))?,
        name: line.expect("the name of a property")?.text,
    })
}

/// The offset after the line `end_header`, or the end of the content.
fn header_end(content: &[u8]) -> usize {
    let mut end = 0;
    for line in content.split_inclusive(|byte| *byte == b'\n') {
        end += line.len();
        if line.trim_ascii() == b"end_header" {
            break;
        }
    }
    end
}
