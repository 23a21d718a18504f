//! A closed line from text: x and y of a corner in every line, parted by space or a comma; `#` begins a comment.

use super::super::region::Point;

/// What is wrong with a file: words that follow its name, and what to do.
pub(super) type Fault = (String, &'static str);

/// Corners with the numbers of their lines in the file.
type Corner = (usize, [f64; 2]);

/// The corners of a closed line that does not cross itself. The last one may be the first again.
pub(super) fn parse(bytes: &[u8], place: impl Fn([f64; 2]) -> [f64; 2]) -> Result<Vec<Point>, Fault> {
    let wanted = "give x and y of a corner in every line of text; surfaces (STL) are for three dimensions";
    let text = std::str::from_utf8(bytes).map_err(|_| ("is no text".to_owned(), wanted))?;
    let mut corners: Vec<Corner> = Vec::new();
    for (k, line) in text.lines().enumerate() {
        let content = line.split('#').next().unwrap_or_default();
        let words = content.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty());
        let numbers: Option<Vec<f64>> =
            words.map(|word| word.parse().ok().filter(|x: &f64| x.is_finite())).collect();
        match numbers.as_deref() {
            Some([]) => {}
            Some(&[x, y]) => corners.push((k + 1, place([x, y]))),
            _ => return Err((format!("has {:?} in line {}", short(line), k + 1), wanted)),
        }
    }
    if corners.len() > 1 && corners.first().map(|c| c.1) == corners.last().map(|c| c.1) {
        corners.pop();
    }
    if corners.len() < 3 {
        return Err((format!("has {} corners", corners.len()), "give at least 3"));
    }
    match twice(&corners).or_else(|| crossing(&corners)) {
        Some(fault) => Err(fault),
        None => Ok(corners.into_iter().map(|(_, corner)| corner.to_vec()).collect()),
    }
}

/// The beginning of a line.
fn short(line: &str) -> String {
    line.chars().take(40).collect()
}

/// A corner in the place of the one before.
fn twice(corners: &[Corner]) -> Option<Fault> {
    let (line, _) = pairs(corners).find(|(a, b)| a.1 == b.1)?.1;
    Some((format!("has the corner of line {line} twice"), "leave one of the two out"))
}

/// Where the line crosses or touches itself.
fn crossing(corners: &[Corner]) -> Option<Fault> {
    let sides: Vec<(Corner, Corner)> = pairs(corners).collect();
    for (k, a) in sides.iter().enumerate() {
        // The next side, and before the first the last, share a corner with this one.
        let last = if k == 0 { sides.len() - 1 } else { sides.len() };
        for b in sides.iter().take(last).skip(k + 2) {
            if cross([a.0.1, a.1.1], [b.0.1, b.1.1]) {
                let [x, y] = b.0.1;
                let what = format!(
                    "crosses itself: the side that begins in line {} meets the one of line {}, from ({x:.4}, {y:.4})",
                    a.0.0, b.0.0
                );
                return Some((what, "give the corners in their order along the line"));
            }
        }
    }
    None
}

/// Each corner and the next.
fn pairs(corners: &[Corner]) -> impl Iterator<Item = (Corner, Corner)> {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// Whether two sides have a point in common: the ends of each are on different sides of the other.
fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let apart = |axis: usize| {
        a[axis].max(b[axis]) < c[axis].min(d[axis]) || c[axis].max(d[axis]) < a[axis].min(b[axis])
    };
    let side =
        |p: [f64; 2], q: [f64; 2], r: [f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    let parted = side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0;
    parted && !apart(0) && !apart(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<Point>, Fault> {
        parse(text.as_bytes(), |[x, y]| [2.0 * x, y + 1.0])
    }

    #[test]
    fn corners_are_read_scaled_and_moved_and_the_last_may_be_the_first() {
        let text = "# a wedge\n0 0\n1.5, 0 # right\n\n 1.5e0\t1\n0 0\n";
        assert_eq!(read(text).unwrap(), [[0.0, 1.0], [3.0, 1.0], [3.0, 2.0]].map(Vec::from));
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (text, what) in [
            ("0 0\n1 0\n1 x\n", "has \"1 x\" in line 3"),
            ("0 0\n1 0 2\n", "has \"1 0 2\" in line 2"),
            ("0 0\n1 nan\n", "has \"1 nan\" in line 2"),
            ("0 0\n1 0\n", "has 2 corners"),
            ("0 0\n1 0\n1 0\n1 1\n", "has the corner of line 3 twice"),
            (
                "0 0\n1 1\n\n1 0\n0 1\n",
                "crosses itself: the side that begins in line 1 meets the one of line 4, from (2.0000, 1.0000)",
            ),
        ] {
            assert_eq!(read(text).unwrap_err().0, what);
        }
        assert_eq!(parse(&[0xff, 0xfe], |p| p).unwrap_err().0, "is no text");
    }
}
