//! Scenes that programs describe instead of running them.

use super::Examined;
use crate::{Common, Failure};
use mps_io::scene_file::{Output, PressureForm, SceneFile, Source, parse};

/// Prints the scene file that is the run of a `program` with its options, after it has passed what `mps check` asks for.
///
/// What is written follows from the flags that all programs have: the directory of `--out`, and nothing but probes and plots with `--no-fields`.
/// Threads and precision are flags of every run; a comment at the head of the file says which precision it was.
///
/// # Errors
/// If the scene cannot be run as a scene file, with the reason.
pub fn print_scene(program: &str, mut scene: SceneFile, common: &Common) -> Result<(), Failure> {
    let output = &mut scene.output;
    output.directory = common.out.as_ref().map(|dir| dir.display().to_string());
    if common.no_fields {
        let never = Some(0.0);
        let Output { frame_interval, field_interval, picture_interval, .. } = output;
        (*frame_interval, *field_interval, *picture_interval) = (never, never, never);
    }
    let text = scene.to_toml()?;
    let source = Source::new(format!("the scene of {program}"), text.as_str());
    Examined::new(parse(&source)?, &source)?.without_refusals()?;
    say(&format!(
        "# What `{program}` runs with the options this was printed with: mps run FILE --precision {}\n{text}",
        common.precision.name()
    ));
    Ok(())
}

/// The form of the pressure as scene files say it.
pub fn form_of(form: mps_fluid::PressureForm) -> PressureForm {
    match form {
        mps_fluid::PressureForm::Plain => PressureForm::Plain,
        mps_fluid::PressureForm::Corrected => PressureForm::Corrected,
    }
}

#[allow(clippy::print_stdout, reason = "a program talks to its user")]
fn say(text: &str) {
    print!("{text}");
}
