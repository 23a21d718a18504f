//! Headings of the columns of probes, and what is named after them.

use super::units::{self, each_axis};
use mps_io::scene_file::{LineQuantity, Measure, Probe, SceneFile};

/// Headings of the columns of a probe.
pub(super) fn columns<const D: usize>(Probe { name, measure }: &Probe) -> Vec<String> {
    match measure {
        Measure::Pressure(_) | Measure::WallPressure(_) => vec![format!("{name} [Pa]")],
        Measure::Velocity(_) => each_axis::<D>(name, "m/s").collect(),
        Measure::Line(line) => {
            let numbered = (1..=line.points).map(|k| format!("{name} {k}"));
            match line.of {
                LineQuantity::Pressure => numbered.map(|name| format!("{name} [Pa]")).collect(),
                LineQuantity::Velocity => {
                    numbered.flat_map(|name| each_axis::<D>(&name, "m/s").collect::<Vec<_>>()).collect()
                }
            }
        }
        Measure::Front(_) | Measure::Level(_) => vec![format!("{name} [m]")],
        Measure::Displacement(_) => each_axis::<D>(name, "m").collect(),
        Measure::Force(_) => each_axis::<D>(name, units::force::<D>()).collect(),
        Measure::Budget(_) => {
            let (linear, turning) = (format!("{name} impulse"), format!("{name} angular impulse"));
            let unit = units::angular_impulse::<D>();
            let angular = match D {
                2 => vec![format!("{turning} [{unit}]")],
                _ => each_axis::<D>(&turning, unit).collect(),
            };
            let work = format!("{name} work [{}]", units::energy::<D>());
            each_axis::<D>(&linear, units::impulse::<D>()).chain(angular).chain([work]).collect()
        }
    }
}

/// A heading without its unit, by which the summary calls its numbers.
pub(super) fn bare(heading: &str) -> &str {
    heading.rsplit_once(" [").map_or(heading, |(name, _)| name)
}

/// What the plot of a column is called, without its ending.
pub(super) fn stem(heading: &str) -> String {
    format!("probe_{}", bare(heading).replace([' ', '/'], "_"))
}

/// The first probe of a scene one of whose columns would have the plot of a probe before it, and with that its name in the summary
/// or the table: the numbers of both probes, and the heading.
pub(super) fn twice<const D: usize>(scene: &SceneFile) -> Option<([usize; 2], String)> {
    let mut known: Vec<(usize, String)> = Vec::new();
    for (k, probe) in scene.probes.iter().enumerate() {
        for heading in columns::<D>(probe) {
            let stem = stem(&heading);
            if let Some((other, _)) = known.iter().find(|(_, known)| *known == stem) {
                return Some(([*other, k], heading));
            }
            known.push((k, stem));
        }
    }
    None
}
