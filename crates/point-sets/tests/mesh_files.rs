//! Meshes through every format, and every error with its place.

use point_sets::mesh_file::{MeshFormat, PolygonMesh, read_mesh};
use point_sets::{Spec, fingerprint};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use tempfile::TempDir;

const FORMATS: [(MeshFormat, &str); 4] = [
    (MeshFormat::Off, "off"),
    (MeshFormat::Obj, "obj"),
    (MeshFormat::Ply, "ply"),
    (MeshFormat::PlyText, "ply"),
];

fn written(mesh: &PolygonMesh, format: MeshFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    mesh.write(&mut bytes, format).unwrap();
    bytes
}

/// What reading a file with this extension and content gives; the message without the name of the folder.
fn read(extension: &str, content: &[u8]) -> Result<PolygonMesh, String> {
    read_in(&tempfile::tempdir().unwrap(), extension, content)
}

fn read_in(folder: &TempDir, extension: &str, content: &[u8]) -> Result<PolygonMesh, String> {
    let path = folder.path().join(format!("m.{extension}"));
    std::fs::write(&path, content).unwrap();
    read_mesh(&path).map_err(|error| {
        let folder = format!("{}/", folder.path().display());
        error.to_string().replace(&folder, "")
    })
}

/// A pyramid over a polygon of so many corners, with coordinates of every size.
fn pyramid(corners: u32) -> PolygonMesh {
    let mut points = "cauchy3"
        .parse::<Spec>()
        .unwrap()
        .generate3(corners as usize, 3)
        .unwrap();
    points[0] = [f64::MAX, -0.0, 5e-324];
    points.push([0.1, 1.0 / 3.0, -1e-300]);
    let walls = (0..corners).map(|i| vec![i, (i + 1) % corners, corners]);
    let base = (0..corners).rev().collect();
    let polygons = walls.chain([base]).collect();
    PolygonMesh { points, polygons }
}

#[test]
fn meshes_come_back_to_the_bit() {
    for corners in [3, 7, 300] {
        let mesh = pyramid(corners);
        for (format, extension) in FORMATS {
            let back = read(extension, &written(&mesh, format)).unwrap();
            assert_eq!(
                fingerprint(&back.points),
                fingerprint(&mesh.points),
                "{format:?}"
            );
            assert_eq!(back.polygons, mesh.polygons, "{format:?}");
        }
    }
    for (format, extension) in FORMATS {
        let empty = PolygonMesh::default();
        assert_eq!(
            read(extension, &written(&empty, format)).unwrap(),
            empty,
            "{format:?}"
        );
    }
}

#[test]
fn meshes_of_others_are_read() {
    let triangle = PolygonMesh {
        points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]],
        polygons: vec![vec![0, 1, 2]],
    };
    for (extension, content) in [
        (
            "off",
            "\u{feff}OFF\r\n# a comment\r\n\r\n3 1 0 # counts\r\n0 0 0\r\n1 0 0\r\n0 1 .5\r\n3  0 1 2  255 0 0\r\n",
        ),
        ("OFF", "OFF 3 1 3\n0 0 0\n1 0 0\n0 1 5e-1\n3 0 1 2"),
        (
            "off",
            "COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0.5 1 1 1 1\n3 0 1 2\n",
        ),
        ("off", "3\n3 1 3\n0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2\n"),
        (
            "obj",
            "mtllib a.mtl\no tri\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0.5 # last\nvn 0 0 1\nl 1 2\nf 1/1/1 2//1 -1\n",
        ),
        (
            "ply",
            "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty uchar red\nproperty float z\n\
             property list uchar float w\nproperty float x\nproperty int y\nelement edge 1\nproperty int a\n\
             element face 1\nproperty list uchar uint vertex_index\nproperty uchar red\nend_header\n\
             9 0 0 0 0\n9 0 2 7 7 1 0\n9 0.5 1 7 0 1\n77\n3 0 1 2 255\n",
        ),
    ] {
        let mesh = read(extension, content.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(mesh, triangle, "{content}");
    }
}

#[test]
fn big_endian_bodies_are_read() {
    let mut content = b"ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty short y\n\
        property double z\nelement face 1\nproperty list ushort char vertex_indices\nend_header\n"
        .to_vec();
    for (x, y, z) in [
        (0.5_f32, 1_i16, 2.0_f64),
        (1.5, -2, 0.1),
        (2.5, 300, -1e300),
    ] {
        content.extend(x.to_be_bytes());
        content.extend(y.to_be_bytes());
        content.extend(z.to_be_bytes());
    }
    content.extend([0, 3, 2, 1, 0]);
    let mesh = read("ply", &content).unwrap();
    assert_eq!(
        mesh.points,
        [[0.5, 1.0, 2.0], [1.5, -2.0, 0.1], [2.5, 300.0, -1e300]]
    );
    assert_eq!(mesh.polygons, [[2, 1, 0]]);
    content.pop();
    let length = content.len();
    let error = read("ply", &content).unwrap_err();
    assert_eq!(
        error,
        format!("m.ply: byte {length}: the file ends where a corner is expected")
    );
}

#[test]
fn every_error_has_its_place() {
    for (extension, content, expected) in [
        ("off", "", "1:1: the file ends where OFF is expected"),
        ("off", "PLY\n", "1:1: \"PLY\" where OFF is expected"),
        (
            "off",
            "OFF BINARY\n",
            "1:5: binary OFF cannot be read; save it as text",
        ),
        (
            "off",
            "OFF\n",
            "2:1: the file ends where the number of points is expected",
        ),
        (
            "off",
            "OFF\n3 x 0\n",
            "2:3: \"x\" where the number of polygons is expected",
        ),
        (
            "off",
            "OFF\n2 0 0\n0 0 0\n0 0\n",
            "4:4: the line ends where a coordinate is expected",
        ),
        (
            "off",
            "OFF\n2 0 0\n0 0 0\n",
            "4:1: the file ends where a point is expected",
        ),
        (
            "off",
            "OFF\n1 0 0\n0 nan 0\n",
            "3:3: \"nan\" is not finite; every coordinate must be",
        ),
        (
            "off",
            "OFF\n1 0 0\n0 1e999 0\n",
            "3:3: \"1e999\" is not finite; every coordinate must be",
        ),
        (
            "off",
            "OFF\n1 0 0\n0 1,5 0\n",
            "3:3: \"1,5\" where a coordinate is expected",
        ),
        (
            "off",
            "OFF\n1 1 0\n0 0 0\n3 0 0 1\n",
            "4:7: corner 1 is none of the 1 points",
        ),
        (
            "off",
            "OFF\n1 1 0\n0 0 0\n3 0 0 -1\n",
            "4:7: corner -1 is none of the 1 points",
        ),
        (
            "off",
            "OFF\n1 1 0\n0 0 0\n  2 0 0\n",
            "4:1: a polygon of 2 corners; a polygon has at least three",
        ),
        (
            "off",
            "OFF\n1 1 0\n0 0 0\n99999999999999 0 0\n",
            "4:19: the line ends where a corner is expected",
        ),
        (
            "obj",
            "v 0 0 0\n\nf 1 1 2\n",
            "3:7: corner 2 is none of the 1 points",
        ),
        (
            "obj",
            "v 0 0 0\nf 1 1 0\n",
            "2:7: corner 0 is none of the 1 points",
        ),
        (
            "obj",
            "v 0 0 0\nf 1 1 -2/4\n",
            "2:7: corner -2/4 is none of the 1 points",
        ),
        (
            "obj",
            "v 0 0 0\nf 1 x/2 1\n",
            "2:5: \"x/2\" where a corner is expected",
        ),
        (
            "obj",
            "v 0 0 0\nf 1 1\n",
            "2:1: a polygon of 2 corners; a polygon has at least three",
        ),
        ("ply", "plx\n", "1:1: \"plx\" where ply is expected"),
        (
            "ply",
            "ply\nformat text 1.0\n",
            "2:8: \"text\" where ascii, binary_little_endian or binary_big_endian is expected",
        ),
        (
            "ply",
            "ply\nformat ascii 1.0\nproperty int x\n",
            "3:1: \"property\" where an element, a property or end_header is expected",
        ),
        (
            "ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n",
            "4:10: \"half\" where a type is expected",
        ),
        (
            "ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n",
            "3:1: an element vertex without x, y and z cannot be read; give it these properties",
        ),
        (
            "ply",
            "ply\nformat binary_little_endian 1.0\nelement face 99999999999\nend_header\n",
            "3:1: an element face without properties cannot be read; give it some, or leave it out",
        ),
        (
            "ply",
            "ply\nformat ascii 1.0\nelement vertex 1\n",
            "4:1: the file ends where end_header is expected",
        ),
        (
            "ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nend_header\n1 2\n",
            "8:4: the line ends where a coordinate is expected",
        ),
    ] {
        let error = read(extension, content.as_bytes()).unwrap_err();
        assert_eq!(error, format!("m.{extension}:{expected}"), "{content:?}");
    }
    let error = read("obj", b"v 0 0 0\nv \xff").unwrap_err();
    assert_eq!(
        error,
        "m.obj:2:3: a byte is not UTF-8 text; save the file as text, without compression"
    );
    for extension in ["stl", "xyz"] {
        let error = read(extension, b"").unwrap_err();
        assert!(error.contains("use .off, .obj or .ply"), "{error}");
    }
    let error = read_mesh("no/such.off".as_ref()).unwrap_err().to_string();
    assert!(
        error.starts_with("no/such.off: cannot be read: "),
        "{error}"
    );
}

#[test]
fn stl_holds_triangles_in_single_precision() {
    let mut mesh = pyramid(5);
    mesh.points[0] = [1.0, 0.0, 0.0];
    let bytes = written(&mesh, MeshFormat::Stl);
    let triangles = 5 + 3;
    assert_eq!(bytes.len(), 84 + 50 * triangles);
    assert!(!bytes.starts_with(b"solid"));
    assert_eq!(bytes[80..84], (triangles as u32).to_le_bytes());
    let float = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!(float(84 + 12), 1.0);
    let normal = [0, 4, 8].map(|step| float(84 + step));
    assert!((normal.iter().map(|c| c * c).sum::<f32>() - 1.0).abs() < 1e-5);
    assert_eq!(mesh.rounded_in_stl(), 5);
    mesh.points[0] = [1e300, 0.0, 0.0];
    assert!(mesh.write(Vec::new(), MeshFormat::Stl).is_err());
}

/// Files spoilt at random: no panic, no endless loop.
#[test]
fn spoilt_files_are_read_or_refused() {
    let mut words = ChaCha8Rng::seed_from_u64(17);
    let mut below = |bound: usize| words.next_u64() as usize % bound;
    let mesh = pyramid(6);
    let folder = tempfile::tempdir().unwrap();
    let mut refused = 0;
    for (format, extension) in FORMATS {
        let sound = written(&mesh, format);
        for _ in 0..400 {
            let mut content = sound.clone();
            for _ in 0..1 + below(3) {
                let at = below(content.len());
                match below(3) {
                    0 => content[at] = below(256) as u8,
                    1 => drop(content.remove(at)),
                    _ => content.insert(at, b"0123456789-. \nef"[below(16)]),
                }
            }
            refused += usize::from(read_in(&folder, extension, &content).is_err());
        }
    }
    assert!((400..1600).contains(&refused), "{refused}");
}

/// The time to read a line is linear in its length: characters are counted only for messages.
#[test]
fn long_polygons_are_read() {
    let corners = 300_000;
    let points = vec![[0.5, 0.25, 0.125]; corners];
    let mesh = PolygonMesh {
        points,
        polygons: vec![(0..corners as u32).collect()],
    };
    for (format, extension) in FORMATS {
        let back = read(extension, &written(&mesh, format)).unwrap();
        assert_eq!(back.polygons, mesh.polygons, "{format:?}");
    }
}
