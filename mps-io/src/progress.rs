//! How far a run is and when it will be done.

use crate::number;
use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Redraws a second on a terminal.
const REDRAW: Duration = Duration::from_millis(150);
/// Without a terminal (a log file, a batch system) a line this often is enough.
const LINE: Duration = Duration::from_secs(10);
/// Positions of the bar: simulated time is no whole number.
const TICKS: u64 = 1000;

/// A progress bar on standard error: simulated time, steps a second, time left.
///
/// On a terminal it is one line that is redrawn; otherwise a line every ten seconds. If it is quiet
/// nothing is printed. `update` may be called in every step: most calls only look at the clock.
pub struct Progress {
    display: Shown,
    end_time: f64,
    started: Instant,
    drawn: Option<Instant>,
    rate: Rate,
}

enum Shown {
    Bar(ProgressBar),
    Lines,
    Nothing,
}

impl Progress {
    /// Progress towards `end_time` (s) of simulated time; the clock starts now.
    pub fn new(quiet: bool, end_time: f64) -> Self {
        let display = if quiet {
            Shown::Nothing
        } else if std::io::stderr().is_terminal() {
            Shown::Bar(bar())
        } else {
            Shown::Lines
        };
        Self { display, end_time, started: Instant::now(), drawn: None, rate: Rate::default() }
    }

    /// Tells the simulated `time` (s), the number of `steps` so far and the time step `dt` (s).
    ///
    /// `extra` is shown at the end and only formatted when it is: pass `format_args!(...)` or `""`.
    pub fn update(&mut self, time: f64, steps: u64, dt: f64, extra: impl Display) {
        let pause = match self.display {
            Shown::Bar(_) => REDRAW,
            Shown::Lines => LINE,
            Shown::Nothing => return,
        };
        let now = Instant::now();
        let wall = now.duration_since(self.started).as_secs_f64();
        let Some(drawn) = self.drawn else {
            // The first call only sets the start: there is no speed to show yet, and a continued run
            // does not begin at 0.
            self.drawn = Some(now);
            self.rate.observe(wall, time, steps);
            return;
        };
        if now.duration_since(drawn) >= pause {
            self.drawn = Some(now);
            self.rate.observe(wall, time, steps);
            self.show(&self.text(time, dt, &extra), time);
        }
    }

    /// Shows the end of the run, whether `time` is the end time or the run stopped before.
    pub fn finish(&mut self, time: f64, steps: u64) {
        let wall = self.wall_seconds();
        let text = format!(
            "t = {} s of {} s, {steps} steps in {}, {:.0} steps/s",
            number(time, 4, self.end_time),
            number(self.end_time, 4, self.end_time),
            clock(wall),
            steps as f64 / wall.max(1e-9)
        );
        self.show(&text, time);
        if let Shown::Bar(bar) = &self.display {
            bar.abandon();
        }
    }

    /// Seconds since the start.
    pub fn wall_seconds(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }

    fn text(&self, time: f64, dt: f64, extra: &dyn Display) -> String {
        let left = match self.rate.seconds_left(time, self.end_time) {
            Some(seconds) => clock(seconds),
            None => "--:--".to_owned(),
        };
        let Self { end_time, rate, .. } = self;
        // The most wanted comes first: a narrow terminal cuts the end off.
        let mut text = format!(
            "{left} left  t = {} of {} s  {:.0} steps/s  dt = {dt:.1e} s",
            number(time, 4, *end_time),
            number(*end_time, 4, *end_time),
            rate.steps_per_second
        );
        let extra = extra.to_string();
        if !extra.is_empty() {
            text += "  ";
            text += &extra;
        }
        text
    }

    fn show(&self, text: &str, time: f64) {
        match &self.display {
            Shown::Bar(bar) => {
                let share = (time / self.end_time).clamp(0.0, 1.0);
                bar.set_message(text.to_owned());
                bar.set_position((share * TICKS as f64) as u64);
                bar.tick();
            }
            Shown::Lines => {
                let percent = (100.0 * time / self.end_time).clamp(0.0, 100.0);
                // A closed pipe must not end a simulation.
                let _ = writeln!(std::io::stderr(), "{percent:5.1} %  {text}");
            }
            Shown::Nothing => {}
        }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(TICKS), ProgressDrawTarget::stderr_with_hz(10));
    // The default style shows less but is no reason to stop.
    if let Ok(style) = ProgressStyle::with_template("{bar:16.cyan/blue} {percent:>3} %  {wide_msg}") {
        bar.set_style(style.progress_chars("━╸─"));
    }
    bar
}

/// Speeds, averaged so that the last half minute counts most: time steps change during a run.
#[derive(Debug, Default)]
struct Rate {
    last: Option<(f64, f64, u64)>,
    simulated_per_second: f64,
    steps_per_second: f64,
}

impl Rate {
    const MEMORY: f64 = 30.0;

    /// At `wall` seconds the run was at `time` after `steps`.
    fn observe(&mut self, wall: f64, time: f64, steps: u64) {
        let Some((wall_before, time_before, steps_before)) = self.last else {
            self.last = Some((wall, time, steps));
            return;
        };
        let elapsed = wall - wall_before;
        if elapsed <= 0.0 {
            return;
        }
        let simulated = (time - time_before) / elapsed;
        let stepped = steps.saturating_sub(steps_before) as f64 / elapsed;
        // The first interval is all there is; later ones weigh by their length.
        let weight = if self.steps_per_second == 0.0 { 1.0 } else { 1.0 - (-elapsed / Self::MEMORY).exp() };
        self.simulated_per_second += weight * (simulated - self.simulated_per_second);
        self.steps_per_second += weight * (stepped - self.steps_per_second);
        self.last = Some((wall, time, steps));
    }

    fn seconds_left(&self, time: f64, end_time: f64) -> Option<f64> {
        let left = (end_time - time).max(0.0) / self.simulated_per_second;
        left.is_finite().then_some(left)
    }
}

/// `0:42`, `12:05`, `3:10:00`, `2 d 04:00`.
fn clock(seconds: f64) -> String {
    let s = seconds.max(0.0).round() as u64;
    let (days, hours, minutes, s) = (s / 86_400, s / 3600 % 24, s / 60 % 60, s % 60);
    match (days, hours) {
        (0, 0) => format!("{minutes}:{s:02}"),
        (0, _) => format!("{hours}:{minutes:02}:{s:02}"),
        _ => format!("{days} d {hours:02}:{minutes:02}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_left_of_a_steady_and_of_a_continued_run() {
        let mut rate = Rate::default();
        assert_eq!(rate.seconds_left(0.0, 1.0), None);
        for k in 0..100u32 {
            // Continued at 5 s; 0.01 s of simulated time and 50 steps a second.
            rate.observe(f64::from(k), 5.0 + 0.01 * f64::from(k), 1000 + 50 * u64::from(k));
        }
        let left = rate.seconds_left(5.99, 8.99).unwrap();
        assert!((left - 300.0).abs() < 1e-6, "{left}");
        assert!((rate.steps_per_second - 50.0).abs() < 1e-9);
    }

    #[test]
    fn a_smaller_time_step_lengthens_the_estimate_within_a_minute() {
        let mut rate = Rate::default();
        let mut time = 0.0;
        for k in 0..200u32 {
            rate.observe(f64::from(k), time, u64::from(k));
            time += if k < 100 { 0.1 } else { 0.01 };
        }
        let left = rate.seconds_left(0.0, 1.0).unwrap();
        assert!((50.0..101.0).contains(&left), "{left}");
    }

    #[test]
    fn clocks() {
        let texts = [0.2, 42.0, 725.0, 11_400.0, 187_200.0].map(clock);
        assert_eq!(texts, ["0:00", "0:42", "12:05", "3:10:00", "2 d 04:00"]);
    }

    #[test]
    fn a_quiet_run_never_formats() {
        struct Loud;
        impl Display for Loud {
            fn fmt(&self, _: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                panic!("formatted")
            }
        }
        let mut progress = Progress::new(true, 1.0);
        progress.update(0.5, 10, 0.05, Loud);
        progress.finish(1.0, 20);
    }
}
