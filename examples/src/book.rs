//! The Rust blocks of the book compile and do what is said of them: each page is a doc test.

/// The front page.
#[doc = include_str!("../../README.md")]
struct FrontPage;

/// The first five minutes.
#[doc = include_str!("../../docs/getting-started.md")]
struct GettingStarted;

/// Runs that go on.
#[doc = include_str!("../../docs/restart.md")]
struct Restart;

/// What can be added from outside.
#[doc = include_str!("../../docs/extending.md")]
struct Extending;
