//! Triangles from STL, binary or text.

use super::line::Fault;
use super::triangle::Triangle;

/// Bytes before the triangles of a binary file, the last four of which are their number, and bytes of one.
const HEADER: usize = 84;
const RECORD: usize = 50;

const WANTED: &str = "give an STL surface, binary or text, as programs that draw solids write it";

/// The triangles of a file. Binary files are known by their length: some begin with `solid` as those of text do.
pub(super) fn parse(bytes: &[u8]) -> Result<Vec<Triangle>, Fault> {
    let count = bytes.get(HEADER - 4..HEADER).and_then(|four| four.try_into().ok()).map(u32::from_le_bytes);
    match count {
        Some(count) if bytes.len() as u64 == HEADER as u64 + RECORD as u64 * u64::from(count) => {
            let records = bytes[HEADER..].chunks_exact(RECORD).enumerate();
            records.map(|(k, record)| binary(k, record)).collect()
        }
        _ if bytes.trim_ascii_start().starts_with(b"solid") => {
            let text = std::str::from_utf8(bytes).map_err(|_| cut_short(bytes.len()))?;
            from_text(text)
        }
        Some(_) => Err(cut_short(bytes.len())),
        None => Err(("is no STL".to_owned(), WANTED)),
    }
}

fn cut_short(length: usize) -> Fault {
    (
        format!("is no STL: its {length} bytes are neither text nor as many as it says it has triangles"),
        WANTED,
    )
}

/// Three corners of three numbers each, behind a normal that says nothing the order of the corners does not.
fn binary(k: usize, record: &[u8]) -> Result<Triangle, Fault> {
    let number = |at: usize| {
        let four = record.get(at..at + 4).and_then(|four| four.try_into().ok()).unwrap_or([0; 4]);
        f64::from(f32::from_le_bytes(four))
    };
    let corners = [12, 24, 36].map(|at| [number(at), number(at + 4), number(at + 8)]);
    if corners.iter().flatten().all(|x| x.is_finite()) {
        Ok(corners.into())
    } else {
        Err((format!("has a corner that is no number in triangle {}", k + 1), WANTED))
    }
}

fn from_text(text: &str) -> Result<Vec<Triangle>, Fault> {
    let (mut triangles, mut corners) = (Vec::new(), Vec::new());
    for (k, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("vertex") => {
                let numbers: Option<Vec<f64>> =
                    words.map(|word| word.parse().ok().filter(|x: &f64| x.is_finite())).collect();
                let Some(&[x, y, z]) = numbers.as_deref() else {
                    return Err((format!("has a corner without three numbers in line {}", k + 1), WANTED));
                };
                corners.push([x, y, z]);
            }
            Some("endloop") => match corners.as_slice() {
                &[a, b, c] => {
                    triangles.push([a, b, c].into());
                    corners.clear();
                }
                _ => {
                    let what =
                        format!("has {} corners instead of three before line {}", corners.len(), k + 1);
                    return Err((what, WANTED));
                }
            },
            _ => {}
        }
    }
    if corners.is_empty() { Ok(triangles) } else { Err(("ends within a triangle".to_owned(), WANTED)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 3]; 3] = [[0.0, 0.5, 0.0], [1.0, 0.0, -2.0], [0.25, 1.0, 0.0]];
    const TEXT: &str = "solid\nfacet normal 0 0 1\n outer loop\n  vertex 0 .5 0\n  vertex 1 0 -2e0\n  vertex 0.25 1 0\n endloop\n\
                        endfacet\nendsolid\n";

    /// A binary file that begins as text does.
    fn binary(numbers: &[f32]) -> Vec<u8> {
        let mut bytes = b"solid but binary".to_vec();
        bytes.resize(80, 0);
        bytes.extend(1_u32.to_le_bytes());
        bytes.extend([0; 12]);
        bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
        bytes
    }

    #[test]
    fn both_forms_have_the_same_triangles() {
        let numbers = CORNERS.as_flattened().iter().map(|x| *x as f32).collect::<Vec<_>>();
        assert_eq!(parse(TEXT.as_bytes()).unwrap(), [CORNERS.into()]);
        assert_eq!(parse(&binary(&numbers)).unwrap(), [CORNERS.into()]);
    }

    #[test]
    fn what_is_no_surface_is_told_with_its_place() {
        let fault = |bytes: &[u8]| parse(bytes).unwrap_err().0;
        assert_eq!(fault(b"0 0\n1 0\n"), "is no STL");
        assert_eq!(
            fault(TEXT.replace("1 0 -2e0", "1 0 x").as_bytes()),
            "has a corner without three numbers in line 5"
        );
        // A word between numbers is no number that could be left out.
        for corner in ["1 x 0 -2e0", "1 nan 0 -2e0"] {
            assert_eq!(
                fault(TEXT.replace("1 0 -2e0", corner).as_bytes()),
                "has a corner without three numbers in line 5"
            );
        }
        assert_eq!(
            fault(TEXT.replace("  vertex 0 .5 0\n", "").as_bytes()),
            "has 2 corners instead of three before line 6"
        );
        assert_eq!(fault(TEXT.split("endloop").next().unwrap().as_bytes()), "ends within a triangle");
        assert_eq!(fault(&binary(&[f32::NAN; 9])), "has a corner that is no number in triangle 1");
        let mut short = binary(&[0.0; 9]);
        short[0] = b'x';
        short.pop();
        assert_eq!(
            fault(&short),
            "is no STL: its 133 bytes are neither text nor as many as it says it has triangles"
        );
    }
}
